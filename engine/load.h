#pragma once

// Loads of the user's own: forces and moments at markers, as a function of time and of the markers'
// motion. Vectors are three-dimensional; a planar system moves in the x-y plane.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spoke/export.h"

namespace spoke {

/// A point on the axis of a flexible body.
struct Marker {
  int blade = 0;         ///< from 0
  int body = 0;          ///< from 0, at the root
  double station = 0.0;  ///< along the body: 0 at its inboard end, 1 at its outboard end

  /// Whether all three are equal.
  friend bool operator==(const Marker&, const Marker&) = default;
};

/// The motion of a marker's cross section, in the inertial frame.
struct MarkerMotion {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
  /// Takes vectors from the section's frame (x along the deformed axis, outward; z as the inertial
  /// one) to the inertial frame.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};          ///< [m/s]
  Eigen::Vector3d angular_velocity{0.0, 0.0, 0.0};  ///< [rad/s]
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
  /// about the marker. `out` is zero beforehand; both spans are in the order of markers(). Forces
  /// along z and moments about x and y, and values that are not finite, are refused.
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

}  // namespace spoke
