#include "ramify/compare/interval.hpp"

#include <algorithm>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace ramify {

double simultaneous_sigmas(double chance, std::size_t estimates) {
  const double each = chance / static_cast<double>(std::max<std::size_t>(estimates, 1));
  return boost::math::constants::root_two<double>() * boost::math::erfc_inv(each);
}

}  // namespace ramify
