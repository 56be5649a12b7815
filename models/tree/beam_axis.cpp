// Places, tangents and axes along a beam.

#include "models/tree/beam_axis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "models/tree/by_station.h"

namespace spoke::spatial {
namespace {

std::optional<Curve> make_curve(const Sections& sections, const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Curve(sections.station, values);
}

}  // namespace

BeamAxis::BeamAxis(const Sections& sections)
    : station_(sections.station),
      twist_(sections.twist),
      sweep_(make_curve(sections, sections.sweep)),
      prebend_(make_curve(sections, sections.prebend)) {}

Vector BeamAxis::place(double x) const {
  return {x, sweep_ ? sweep_->value(x) : 0.0, prebend_ ? prebend_->value(x) : 0.0};
}

Vector BeamAxis::tangent(double x) const {
  return {1.0, sweep_ ? sweep_->derivative(x) : 0.0, prebend_ ? prebend_->derivative(x) : 0.0};
}

double BeamAxis::stretch(double x) const { return tangent(x).norm(); }

Tensor BeamAxis::axes(double x) const {
  const double twist = twist_.empty() ? 0.0 : ByStation(station_, x).of(twist_);
  return smallest_rotation(Vector::UnitX(), tangent(x)) * rotation_of(twist * Vector::UnitX());
}

Tensor smallest_rotation(const Vector& from, const Vector& to) {
  const Vector a = from.normalized(), b = to.normalized();
  const double cosine = a.dot(b);
  if (cosine < -1.0 + 1e-14) {
    const Vector x = Vector::UnitX();
    const bool is_along_x = std::abs(a.dot(x)) > 0.5;
    const Vector axis = a.cross(a.cross(is_along_x ? Vector(Vector::UnitZ()) : x)).normalized();
    return 2.0 * axis * axis.transpose() - Tensor::Identity();
  }
  const Vector cross = a.cross(b);
  Tensor skew;
  skew << 0.0, -cross.z(), cross.y(), cross.z(), 0.0, -cross.x(), -cross.y(), cross.x(), 0.0;
  return Tensor::Identity() + skew + skew * skew / (1.0 + cosine);
}

Tensor rotation_of(const Vector& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Tensor::Identity();
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

}  // namespace spoke::spatial
