#pragma once

// Loads of the user's own: forces and moments at markers as a function of time and of the motion of
// the markers. Vectors are three-dimensional; a planar system moves in the x-y plane. markers_at()
// finds the markers at given places of a blade.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spoke/export.h"

namespace spoke {

struct Scenario;

/// A point on the axis of a flexible body; in space also a point of a rigid body, or an interface
/// of a solid.
struct Marker {
  int blade = 0;         ///< from 0; in space subsystems count behind the blades
  int body = 0;          ///< from 0, at the root; in space in the order of `spoke check`
  double station = 0.0;  ///< along the body: 0 at its inboard end, 1 at its outboard end
  Eigen::Vector3d point{0.0, 0.0, 0.0};  ///< on a rigid body, in its frame [m]; else zero
  /// Name of an interface of a solid; empty: the only one that does not carry its frame. Else
  /// empty.
  std::string interface {};

  /// Whether all members are equal.
  friend bool operator==(const Marker&, const Marker&) = default;
};

/// The motion of the cross section of a marker, in the inertial frame. The motion that a load
/// receives includes the foreshortening of bodies with geometric stiffening, along the axes of the
/// undeformed model that turn with the hub: it is the place at which the force does work. So a
/// spring between two markers keeps energy and momentum.
struct MarkerMotion {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
  /// Rotation that takes vectors from the frame of the section to the inertial frame. The x axis of
  /// the section points outward along the deformed axis; in the plane z is that of the inertial
  /// frame; in space the axes are those of the section with its twist, or of a rigid body.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};          ///< [m/s]
  Eigen::Vector3d angular_velocity{0.0, 0.0, 0.0};  ///< [rad/s]
};

/// Motion and deflection of a marker.
struct MarkerState : MarkerMotion {
  Eigen::Vector3d acceleration{0.0, 0.0, 0.0};          ///< [m/s^2]
  Eigen::Vector3d angular_acceleration{0.0, 0.0, 0.0};  ///< [rad/s^2]
  /// Displacement from the place of the marker on the undeformed blade, which turns with the hub
  /// (in space with all joint coordinates zero); hub frame [m].
  Eigen::Vector3d deflection{0.0, 0.0, 0.0};
  /// Foreshortening: a model with geometric stiffening accounts for it in its energies, but not in
  /// its coordinates, from which position, velocity and deflection here come. The sensors of the
  /// tip show the deflection less this; hub frame [m].
  Eigen::Vector3d foreshortening{0.0, 0.0, 0.0};
};

/// A force and a moment.
struct Wrench {
  Eigen::Vector3d force{0.0, 0.0, 0.0};   ///< [N]
  Eigen::Vector3d moment{0.0, 0.0, 0.0};  ///< [N m]
};

/// A load at points of one blade or of several. It becomes a node "load" of the step graph. The
/// node runs in every evaluation of the accelerations, in parallel with all parts of the system
/// that do not depend on it. A load on several blades, such as a damper between two, couples all
/// blades: they then make every evaluation together, as on a free hub, even if the motion of the
/// hub is prescribed. Separate loads for each blade keep them independent.
class SPOKE_EXPORT Load {
 public:
  virtual ~Load() = default;
  /// Returns the name of the load in errors.
  virtual std::string name() const = 0;
  /// Returns the points at which it acts and whose motion it receives: one or more. Called once.
  virtual std::vector<Marker> markers() const = 0;
  /// Sets the force and moment on the body at each marker at time t [s], in the inertial frame, the
  /// moment about the marker. `out` is zero beforehand; both spans are in the order of markers().
  /// Values that are not finite are refused, and in the plane also forces along z and moments about
  /// x and y.
  ///
  /// Must be a function of its arguments alone: a step evaluates it several times, a failed step is
  /// repeated, and different loads run in different threads. An exception that it throws ends the
  /// step with a LoadError.
  virtual void evaluate(double t, std::span<const MarkerMotion> in,
                        std::span<Wrench> out) const = 0;
};

/// The loads of a simulation, in their order.
using Loads = std::vector<std::shared_ptr<const Load>>;

/// Load::evaluate() as a function.
using LoadFunction =
    std::function<void(double t, std::span<const MarkerMotion> in, std::span<Wrench> out)>;

/// Makes a load from a function.
SPOKE_EXPORT std::shared_ptr<const Load> make_load(std::string name, std::vector<Marker> markers,
                                                   LoadFunction function);

/// Returns the markers at distances from the root of a blade [m], in space at stations of its beam;
/// where two bodies meet, the marker is on the inner one. Throws InputError if the scenario has no
/// such blade, counted from 0, or a place is not on it.
SPOKE_EXPORT std::vector<Marker> markers_at(const Scenario& scenario, int blade,
                                            std::span<const double> positions);

}  // namespace spoke
