#pragma once

// The properties of each of the equally long bodies of a blade.

#include <compare>
#include <vector>

#include "models/plane/beam_pieces.h"
#include "models/rotor.h"

namespace spoke::plane {

/// One body of a beam.
struct BeamProperties {
  double length = 0.0;  ///< length of the body [m]
  int elements = 1;     ///< number of elements, of equal length
  /// RhoA [kg/m]; this and the next two hold if there are no pieces.
  double mass_per_length = 0.0;
  double axial_stiffness = 0.0;    ///< EA [N]
  double bending_stiffness = 0.0;  ///< EI [N m^2]
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  /// Pieces from the inboard to the outboard end, if the body is not uniform or carries point
  /// masses.
  std::vector<BeamPiece> pieces{};
  std::vector<BodyMass> masses{};  ///< point masses; a piece ends at each of them
  bool is_nonlinear = false;       ///< whether strains are of second order

  auto operator<=>(const BeamProperties&) const = default;
};

/// Returns whether all bodies of a blade are alike: it has neither sections nor point masses.
bool is_uniform(const Blade& blade);

/// Returns the properties of body number `body` of a blade, from 0. A point mass between two bodies
/// is on the inner one.
BeamProperties make_beam_properties(const Blade& blade, int body);

}  // namespace spoke::plane
