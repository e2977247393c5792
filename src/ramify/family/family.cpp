#include "ramify/family/family.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/core/find_named.hpp"
#include "ramify/family/all_families.hpp"

namespace ramify {

double SearchScale::of(double x) const {
  switch (kind) {
    case Kind::log_above:
      return std::log(x - low);
    case Kind::logit:
      return std::log((x - low) / (high - x));
    case Kind::plain:
      break;
  }
  return x;
}

double SearchScale::back(double searched) const {
  switch (kind) {
    case Kind::log_above:
      return low + std::exp(searched);
    case Kind::logit:
      return low + (high - low) / (1 + std::exp(-searched));
    case Kind::plain:
      break;
  }
  return searched;
}

double SearchScale::slope(double searched) const {
  switch (kind) {
    case Kind::log_above:
      return std::exp(searched);
    case Kind::logit:
      return (high - low) / (2 + std::exp(searched) + std::exp(-searched));
    case Kind::plain:
      break;
  }
  return 1;
}

std::string_view name_of(Given given) {
  return given == Given::size ? "n" : "order";
}

Model Family::at(std::span<const double> values) const {
  RAMIFY_EXPECTS(values.size() == parameters.size());
  return Model::make(*model, parameters.empty() ? std::span<const double>(fixed) : values);
}

std::vector<double> Family::searched(std::span<const double> values) const {
  std::vector<double> found;
  for (std::size_t i = 0; i < values.size(); ++i) found.push_back(parameters[i].scale.of(values[i]));
  return found;
}

std::vector<double> Family::values(std::span<const double> searched) const {
  std::vector<double> found;
  for (std::size_t i = 0; i < searched.size(); ++i) found.push_back(parameters[i].scale.back(searched[i]));
  return found;
}

std::vector<std::vector<double>> Family::starts() const {
  std::vector<std::vector<double>> all{{}};
  for (const FamilyParameter& parameter : parameters) {
    std::vector<std::vector<double>> longer;
    for (const auto& start : all)
      for (const double value : parameter.starts) {
        longer.push_back(start);
        longer.back().push_back(parameter.scale.of(value));
      }
    all = std::move(longer);
  }
  return all;
}

const std::vector<Family>& all_families() {
  static const std::vector<Family> all{
      patricia_family(), dst_family(),      beta_family(),         beta_multinomial_family(),
      aldous_family(),   ford_family(),     bst_family(),          catalan_family(),
      critical_family(), tokunaga_family(), ramification_family(), ternary_family()};
  return all;
}

std::span<const Family> families() {
  const std::vector<Family>& all = all_families();
  const auto end = std::ranges::find(all, Given::order, &Family::given);
  return {all.begin(), end};
}

const Family& find_family(std::string_view name) {
  return find_named(all_families(), &Family::name, name, "family");
}

}  // namespace ramify
