#pragma once

// A beam whose properties change along it: pieces in which they are linear, and point masses.

#include <array>
#include <compare>
#include <vector>

namespace spoke {

/// A stretch of a body in which each property goes linearly from its first to its second value.
struct BeamPiece {
  double begin = 0.0;                         ///< from the body's inboard end [m]
  double end = 0.0;                           ///< likewise, > begin [m]
  std::array<double, 2> mass_per_length{};    ///< rhoA [kg/m]
  std::array<double, 2> axial_stiffness{};    ///< EA [N]
  std::array<double, 2> bending_stiffness{};  ///< EI [N m^2]

  /// A property at x [m].
  double at(const std::array<double, 2>& property, double x) const {
    return property[0] + (property[1] - property[0]) * ((x - begin) / (end - begin));
  }
  /// Its change per length [1/m].
  double slope(const std::array<double, 2>& property) const {
    return (property[1] - property[0]) / (end - begin);
  }
  auto operator<=>(const BeamPiece&) const = default;
};

/// A point mass on the axis of a body.
struct BodyMass {
  double x = 0.0;        ///< from the body's inboard end [m]
  double mass = 0.0;     ///< [kg]
  double inertia = 0.0;  ///< about its centre [kg m^2]

  auto operator<=>(const BodyMass&) const = default;
};

/// The piece in which x lies; between two, the outer one. Precondition: there are pieces, from
/// inboard to outboard end without gaps.
const BeamPiece& piece_at(const std::vector<BeamPiece>& pieces, double x);

/// Mean of EA between two places [N]. Preconditions: as above, from < to.
double mean_axial_stiffness(const std::vector<BeamPiece>& pieces, double from, double to);

/// int rhoA (distance + xi) dxi over a piece from x to its end [kg m]: the first moment about a
/// point `distance` [m] inboard of the body. Precondition: x <= piece.end.
double first_moment_beyond(const BeamPiece& piece, double x, double distance);

/// Mass of a piece from x to its end [kg]. Precondition: x <= piece.end.
double mass_beyond(const BeamPiece& piece, double x);

/// For each piece, the mass of what lies outboard of it, the point masses at its end included [kg].
/// Precondition: as below.
std::vector<double> masses_outboard(const std::vector<BeamPiece>& pieces,
                                    const std::vector<BodyMass>& masses);

/// For each piece, the first moment of what lies outboard of it, the point masses at its end
/// included [kg m]. Precondition: the masses are in order, each at the end of a piece or at 0.
std::vector<double> first_moments_outboard(const std::vector<BeamPiece>& pieces,
                                           const std::vector<BodyMass>& masses, double distance);

}  // namespace spoke
