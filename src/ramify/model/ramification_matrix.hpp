#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "ramify/text/csv_reader.hpp"

namespace ramify {

/// Row k-1 holds p(k,0), ..., p(k,k), k = 1, 2, ...: with what probability a node of order k has children of
/// the orders k and j < k, or, j = k, two of order k-1. Leaf order 0.
using RamificationMatrix = std::vector<std::vector<double>>;

/// Orders go up to this one.
inline constexpr std::size_t most_orders = 62;

/// From a CSV file with the columns order, side, probability and, if wanted, leaf_order (0, or 1 as measured
/// data have it: the default); rows in any order, what has none is 0. Throws Error with file:line:column.
RamificationMatrix read_ramification_matrix(const std::filesystem::path& path);

/// Counts in place of probabilities, whole numbers in a column `count`: nodes of order k with (k,j) below.
/// Same shape, columns and errors.
RamificationMatrix read_bi_order_counts(const CsvData& table);

/// A Markov chain as a matrix (A19, Le Mehaute 1991): its states are orders, and of the transitions of a
/// state those to itself and to lower states are kept and scaled to sum 1. Columns state, next, probability,
/// leaf_order, as of a matrix: the lowest state is external.
///
/// The thesis gives no mapping; this one keeps what can be kept. Throws Error with file:line:column, and
/// where the transitions of a state do not sum to 1 within 1e-9 or none is kept.
RamificationMatrix read_markov_chain(const std::filesystem::path& path);

/// The random self-similar tree of Tokunaga numbers T_k = a c^(k-1) (Tokunaga 1978; Kovchegov and Zaliapin
/// 2018): p(k,j) = T_(k-j)/(1 + T_1 + ... + T_k), p(k,k) = 1/(1 + T_1 + ... + T_k). a = 1, c = 2 is the
/// critical binary Galton-Watson tree given its order. a, c > 0.
RamificationMatrix tokunaga_matrix(double a, double c);

/// A hybrid (A18): the row of the order k-th in pattern from the first matrix where there stands A, from the
/// second where there stands B; "AAB" takes those of the lowest two internal orders from the first. As many
/// rows as the pattern has letters. Throws Error for another letter or a row that a matrix does not have.
RamificationMatrix hybrid_matrix(const RamificationMatrix& first, const RamificationMatrix& second,
                                 std::string_view pattern);

}  // namespace ramify
