#pragma once

#include "ramify/family/family.hpp"

/// Every family, each in a file of its own.
namespace ramify {

Family patricia_family();
Family dst_family();
Family beta_family();
Family beta_multinomial_family();
Family aldous_family();
Family ford_family();
Family bst_family();
Family catalan_family();
Family critical_family();
Family tokunaga_family();
Family ramification_family();
Family ternary_family();

}  // namespace ramify
