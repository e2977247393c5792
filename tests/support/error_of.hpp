#pragma once

#include <string>

#include "ramify/core/error.hpp"

namespace ramify::test {

/// What a call says as an Error; empty where it returns.
template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace ramify::test
