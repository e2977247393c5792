#pragma once

#include <string>

namespace ramify {

/// Where and when a table was made; written beside it as provenance.json.
struct Provenance {
  std::string version;  ///< of ramify
  int schema;           ///< of the tables
  std::string compiler;
  std::string host;
  std::string started;  ///< UTC, ISO 8601
};

/// Of this process, now.
Provenance current_provenance();

}  // namespace ramify
