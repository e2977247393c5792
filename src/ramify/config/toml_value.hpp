#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "ramify/core/error.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify::detail {

/// What a key wants, for the error when it gets something else: "a whole number", "seed = 1996".
struct Expected {
  std::string_view what;
  std::string_view example;
};

/// A value in a TOML document with what an error about it has to say: its file, its place, its key.
///
/// A view: the document must outlive it.
class TomlValue {
 public:
  TomlValue(std::string_view file, std::string key, const toml::node& node)
      : file_(file), key_(std::move(key)), node_(&node) {}

  std::string_view file() const { return file_; }
  const std::string& key() const { return key_; }
  SourceLocation where() const;
  [[noreturn]] void fail(std::string_view problem, std::string_view why, std::string_view remedy) const;

  bool is_number() const { return node_->is_number(); }
  bool is_table() const { return node_->is_table(); }

  // Each throws Error with the place where the value is of another type or outside the range.
  std::string text(const Expected& expected) const;
  bool boolean(const Expected& expected) const;
  /// An integer, or a float with a whole value (1e6).
  std::uint64_t whole(std::uint64_t least, std::uint64_t most, const Expected& expected) const;
  /// A number, or a string that holds a number or a fraction ("1/0.23").
  double real(const Expected& expected) const;
  /// The elements of an array that is not empty.
  std::vector<TomlValue> elements(const Expected& expected) const;
  const toml::table& table(const Expected& expected) const;

 private:
  [[noreturn]] void fail_type(const Expected& expected) const;

  std::string_view file_;
  std::string key_;
  const toml::node* node_;
};

/// What make() gives; an Error that it throws gets the place of the value.
template <class Make>
auto at_place(const TomlValue& value, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    throw located(error, value.where());
  }
}

/// A table whose keys are all known.
class TomlTable {
 public:
  TomlTable(std::string_view file, const toml::table& table) : file_(file), table_(&table) {}

  /// Throws Error at the first key that is not in the list, naming the nearest that is.
  /// @param owner  "a config", "n"
  void require_known(std::string_view owner, std::span<const std::string_view> keys) const;

  std::optional<TomlValue> find(std::string_view key) const;
  /// All values, in the order of the file.
  std::vector<TomlValue> values() const;

 private:
  std::string_view file_;
  const toml::table* table_;
};

/// Parses a document. Throws Error with the place of a syntax error.
toml::table parse_toml(std::string_view text, std::string_view name);

}  // namespace ramify::detail
