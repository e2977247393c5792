#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ramify/report/plot.hpp"

namespace ramify::detail {

/// The gnuplot script of a plot; nothing where no point can be drawn.
std::optional<std::string> plot_script(const Plot& plot, std::string_view stem);

/// Text as a gnuplot string in single quotes: nothing in it is a command, an escape or markup.
std::string gnuplot_string(std::string_view text);

}  // namespace ramify::detail
