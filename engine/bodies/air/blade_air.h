#pragma once

// Air loads on one blade: from the motion of its stations to forces, with the states of inflow and
// stall. Pure functions of their arguments. Equations: docs/aerodynamics.md.

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/bodies/air/rotor_place.h"
#include "engine/bodies/air/station_state.h"
#include "engine/load.h"
#include "models/air.h"
#include "models/air/section_polar.h"
#include "spoke/export.h"

namespace spoke::air {

/// What the air does at a station. Its local axes lie in the section's plane: "axial" is the
/// rotor's axis projected onto that plane, "tangential" is normal to it, positive in the direction
/// in which the leading edge looks, that of the turn. Forces by length are projected onto the
/// rotor's axis and its circumference.
struct StationAir {
  double radius;                ///< distance from the rotor's axis [m]
  double attack;                ///< angle of attack [rad]
  double relative_speed;        ///< of the air against the section, in its plane [m/s]
  double axial_induction;       ///< a: induced velocity against the axial flow, by that flow;
                                ///< 0 without axial flow
  double tangential_induction;  ///< a': induced velocity against the turn, by the flow from ahead
  double induced_axial;         ///< induced velocity along the axis [m/s]
  double induced_tangential;    ///< induced velocity in the direction of the turn [m/s]
  double lift, drag, moment;    ///< coefficients; the moment about the aerodynamic centre, nose up
  /// Force [N/m] along the rotor's axis and in the plane of rotation in the direction of the turn,
  /// and moment about the section's x, on its axis [N m/m], by length of the blade.
  double axial_force, tangential_force, pitching_moment;
  double axial_moment;  ///< that moment's part about the rotor's axis, in the direction of the turn
};

/// Constants of the air on one blade. Made once; evaluated without allocation, by several threads
/// at a time.
class SPOKE_EXPORT BladeAir {
 public:
  using Polars = std::vector<std::shared_ptr<const SectionPolar>>;

  /// Makes the air on a blade of a rotor of so many. hub_radius: of the blade's root [m].
  /// stations: at which loads act, from the root, two or more, ascending, of the undeformed blade
  /// [m]; polars: coefficients at each of them (make_polars()). Chord, twist and aerodynamic centre
  /// are interpolated linearly between the stations of `blade` and are those of its ends beyond
  /// them. Tip and root losses are those of the undeformed radii; the tip is the last of all
  /// stations.
  BladeAir(const spatial::BladeAerodynamics& blade, const spatial::Air& air, int blades,
           double hub_radius, std::vector<double> stations, Polars polars);
  /// Makes the coefficients, too. Throws InputError for an aerofoil that `air` lacks.
  BladeAir(const spatial::BladeAerodynamics& blade, const spatial::Air& air, int blades,
           double hub_radius, const std::vector<double>& stations);

  /// Returns the number of stations.
  std::size_t count() const { return stations_.size(); }
  /// Returns the doubles of a blade's state.
  std::size_t state_size() const { return states_of_station() * stations_.size(); }
  /// Returns the distances of the stations from the root [m].
  const std::vector<double>& stations() const { return places_; }
  /// Returns the rotor's radius, undeformed [m].
  double radius() const { return radius_; }

  /// Sets the loads at time t and the states there.
  ///
  /// sections: motion of the stations' sections at t; wind: undisturbed velocity of the air at
  /// them, inertial frame [m/s]. before: states (state_size()) at the beginning of the
  /// step; elapsed: time since then [s], 0 or more: the states advance by it, their inputs linear
  /// in between. 0: induced velocities and separation are those of `before`, where they have states
  /// (dynamic); infinite: the states of equilibrium, whatever `before` holds. after: states at t;
  /// may be `before`. out: force [N] and moment [N m] about the section's axis, inertial frame.
  /// seen: what the air does at each station, or empty. held: induced velocities and their states
  /// are those that `after` has, under all options. All spans have count() entries. Finite input
  /// gives finite loads.
  void evaluate(const RotorPlace& rotor, std::span<const MarkerMotion> sections,
                std::span<const Eigen::Vector3d> wind, double elapsed, const double* before,
                double* after, std::span<Wrench> out, std::span<StationAir> seen,
                bool held = false) const noexcept;

  /// Returns the thrust of the blade along the rotor's axis [N].
  double thrust(std::span<const StationAir> seen) const noexcept;
  /// Returns the torque of its forces about the rotor's axis, positive in the direction of the turn
  /// [N m].
  double torque(std::span<const StationAir> seen) const noexcept;

 private:
  /// Constants of a station.
  struct Station {
    double chord, center;  // [m]
    double sine, cosine;   // of the chord's twist
    double tip, root;      // of Annulus
    double span_ratio;     // undeformed radius by the tip's
    std::shared_ptr<const SectionPolar> polar;
  };
  struct Point;
  struct Advance;

  std::size_t states_of_station() const { return lags_attached_ ? kStates + kShedStates : kStates; }

  Point find_point(const RotorPlace& rotor, const Station& station, const MarkerMotion& section,
                   const Eigen::Vector3d& wind, double in_plane) const noexcept;
  /// Returns the flow that a station's annulus induces in steady state.
  InducedFlow solve_momentum(const Point& point) const noexcept;
  /// Moves the states of inflow on.
  void advance_induced(const Advance& advance, Point& point) const noexcept;
  /// Moves those of the shed wake on, and takes what it induces across the chord from the flow.
  void advance_shed(const Advance& advance, Point& point) const noexcept;
  /// Moves those of stall on; returns the lift.
  double advance_lift(const Advance& advance, const PolarValues& polar,
                      Point& point) const noexcept;
  /// Returns the load by length.
  Wrench find_load(const Point& point, const PolarValues& polar) const noexcept;
  StationAir describe(const RotorPlace& rotor, const Point& point, const InducedFlow& induced,
                      double attack, const PolarValues& polar, const Wrench& load) const noexcept;

  std::vector<Station> stations_;
  std::vector<double> places_;
  double density_, viscosity_, sound_speed_;
  double radius_;  // of the tip [m]
  int blades_;
  double inflow_factor_;
  spatial::HighThrust high_thrust_;
  spatial::MassFlow mass_flow_;
  double side_;  // 1, or -1 where leading edges look towards -y
  bool induces_, lags_inflow_, lags_attached_, lags_stall_;
};

}  // namespace spoke::air
