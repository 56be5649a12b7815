#pragma once

// A beam whose properties change along it: pieces in which they are linear, and point masses.

#include <array>
#include <compare>
#include <vector>

namespace spoke::plane {

/// A stretch of a body in which each property goes linearly from its first to its second value.
struct BeamPiece {
  double begin = 0.0;                         ///< begin, from the body's inboard end [m]
  double end = 0.0;                           ///< end, from the body's inboard end, > begin [m]
  std::array<double, 2> mass_per_length{};    ///< rhoA [kg/m]
  std::array<double, 2> axial_stiffness{};    ///< EA [N]
  std::array<double, 2> bending_stiffness{};  ///< EI [N m^2]

  /// Returns a property at x [m].
  double at(const std::array<double, 2>& property, double x) const {
    return property[0] + (property[1] - property[0]) * ((x - begin) / (end - begin));
  }
  /// Returns the change of a property per length [its unit/m].
  double slope(const std::array<double, 2>& property) const {
    return (property[1] - property[0]) / (end - begin);
  }
  auto operator<=>(const BeamPiece&) const = default;
};

/// A point mass on the axis of a body.
struct BodyMass {
  double x = 0.0;        ///< distance from the body's inboard end [m]
  double mass = 0.0;     ///< [kg]
  double inertia = 0.0;  ///< moment of inertia about its centre [kg m^2]

  auto operator<=>(const BodyMass&) const = default;
};

/// Whether they lead from 0 to the length without gaps, or are none.
bool follow_one_another(const std::vector<BeamPiece>& pieces, double length);

/// The piece in which x lies; between two, the outer one. Precondition: there are pieces, from
/// inboard to outboard end without gaps.
const BeamPiece& piece_at(const std::vector<BeamPiece>& pieces, double x);

/// Returns the mean of EA between two places [N]. Preconditions: those of piece_at(), and from <
/// to.
double mean_axial_stiffness(const std::vector<BeamPiece>& pieces, double from, double to);

/// Returns int rhoA (distance + xi) dxi over a piece from x to its end [kg m]: the first moment
/// about a point `distance` [m] inboard of the body. Precondition: x <= piece.end.
double first_moment_beyond(const BeamPiece& piece, double x, double distance);

/// Returns the mass of a piece from x to its end [kg]. Precondition: x <= piece.end.
double mass_beyond(const BeamPiece& piece, double x);

/// Returns for each piece the mass outboard of it, the point masses at its end included [kg].
/// Precondition: that of first_moments_outboard().
std::vector<double> masses_outboard(const std::vector<BeamPiece>& pieces,
                                    const std::vector<BodyMass>& masses);

/// Returns for each piece the first moment of all mass outboard of it, the point masses at its end
/// included [kg m]. Precondition: the masses are in order, each at the end of a piece or at 0.
std::vector<double> first_moments_outboard(const std::vector<BeamPiece>& pieces,
                                           const std::vector<BodyMass>& masses, double distance);

}  // namespace spoke::plane
