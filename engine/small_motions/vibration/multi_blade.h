#pragma once

// Multi-blade coordinates (Coleman's): three or more equal blades at equal angles, seen from
// outside, have constant matrices on whatever their hub stands. So has a shaft (shaft_turn.h).
//
// With psi_b the azimuth of blade b, which grows with the rotation, and y_b its coordinates,
//
//   y_b = a_0/sqrt(N) + sqrt(2/N) sum_n (a_nc cos n psi_b + a_ns sin n psi_b) + (-1)^b a_d/sqrt(N),
//
// n from 1 to below N/2, a_d only if N is even. This is orthonormal, so that masses stay.

#include <string>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/root.h"
#include "engine/small_motions/vibration/standing_axes.h"

namespace spoke::vibration {

/// Blades that loops between them tie, so that they are one subsystem of the rotor.
struct BladeRing {
  bool is_tied = false;  ///< whether there are such blades
  // By blade in the order of ascending azimuths; empty: what ties them is not alike all around.
  std::vector<double> azimuths{};      ///< at azimuth zero of the hub [rad]
  std::vector<Eigen::Index> starts{};  ///< first of its coordinates among the independent ones
  Eigen::Index size = 0;               ///< number of its coordinates

  bool is_even() const { return !azimuths.empty(); }
};

/// Blades that are alike and stand at equal angles; or a shaft, which is a family of its own.
struct BladeFamily {
  /// Subsystems, by ascending azimuth; of a ring the one that all of it is.
  std::vector<std::size_t> blades;
  std::vector<double> azimuths;  ///< of the blades, at azimuth zero of the hub [rad]
  Eigen::MatrixXd turn{};        ///< of a shaft: see find_turn(); empty: it is none
  double speed = 0.0;            ///< of its hub [rad/s]
  std::size_t rotor = 0;         ///< that it is of, of several on a support
  BladeRing ring{};              ///< not tied: it is none

  bool is_shaft() const { return turn.size() > 0; }
  /// Returns the coordinates of the subsystem of the first blade, by those of this blade.
  Eigen::VectorXcd put_first(const Eigen::VectorXcd& y) const;
  /// Returns the part of a matrix of that subsystem that is the first blade's.
  Eigen::MatrixXd take_first(const Eigen::MatrixXd& matrix) const;
};

/// Coordinates of a family that go together: a_0, a pair a_nc and a_ns below one another, or a_d;
/// those of a shaft as it is seen from outside, of multiple 0.
struct BladePattern {
  std::size_t family = 0;
  int multiple = 0;              ///< n; N/2 of a_d
  bool is_pair = false;          ///< a_nc and a_ns
  bool is_differential = false;  ///< a_d
  Eigen::Index size = 0;         ///< coordinates of one blade
};

/// A rotor seen from outside: a linear model whose hub has coordinates z along standing axes, and
/// whose subsystems are the patterns of the blades. Of several rotors that follow one another,
/// hubs by rotor, then all patterns.
struct FixedFrame {
  steady::LinearModel model;
  std::vector<BladeFamily> families;
  std::vector<BladePattern> patterns;  ///< by subsystem of `model`
  double fastest = 0.0;                ///< largest magnitude of the speeds of hubs [rad/s]

  /// Returns the first coordinate of a pattern in a vector that begins with those of the hub.
  Eigen::Index start(std::size_t pattern) const;
  /// Returns the factors of a pattern's parts (a; or a_nc, a_ns) in the motion of a blade of its
  /// family, by its place there, at an azimuth of the hub [rad].
  Eigen::Vector2d shares(std::size_t pattern, std::size_t place, double psi = 0.0) const;
  /// Returns the motion of the coordinates of a subsystem of the rotor, at an azimuth of the hub;
  /// of none if it is in no family.
  Eigen::VectorXcd motion_of(std::size_t subsystem, const Eigen::VectorXcd& x,
                             double psi = 0.0) const;
};

/// Takes a rotor, linearised in the frame that turns with its hub, to multi-blade coordinates.
/// `azimuths`, `names`: of its subsystems, the latter for messages; `axes`: of the hub's
/// coordinates; `turns`: by subsystem that of find_turn() if it is a shaft with constant matrices,
/// else empty; `rings`: by subsystem the blades of which it consists. Throws InputError, which says
/// what to use instead, unless all other subsystems with coordinates are alike in families of three
/// or more at equal angles, or in rings, and the hub is alike in all directions across its axis.
FixedFrame make_fixed_frame(const steady::LinearModel& turning, const std::vector<double>& azimuths,
                            const std::vector<std::string>& names, const StandingAxes& axes,
                            const std::vector<Eigen::MatrixXd>& turns = {},
                            const std::vector<BladeRing>& rings = {});

/// Joins rotors, each with all components of its hub, so that they follow one another.
/// `subsystems`: by rotor, the numbers of its subsystems among all.
FixedFrame join(const std::vector<FixedFrame>& rotors,
                const std::vector<std::vector<std::size_t>>& subsystems);

/// Puts a rotor, or several, on something that moves the hub by x = J z and has matrices of its
/// own: hub coordinates become z, and its matrices support + J^T rotor J. `support`: about the
/// steady state in which the rotor's steady wrench acts on it, along standing axes.
FixedFrame stand_on(const FixedFrame& rotor, const Eigen::MatrixXd& J, const SecondOrder& support);

/// Returns the `count` roots of least magnitude in ascending order, or all if there are fewer, with
/// vectors of hub and patterns. Patterns that do not meet the hub have problems of their own.
/// Motions at zero that gyroscopic forces hold in pairs count once.
std::vector<Root> find_fixed_roots(const FixedFrame& frame, Eigen::Index count);

}  // namespace spoke::vibration
