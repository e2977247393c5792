#include "support/columns.hpp"

#include <stdexcept>
#include <string>

#include "ramify/statistic/statistic_set.hpp"

namespace ramify::test {

StatisticColumn column(std::string_view name) {
  for (const StatisticColumn& column : StatisticSet::all().columns(9))
    if (column.name() == name) return column;
  throw std::invalid_argument("no column " + std::string(name));
}

}  // namespace ramify::test
