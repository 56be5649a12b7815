#pragma once

// The axis of an undeformed beam, and the axes of its sections.

#include <cstddef>
#include <optional>
#include <vector>

#include "models/curve.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// Geometry of a beam by its station x, in the beam's frame. Sweep and prebend are interpolated by
/// monotone cubic pieces, as every curve of a scenario; the twist linearly.
class BeamAxis {
 public:
  /// Of sections that are fine.
  explicit BeamAxis(const Sections& sections);

  /// Point of the axis [m].
  Vector place(double x) const;
  /// Length of the axis by that of x: 1 where it is straight.
  double stretch(double x) const;
  /// Rotation that takes components in the section's axes to the beam's frame: the smallest one
  /// that takes x to the tangent, after the twist about x.
  Tensor axes(double x) const;

 private:
  Vector tangent(double x) const;

  const std::vector<double>& station_;
  const std::vector<double>& twist_;
  std::optional<Curve> sweep_, prebend_;  ///< none: 0
};

/// The smallest rotation that takes the direction `from` to the direction `to`, of any length; of
/// opposite ones half a turn about the x axis, or about z if they lie along x.
Tensor smallest_rotation(const Vector& from, const Vector& to);

/// The rotation of a rotation vector [rad].
Tensor rotation_of(const Vector& rotation_vector);

}  // namespace spoke::spatial
