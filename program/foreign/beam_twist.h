#pragma once

// The twist of a beam's sections, as the scenario has it.

#include <algorithm>

#include "program/foreign/beam_table.h"

namespace spoke::foreign {

/// Returns the twist at x, linear between stations [rad].
inline double twist_at(const BeamTable& beam, double x) {
  if (beam.twist.empty()) return 0.0;
  const auto above = std::upper_bound(beam.station.begin() + 1, beam.station.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - beam.station.begin());
  const double t = (x - beam.station[k - 1]) / (beam.station[k] - beam.station[k - 1]);
  return t == 1.0 ? beam.twist[k] : beam.twist[k - 1] + t * (beam.twist[k] - beam.twist[k - 1]);
}

}  // namespace spoke::foreign
