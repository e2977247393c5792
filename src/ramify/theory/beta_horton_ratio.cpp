#include "ramify/theory/beta_horton_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ramify/core/contract.hpp"
#include "ramify/theory/horton_wave.hpp"

namespace ramify {
namespace {

/// Relative: what rounding leaves of two solutions of the same wave, with room to spare.
constexpr double rounding = 1e-12;

/// Of a lattice: a step of Newton's method takes a quarter of a second with as many.
constexpr int most_points = 700;

/// About the standard deviation of log of the smaller child's share, which sets the width of the front.
double front_scale(const BetaSplit& split) {
  const double less = std::min(split.a, split.b) + 1, more = std::max(split.a, split.b) + 1;
  return std::sqrt(more / (less * (less + more + 1)));
}

/// Newton's method down to rounding. Returns its last step, the size of what rounding leaves; nothing if it
/// fails.
std::optional<double> solve(HortonWave& wave) {
  double step = 1;
  for (int steps = 0; steps < 12; ++steps) {
    const double previous = std::exchange(step, wave.refine());
    if (!(step < 1)) return std::nullopt;
    if (step < 1e-13 || (step < 1e-7 && step > previous / 10)) break;
  }
  return step < 1e-2 ? std::optional(step) : std::nullopt;
}

/// Half the spacing on the stretch that the wave takes up, and a rule with twice the points.
HortonWave::Mesh finer(HortonWave::Mesh mesh) {
  constexpr int margin = 4;
  return {mesh.spacing / 2, 2 * (mesh.below + margin), 2 * (mesh.above + margin), 2 * mesh.points};
}

/// From the first guess on this mesh to the ratio, refined until two meshes agree.
std::optional<Rounded> ratio_from(const BetaSplit& split, const HortonWave::Mesh& mesh) {
  HortonWave wave(split, mesh);
  for (int orders = 0; orders < 30; ++orders)
    if (!(std::abs(wave.advance()) > 1e-4)) break;
  auto noise = solve(wave);
  if (!noise) return std::nullopt;
  double ratio = std::exp(wave.log_ratio()), change = ratio;
  for (int levels = 0; levels < 4 && change > (rounding + *noise) * ratio; ++levels) {
    const auto next = finer(wave.extent());
    if (next.below + next.above > most_points) break;
    wave = wave.resampled(next);
    const auto finer_noise = solve(wave);
    if (!finer_noise) break;
    noise = finer_noise;
    const double coarser = std::exchange(ratio, std::exp(wave.log_ratio()));
    change = std::abs(ratio - coarser);
  }
  return Rounded{ratio, change + (rounding + 4 * *noise) * ratio};
}

}  // namespace

std::optional<Rounded> beta_horton_ratio(const BetaSplit& split) {
  RAMIFY_EXPECTS(split.a > -1 && split.b > -1);
  const BetaSplit ordered{std::min(split.a, split.b), std::max(split.a, split.b)};
  if (!(ordered.b <= 1e4)) return std::nullopt;
  double spacing = std::min(0.1, 0.7 * front_scale(ordered));
  const double above = std::max(1.5, 60 * spacing);
  const int points =
      ordered.a < -0.5 ? 80 : 40;  // near -1 the weight lies at the end, where psi(y1) is least smooth
  int below = 140;
  std::optional<Rounded> best;
  while (below + above / spacing < most_points && (!best || best->error >= 1e-9 * best->value)) {
    const auto found = ratio_from(ordered, {spacing, below, static_cast<int>(above / spacing), points});
    if (found && (!best || found->error < best->error)) best = found;
    spacing /= 2;
    below = below * 3 / 2;
  }
  return best && best->error < best->value ? best : std::nullopt;
}

}  // namespace ramify
