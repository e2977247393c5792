#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "support/goodness.hpp"

#include "ramify/tree/grammar.hpp"

namespace ramify::test {

/// The probability of every tree, by its parenthesis word; where they sum to less than 1 the rest is that of
/// all trees left out.
using WordLaw = std::map<std::string, double>;

/// All ways to put one tree of each law side by side, without parentheses around them.
WordLaw side_by_side(const std::vector<WordLaw>& laws);

/// Adds, with a weight, the trees whose root has the children `below`.
void add_node(const WordLaw& below, double weight, WordLaw& law);

/// P(Bin(n, p) = k).
double binomial(unsigned n, unsigned k, double p);

/// Of ternary trees (A22) of `size` nodes whose p is a function of the depth of the node, that of the root
/// being `depth`: all sizes of the third child that leave the first none below 0.
WordLaw ternary_law(const std::function<double(double depth)>& p_at, unsigned size, unsigned depth = 1);

/// The trees that a grown model grows at n, 60,000 of them, against a law.
Goodness words_against(const std::string& model, Size n, const WordLaw& law, const std::string& what);

}  // namespace ramify::test
