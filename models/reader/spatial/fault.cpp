// Rules for numbers, directions, tensors and names.

#include "models/reader/spatial/fault.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>

#include "models/reader/names.h"

namespace spoke::spatial {

Fault Fault::within(const std::string& key) const {
  return {path.empty() || key.empty() ? key + path : key + '.' + path, text};
}

void FirstFault::operator()(std::string_view key, double value, const Quantity& quantity,
                            Presence) const {
  const std::string expected = quantity.expectation_instead_of(value);
  if (!expected.empty())
    add({std::string(key), "is " + describe(value) + ", expected " + expected});
}

void FirstFault::operator()(std::string_view key, int value, const Count& count, Presence) const {
  if (!count.holds(value))
    add({std::string(key), "is " + std::to_string(value) + ", expected " + count.expectation()});
}

void FirstFault::operator()(std::string_view key, const Vector& value, const Quantity& quantity,
                            Presence) const {
  numbers(key, {value.x(), value.y(), value.z()}, quantity);
}

void FirstFault::numbers(std::string_view key, const std::vector<double>& values,
                         const Quantity& quantity) const {
  for (std::size_t i = 0; i < values.size(); ++i)
    (*this)(std::string(key) + '.' + std::to_string(i + 1), values[i], quantity);
}

Fault find_direction_fault(const std::string& key, const Vector& direction) {
  if (direction.norm() > 0.0) return {};
  return {key, "has length 0, expected a direction"};
}

Fault find_inertia_fault(const std::string& key, const Tensor& inertia, MayBeZero may_be_zero) {
  constexpr double slack = 1e-9;
  if (!inertia.allFinite()) return {key, "is not finite, expected moments of inertia (kg m^2)"};
  if (!inertia.isApprox(inertia.transpose(), slack))
    return {key, "is not symmetric, expected an inertia tensor (kg m^2)"};
  if (may_be_zero == MayBeZero::yes && inertia.isZero(0.0)) return {};
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Tensor>(inertia).eigenvalues();
  std::ostringstream text;
  text << "has the principal moments " << moments[0] << ", " << moments[1] << " and " << moments[2]
       << " kg m^2, ";
  const std::string found = text.str();
  if (may_be_zero == MayBeZero::no && moments[0] <= 1e-12 * moments[2])
    return {key, found + "expected all of them greater than 0"};
  if (moments[0] < -slack * moments[2]) return {key, found + "expected none below 0"};
  if (moments[2] > (moments[0] + moments[1]) * (1.0 + slack))
    return {key, found + "expected none greater than the sum of the others, as of a real body"};
  return {};
}

Fault find_curve_fault(const std::string& key, const Curve& curve, const Quantity& quantity) {
  const FirstFault first;
  first.numbers(key + ".time", curve.times(), kTime);
  first.numbers(key, curve.values(), quantity);
  return first.found();
}

Fault find_name_fault(const std::string& name) {
  if (is_name(name)) return {};
  return {"name", "is \"" + name + "\", expected " + kNameExpected};
}

}  // namespace spoke::spatial
