// Evaluates position, velocity, acceleration and section force at a marker.

#include "engine/bodies/kernels/marker_motion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/plane/handle_motion.h"
#include "engine/bodies/kernels/plane/relative_motion.h"
#include "engine/bodies/plane/nonlinear_strain.h"

namespace spoke {

Eigen::Matrix3d in_space(const plane::Rotation& R) {
  Eigen::Matrix3d matrix;
  matrix << R.cosine, -R.sine, 0.0, R.sine, R.cosine, 0.0, 0.0, 0.0, 1.0;
  return matrix;
}

plane::Pose calc_pose_in_hub(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                             int body) noexcept {
  assert(body >= 0 && std::cmp_less(body, data.bodies.size()));
  plane::Pose pose{subsystem.root.p, data.joints[0].R};
  for (int j = 1; j <= body; ++j) {
    pose.p += pose.R * calc_outboard_position(data.bodies[j - 1]);
    pose.R = pose.R * data.joints[j].R;
  }
  return pose;
}

MarkerMotion calc_marker_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                                const PlacedMarker<Plane>& marker) noexcept {
  const plane::Pose X_HB = calc_pose_in_hub(subsystem, data, marker.body);
  const HubState<Plane>& hub = *data.hub;
  const plane::Rotation R = hub.R * X_HB.R;
  const BodyData<Plane>& body = data.bodies[marker.body];
  const Twist& twist = data.twists[marker.body];
  const Twist q = section_values(marker.section, body.coordinates.q);
  const Twist v = section_values(marker.section, body.coordinates.v);
  const Position s{marker.section.x + q[0], q[1]};
  const double speed = twist[kRotation];
  const Position velocity =
      Position(twist.head<kPosition>()) + speed * quarter_turn(s) + Position(v.head<kPosition>());
  MarkerMotion motion;
  motion.position = in_space(hub.p + hub.R * Position(X_HB.p + X_HB.R * s));
  motion.rotation = in_space(R * plane::Rotation::from_angle(q[kRotation]));
  motion.velocity = in_space(R * velocity);
  motion.angular_velocity.z() = speed + v[kRotation];
  return motion;
}

MarkerMotion calc_load_motion(const Subsystem<Plane>& subsystem, const SubsystemData<Plane>& data,
                              const PlacedMarker<Plane>& marker) noexcept {
  MarkerMotion motion = calc_marker_motion(subsystem, data, marker);
  double length = 0.0, rate = 0.0;
  for (int j = 0; j <= marker.body; ++j) {
    const BodyData<Plane>& body = data.bodies[static_cast<std::size_t>(j)];
    if (!body.model->stiffening) continue;
    const double station = j < marker.body ? 1.0 : marker.section.x / body.model->body->length;
    const plane::Foreshortening drawn = calc_foreshortening(body, station);
    length += drawn.length;
    rate += drawn.rate;
  }
  const HubState<Plane>& hub = *data.hub;
  const Position d = subsystem.root.R * Position{-length, 0.0};
  const Position v = subsystem.root.R * Position{-rate, 0.0};
  motion.position += in_space(Position(hub.R * d));
  motion.velocity +=
      in_space(Position(hub.R * Position(v + hub.twist[kRotation] * quarter_turn(d))));
  return motion;
}

Twist calc_marker_acceleration(const Position& gravity, const SubsystemData<Plane>& data,
                               const PlacedMarker<Plane>& marker) noexcept {
  assert(std::cmp_less(marker.body, data.bodies.size()) && data.bodies[marker.body].a_found);
  const BodyData<Plane>& body = data.bodies[marker.body];
  const plane::Rotation R = data.hub->R * calc_rotation_to_hub(data, marker.body);
  const Twist q = section_values(marker.section, body.coordinates.q);
  const Twist v = section_values(marker.section, body.coordinates.v);
  const Twist a = section_values(marker.section, body.a_found);
  const Position s{marker.section.x + q[0], q[1]};
  const double w = data.twists[marker.body][kRotation];
  const Position local = Position(body.X.head<kPosition>()) + body.X[kRotation] * quarter_turn(s) -
                         w * w * s + 2.0 * w * quarter_turn(v.head<kPosition>()) +
                         Position(a.head<kPosition>());
  const Position acceleration = gravity + Position(R * local);
  return {acceleration.x(), acceleration.y(), body.X[kRotation] + a[kRotation]};
}

