#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// What a reader passes over, counted, and what it finds doubtful: it fills this in, and whoever asked for
/// the reading says it once.
class Remarks {
 public:
  /// Parts that are not used: "3 rows without a code" is ignore("row", "without a code", 3). Counts of the
  /// same part add up.
  void ignore(std::string_view noun, std::string_view which, std::size_t count = 1);
  /// Parts that have a name: "columns colour, state".
  void ignore_named(std::string_view noun, std::string_view name);
  /// A sentence of its own, said once however often it is found.
  void doubt(std::string sentence);

  bool empty() const { return counted_.empty() && named_.empty() && doubts_.empty(); }
  /// One line each, with the file's name in front: the doubts, then "FILE: ignored: ...". Of many names the
  /// first eight are given.
  std::vector<std::string> lines(std::string_view file) const;

 private:
  struct Counted {
    std::string noun, which;
    std::size_t count;
  };
  struct Named {
    std::string noun;
    std::vector<std::string> names;
  };
  std::vector<Counted> counted_;
  std::vector<Named> named_;
  std::vector<std::string> doubts_;
};

/// "1 row", "3 rows".
std::string counted(std::size_t count, std::string_view noun);

}  // namespace ramify
