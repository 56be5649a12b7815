#pragma once

// The places where the loads of a rotor act on its bodies.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "models/plane/plane.h"
#include "models/rotor.h"
#include "models/space/space.h"
#include "models/spatial_model.h"

namespace spoke {

/// A point of a body at which a load acts, by the shape functions there.
struct LoadPoint {
  int element = 0;      ///< element of the body
  double s = 0.0;       ///< place within the element, 0 at its inboard end, 1 at the outboard end
  double x = 0.0;       ///< undeformed place in the body frame [m]
  double weight = 1.0;  ///< 1 for a point load, else the length that the point stands for [m]
  /// Ends of the stretch over which the point's Gauss rule goes, for a load per length, in the body
  /// frame [m]; zero for a point load.
  std::array<double, 2> stretch{};

  bool is_per_length() const { return stretch[1] > stretch[0]; }
};

/// The course of a load over time.
struct LoadCourse {
  Curve factor;
  double ramp = 0.0;   ///< [s]
  std::string name{};  ///< of the load; may be empty
  double scale = 1.0;  ///< factor that the embedding program has set

  double value(double t) const { return factor.value(t) * calc_rise(t, ramp) * scale; }
};

/// A force and a moment on one body, as they act at each of its points, times weight and course.
template <class World>
struct BodyLoad {
  std::vector<LoadPoint> points;
  LoadFrame frame = LoadFrame::hub;
  PositionOf<World> force = PositionOf<World>::Zero();  ///< [N], or [N/m]
  AngularOf<World> moment{};                            ///< [N m], or [N]
  std::shared_ptr<LoadCourse> course;                   ///< shared by the copies of a load
};

/// A force and a moment on one body in space.
template <>
struct BodyLoad<Space> {
  /// A point where the load acts, as LoadPoint; on a rigid body it is `place` in the body's frame
  /// [m], on a solid the place of that number (`element`).
  struct Point {
    int element = 0;
    double s = 0.0;
    double weight = 1.0;
    space::Position place = space::Position::Zero();
    /// Ends of the stretch within the element over which the point's Gauss rule goes, and the
    /// beam's length between them [m], for a load per length; zero for a point load.
    double begin = 0.0, end = 0.0;
    double length = 0.0;
  };
  std::vector<Point> points;
  /// Frame in which force and moment are resolved: hub is H, body is B, section the axes of the
  /// loaded section.
  spatial::LoadFrame frame = spatial::LoadFrame::hub;
  space::Position force = space::Position::Zero();  ///< [N], or [N/m]
  space::Angular moment = space::Angular::Zero();   ///< [N m], or [N]
  std::shared_ptr<LoadCourse> course;               ///< shared by the copies of a load
};

/// Drag on one body, as it acts at each of its points, times weight and course.
template <class World>
struct BodyDrag {
  std::vector<LoadPoint> points;
  DragFrame relative_to = DragFrame::inertial;
  double linear = 0.0;                 ///< [N s/m], or [N s/m^2]
  double quadratic = 0.0;              ///< [N s^2/m^2], or [N s^2/m^3]
  std::shared_ptr<LoadCourse> course;  ///< shared by the copies of a load
};

/// The loads and drags on one body.
template <class World>
struct BodyLoads {
  std::vector<BodyLoad<World>> loads;
  std::vector<BodyDrag<World>> drags;
};

/// Makes the loads and drags of a rotor on the bodies of blade `index`, root to tip. Loads per
/// length act at the points of Gauss's rule of four in each element, or part of one: with the shape
/// functions, that integrates a constant load and linear drag exactly.
std::vector<BodyLoads<Plane>> make_body_loads(const Rotor& rotor, std::size_t index);

}  // namespace spoke
