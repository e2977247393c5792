#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ramify/accumulate/order_totals.hpp"
#include "ramify/accumulate/real_summary.hpp"
#include "ramify/accumulate/whole_summary.hpp"

namespace ramify {

// Accumulators as JSON values and back, exactly, as text or as CBOR: sums of 128 bits are decimal texts,
// reals that JSON has no number for are the texts inf and -inf. from_json throws nlohmann::json::exception
// where the shape is wrong and Error where a text is no number. Include <nlohmann/json.hpp> where they are
// called.

void to_json(nlohmann::json& j, const WholeSummary& summary);
void from_json(const nlohmann::json& j, WholeSummary& summary);

void to_json(nlohmann::json& j, const RealSummary& summary);
void from_json(const nlohmann::json& j, RealSummary& summary);

void to_json(nlohmann::json& j, const OrderTotals& totals);
void from_json(const nlohmann::json& j, OrderTotals& totals);

}  // namespace ramify
