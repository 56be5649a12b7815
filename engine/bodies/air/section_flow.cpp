// The plane of a section, in which alone flow counts: what goes along the blade does not.

#include "engine/bodies/air/section_flow.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace spoke::air {
namespace {

/// Flow in the axes of the chord [m/s].
struct ChordFlow {
  double along;   // from the leading to the trailing edge
  double normal;  // from the lower side to that of suction

  ChordFlow(const SectionAxes& axes, double axial, double ahead)
      : along(ahead * axes.pitch_cosine - axial * axes.pitch_sine),
        normal(axes.find_across(axial, ahead)) {}
};

}  // namespace

double SectionAxes::find_attack(double axial_flow, double ahead) const noexcept {
  if (axial_flow == 0.0 && ahead == 0.0) return 0.0;  // whatever the signs of the zeros
  const ChordFlow flow(*this, axial_flow, ahead);
  return std::atan2(flow.normal, flow.along);
}

SectionAxes find_axes(const RotorPlace& rotor, const MarkerMotion& section, double sine,
                      double cosine, double side) noexcept {
  constexpr double least_projection = 1e-6;
  const auto along = section.rotation.col(0);
  SectionAxes axes;
  axes.axial = rotor.axis - along.dot(rotor.axis) * along;
  const double size = axes.axial.norm();
  if (size > least_projection)
    axes.axial /= size;
  else  // a blade along the rotor's axis
    axes.axial = section.rotation.col(2);
  axes.tangential = side * axes.axial.cross(along);
  axes.chord = (side * cosine) * section.rotation.col(1) + sine * section.rotation.col(2);
  axes.nose_up = side * along;
  axes.pitch_sine = axes.chord.dot(axes.axial);
  axes.pitch_cosine = axes.chord.dot(axes.tangential);
  const Eigen::Vector3d arm = section.position - rotor.center;
  axes.outward = arm - arm.dot(rotor.axis) * rotor.axis;
  axes.radius = axes.outward.norm();
  if (axes.radius > 0.0) axes.outward /= axes.radius;
  axes.around = axes.radius > 0.0 ? side * rotor.axis.cross(axes.outward) : axes.tangential;
  return axes;
}

SectionFlow find_flow(const SectionAxes& axes, const MarkerMotion& section,
                      const Eigen::Vector3d& wind, double ahead, double in_plane) noexcept {
  const Eigen::Vector3d flow =
      wind - section.velocity - section.angular_velocity.cross(ahead * axes.chord);
  const double size = wind.lpNorm<Eigen::Infinity>() + section.velocity.lpNorm<Eigen::Infinity>();
  return {without_rounding(flow.dot(axes.axial), size),
          without_rounding(-flow.dot(axes.tangential), size), in_plane};
}

double find_rise(const SectionAxes& axes, const MarkerMotion& section, double chord) noexcept {
  return 0.5 * chord * section.angular_velocity.dot(axes.nose_up);
}

double find_turning_angle(const SectionAxes& axes, const SectionFlow& flow, double rise) noexcept {
  if (rise == 0.0) return 0.0;
  const ChordFlow at_quarter(axes, flow.axial, flow.ahead);
  const double along = at_quarter.along, normal = at_quarter.normal;
  return std::atan2(rise * along, along * along + normal * (normal + rise));
}

double calc_turning_moment(double turning, double attached) noexcept {
  return -0.5 * std::numbers::pi * attached * turning;
}

}  // namespace spoke::air
