#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ramify/io/table.hpp"

namespace ramify {

// JSON as text, since a JSON library prints a double with up to 17 digits, and a long list on as many lines.

/// At most 10 significant digits; null where it is not finite.
std::string json_number(double value);

/// [1, 2, 3]
std::string json_list(const std::vector<std::string>& items);

/// Keys and their values, the latter as JSON.
using JsonMembers = std::vector<std::pair<std::string, std::string>>;

/// {"a": 1, "b": 2}
std::string json_line(const JsonMembers& members);

/// A member a line, further in than what is around it.
std::string json_object(const JsonMembers& members, const std::string& indent);

/// A document: a list with an item a line.
std::string json_document(const std::vector<std::string>& items);

/// The table as a JSON document, a row a line: {"model": "bst", "n": 14, "mean": 3.2}. Numbers are printed as
/// in CSV; null stands for nothing and for what is not finite.
std::string write_json(const Table& table);

}  // namespace ramify
