#pragma once

#include <cstdint>
#include <string>

#include "ramify/core/cancellation.hpp"
#include "ramify/gallery/picture_preset.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// Measures of the forms of a preset (B24), of branches alone, in the unit of its constants.
enum class FormTable : std::uint8_t {
  summary,  ///< a row a panel: volume, surface, height, spread, length, and Horton's ratios of radius and
            ///< stream length
  orders,   ///< a row an order: cylinders, streams, mean radius and length of a cylinder, mean length of a
            ///< stream
};

/// "summary" or "orders"; throws Error for another name, nearest names given.
FormTable parse_form_table(const std::string& name);

/// The ratios are exp of the least-squares slope of the logarithm of a mean on its order: Horton's second law
/// (C35). Throws Interrupted.
Table form_table(const PicturePreset& preset, FormTable kind, const Cancellation& cancellation);

}  // namespace ramify
