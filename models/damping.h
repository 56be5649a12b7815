#pragma once

// The damping of deformation, as an engineer gives it (docs/formulation.md, section 10).

#include <optional>
#include <vector>

namespace spoke {

/// Damping of beams by direction: the factor [s] by which the stiffness of each strain of a section
/// damps its rate. A vibration of W rad/s in one direction has the damping ratio factor W / 2. In
/// the plane there are `lag`, which is bending, and `axial`.
struct DirectionDamping {
  double flap = 0.0;                                ///< bending along the section's z
  double lag = 0.0;                                 ///< bending along the section's y
  double axial = 0.0;                               ///< stretch
  double torsion = 0.0;                             ///< twist
  std::optional<double> flap_shear = std::nullopt;  ///< shear along z; none: as flap
  std::optional<double> lag_shear = std::nullopt;   ///< shear along y; none: as lag

  /// Whether it damps nothing.
  bool is_zero() const {
    return flap == 0.0 && lag == 0.0 && axial == 0.0 && torsion == 0.0 &&
           flap_shear.value_or(0.0) == 0.0 && lag_shear.value_or(0.0) == 0.0;
  }
  friend bool operator==(const DirectionDamping&, const DirectionDamping&) = default;
};

/// Damping of beams by the modes that each has at rest, undeformed and by itself, held at its root,
/// what joints part it at locked.
struct ModeDamping {
  /// Damping ratios of the lowest modes, by ascending frequency; each less than 1.
  std::vector<double> ratios{};
  /// Damping ratio of the next mode, to which those above are damped in proportion to their
  /// frequency; none: that of the last of `ratios`.
  std::optional<double> above = std::nullopt;

  friend bool operator==(const ModeDamping&, const ModeDamping&) = default;
};

/// Damping of the deformation: D = mass_factor Mff + stiffness_factor K (Rayleigh) of all bodies,
/// and of beams what directions and modes add.
struct Damping {
  double mass_factor = 0.0;       ///< [1/s]
  double stiffness_factor = 0.0;  ///< [s]
  DirectionDamping directions{};
  ModeDamping modes{};
};

}  // namespace spoke
