#pragma once

// What each of the equally long bodies of a blade is made of.

#include <compare>
#include <vector>

#include "models/rotor.h"
#include "models/system/beam_pieces.h"

namespace spoke {

/// One body of a beam.
struct BeamProperties {
  double length = 0.0;             ///< of the body [m]
  int elements = 1;                ///< of equal length
  double mass_per_length = 0.0;    ///< rhoA [kg/m]; this and the next two if there are no pieces
  double axial_stiffness = 0.0;    ///< EA [N]
  double bending_stiffness = 0.0;  ///< EI [N m^2]
  ReferenceFrame reference_frame = ReferenceFrame::clamped;
  /// If the body is not uniform, or carries point masses: from its inboard end to its outboard end.
  std::vector<BeamPiece> pieces{};
  std::vector<BodyMass> masses{};  ///< a piece ends where one lies

  auto operator<=>(const BeamProperties&) const = default;
};

/// Whether all bodies of a blade are alike: it has neither sections nor point masses.
bool is_uniform(const Blade& blade);

/// Properties of body number `body` of a blade, from 0. A point mass between two bodies is on the
/// inner one.
BeamProperties make_beam_properties(const Blade& blade, int body);

}  // namespace spoke