Position calc_marker_foreshortening(const Subsystem<Plane>& subsystem,
                                    const SubsystemData<Plane>& data, int body, double station) {
  assert(body >= 0 && std::cmp_less(body, data.bodies.size()));
  assert(station >= 0.0 && station <= 1.0);
  Position sum = Position::Zero();
  for (int j = 0; j <= body; ++j) {
    const BodyData<Plane>& member = data.bodies[j];
    if (!member.model->stiffening.slope_integral) continue;
    const double shortened =
        j < body ? calc_foreshortening(member) : calc_foreshortening(member, station).length;
    sum += calc_pose_in_hub(subsystem, data, j).R * Position{shortened, 0.0};
  }
  return sum;
}

namespace {

/// Strain of the axis, its curvature and the change of that along it, at a section; damping and
/// that of modes count as strain.
struct SectionStrain {
  double axial, curvature, change;
};

SectionStrain calc_linear_strain(double stiffness_factor, const double* modal,
                                 const BodyData<Plane>& body, const plane::Section& section) {
  const auto damped = [&](double own, const auto& shape, const auto& places) {
    const double strain =
        plane::value_at(shape, places, body.coordinates.q) +
        (stiffness_factor + own) * plane::value_at(shape, places, body.coordinates.v);
    return modal ? strain + plane::value_at(shape, places, modal) : strain;
  };
  const plane::StrainDamping& own = body.model->body->damping;
  return {damped(own.axial, section.strain, section.axial_at),
          damped(own.bending, section.curvature, section.bending_at),
          damped(own.bending, section.curvature_change, section.bending_at)};
}

/// Of second order: that of its element, whose outer node moves by d against the inner section.
SectionStrain calc_nonlinear_strain(double stiffness_factor, const double* modal,
                                    const BodyData<Plane>& body, const plane::Section& section) {
  const plane::FlexibleBody& model = *body.model->body;
  const double l = model.length / model.elements;
  const int e = std::min(static_cast<int>(section.x / l), model.elements - 1);
  Twist d = calc_strain(model, body.layout, e, body.coordinates.q);
  const Twist rate =
      calc_strain_rate(model, body.layout, e, body.coordinates.q, body.coordinates.v);
  d[0] += (stiffness_factor + model.damping.axial) * rate[0];
  d.tail<2>() += (stiffness_factor + model.damping.bending) * rate.tail<2>();
  const auto bent = [&](const std::array<double, 4>& shape) {
    const double strain = shape[2] * d[1] + shape[3] * d[2];
    return modal ? strain + plane::value_at(shape, section.bending_at, modal) : strain;
  };
  const double stretch = modal ? plane::value_at(section.strain, section.axial_at, modal) : 0.0;
  return {d[0] / l + stretch, bent(section.curvature), bent(section.curvature_change)};
}

}  // namespace

Twist calc_section_force(const Blade& blade, const Damping& damping, const double* modal,
                         const BodyData<Plane>& body, const plane::Section& section) noexcept {
  const double factor = damping.stiffness_factor;
  const SectionStrain strain = has_nonlinear_strain(body)
                                   ? calc_nonlinear_strain(factor, modal, body, section)
                                   : calc_linear_strain(factor, modal, body, section);
  double axial_stiffness = blade.youngs_modulus * blade.area;
  double bending_stiffness = blade.youngs_modulus * blade.second_moment;
  double stiffness_slope = 0.0;
  const std::vector<plane::BeamPiece>& pieces = body.model->body->pieces;
  if (!pieces.empty()) {
    const plane::BeamPiece& piece = piece_at(pieces, section.x);
    axial_stiffness = piece.at(piece.axial_stiffness, section.x);
    bending_stiffness = piece.at(piece.bending_stiffness, section.x);
    stiffness_slope = piece.slope(piece.bending_stiffness);
  }
  // The shear force is -(EI v'')'.
  const double shear = -bending_stiffness * strain.change;
  return {axial_stiffness * strain.axial, shear - stiffness_slope * strain.curvature,
          bending_stiffness * strain.curvature};
}

}  // namespace spoke
