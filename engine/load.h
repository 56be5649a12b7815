#pragma once

// Loads of the user's own: forces and moments at markers, as a function of time and of the markers'
// motion. Vectors are three-dimensional; a planar system moves in the x-y plane.
// markers_at() finds the markers at given places of a blade.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spoke/export.h"

namespace spoke {

struct Scenario;

/// A point on the axis of a flexible body; in space also one of a rigid body.
struct Marker {
  int blade = 0;         ///< from 0; in space the subsystems follow behind the blades
  int body = 0;          ///< from 0, at the root; in space in the order of `spoke check`
  double station = 0.0;  ///< along the body: 0 at its inboard end, 1 at its outboard end
  Eigen::Vector3d point{0.0, 0.0, 0.0};  ///< on a rigid body, in its frame [m]; else zero

  /// Whether all three are equal.
  friend bool operator==(const Marker&, const Marker&) = default;
};

/// The motion of a marker's cross section, in the inertial frame. What a load is given includes the
/// foreshortening of bodies with geometric stiffening, along the axes of the undeformed model that
/// turn with the hub: the place at which its force does work. So a spring between two markers keeps
/// energy and momentum.
struct MarkerMotion {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
  /// Takes vectors from the section's frame to the inertial frame: x along the deformed axis,
  /// outward, and in the plane z as the inertial one; in space the axes of the section, its twist
  /// included, or those of a rigid body.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};          ///< [m/s]
  Eigen::Vector3d angular_velocity{0.0, 0.0, 0.0};  ///< [rad/s]
};

/// What is known of a marker.
struct MarkerState : MarkerMotion {
  Eigen::Vector3d acceleration{0.0, 0.0, 0.0};          ///< [m/s^2]
  Eigen::Vector3d angular_acceleration{0.0, 0.0, 0.0};  ///< [rad/s^2]
  /// From its place on the undeformed blade, which turns with the hub (in space with all joint
  /// coordinates zero); hub frame [m].
  Eigen::Vector3d deflection{0.0, 0.0, 0.0};
  /// What a model with geometric stiffening accounts for in its energies, not in its coordinates,
  /// of which position, velocity and deflection are here: the tip's sensors show the deflection
  /// less this; hub frame [m].
  Eigen::Vector3d foreshortening{0.0, 0.0, 0.0};
};

/// A force and a moment.
struct Wrench {
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< [N]
  Eigen::Vector3d moment{0.0, 0.0, 0.0};  ///< [N m]
};

/// A load at points of one blade or of several. It becomes a node "load" of the step graph, which
/// runs in every evaluation of the accelerations, beside what else of the system is independent of
/// it. A load on several blades, a damper between two say, ties all blades to one another: they
/// then make every evaluation together, as they do on a free hub, also if the hub's motion is
/// prescribed. A load for each blade lets them stay independent.
class SPOKE_EXPORT Load {
 public:
  virtual ~Load() = default;
  /// Names the load in errors.
  virtual std::string name() const = 0;
  /// Where it acts and what it knows of: one or more points. Asked once.
  virtual std::vector<Marker> markers() const = 0;
  /// Sets what acts on the body at each marker at time t [s], in the inertial frame, the moment
  /// about the marker. `out` is zero beforehand; both spans are in the order of markers(). Values
  /// that are not finite are refused, and in the plane forces along z and moments about x and y.
  ///
  /// Must be a function of its arguments alone: a step evaluates it several times, a failed step is
  /// repeated, and different loads run in different threads. What it throws ends the step with a
  /// LoadError.
  virtual void evaluate(double t, std::span<const MarkerMotion> in,
                        std::span<Wrench> out) const = 0;
};

/// The loads of a simulation, in their order.
using Loads = std::vector<std::shared_ptr<const Load>>;

/// What Load::evaluate() does, as a function.
using LoadFunction =
    std::function<void(double t, std::span<const MarkerMotion> in, std::span<Wrench> out)>;

/// A load from a function.
SPOKE_EXPORT std::shared_ptr<const Load> make_load(std::string name, std::vector<Marker> markers,
                                                   LoadFunction function);

/// The markers at distances from a blade's root [m], in space stations of its beam; where two
/// bodies meet, on the inner one. Throws InputError if the scenario has no such blade, counted from
/// 0, or a place is not on it.
SPOKE_EXPORT std::vector<Marker> markers_at(const Scenario& scenario, int blade,
                                            std::span<const double> positions);

}  // namespace spoke
