#pragma once

// The largest deflection of each blade's tip, which a run prints.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/checkpoint.h"
#include "engine/simulation.h"

namespace spoke::cli {

/// Finds the largest deflection of each blade's tip across the undeformed blade, over all steps.
/// The sensors have a tip's displacement in the hub frame; this turns it to the blade's direction.
class TipDeflections {
 public:
  /// Throws std::out_of_range if a blade has no tip sensors.
  explicit TipDeflections(const Simulation& simulation);
  /// Goes on with what extremes() was. Precondition: one for each blade.
  TipDeflections(const Simulation& simulation, const std::vector<TipExtreme>& extremes);

  /// sensors: all sensor values at time t [s].
  void add(double t, std::span<const double> sensors);
  std::vector<TipExtreme> extremes() const;  ///< by blade
  /// A text such as "-0.534149 m at 6.765 s (blades 1-3)" for each group of blades with the same
  /// deflection, the largest first.
  std::vector<std::string> describe() const;

 private:
  struct Blade {
    std::size_t x, y;     ///< indices of its sensors
    double cosine, sine;  ///< of its azimuth
    TipExtreme extreme;   ///< positive ahead of the hub's rotation, counterclockwise
  };
  std::vector<Blade> blades_;
};

}  // namespace spoke::cli
