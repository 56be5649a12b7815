// Moves the model along a mode, and observes the motion of its nodes.

#include "engine/small_motions/vibration/mode_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "models/space/rotation_vector.h"

namespace spoke::vibration {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using steady::NodePlace;
using steady::SteadyModel;

std::vector<NodePlace> places_at(std::size_t subsystem, const VectorXd& q, SteadyModel& model) {
  steady::SubsystemResponse response;
  model.evaluate(subsystem, steady::make_state(q), model.no_offset(), response);
  return model.places(subsystem);
}

/// Motion of a node by a unit of a direction.
struct NodeMotion {
  Vector3d p = Vector3d::Zero();
  Vector3d centre = Vector3d::Zero();  ///< of the centre of its mass
  Vector3d rotation = Vector3d::Zero();
};

std::vector<NodeMotion> move(std::size_t subsystem, const VectorXd& q, const VectorXd& direction,
                             SteadyModel& model) {
  double largest = 0.0;
  const auto& coordinates = model.coordinates(subsystem);
  for (Eigen::Index k = 0; k < direction.size(); ++k)
    largest =
        std::max(largest, std::abs(direction[k]) / coordinates[static_cast<std::size_t>(k)].scale);
  std::vector<NodeMotion> motions;
  const double h = largest > 0.0 ? 1e-5 / largest : 0.0;
  const std::vector<NodePlace> ahead = places_at(subsystem, q + h * direction, model);
  const std::vector<NodePlace> behind = places_at(subsystem, q - h * direction, model);
  for (std::size_t k = 0; k < ahead.size(); ++k) {
    if (h == 0.0) {
      motions.emplace_back();
      continue;
    }
    const space::Rotation turn{ahead[k].axes * behind[k].axes.transpose()};
    motions.push_back({(ahead[k].p - behind[k].p) / (2.0 * h),
                       (ahead[k].centre - behind[k].centre) / (2.0 * h),
                       Vector3d(space::logarithm(turn)) / (2.0 * h)});
  }
  return motions;
}

/// Returns c_n = mean of a_b exp(-i n psi_b).
std::complex<double> calc_multiple(const VectorXcd& amplitudes, const std::vector<double>& azimuths,
                                   int n) {
  std::complex<double> sum = 0.0;
  for (std::size_t b = 0; b < azimuths.size(); ++b)
    sum += amplitudes[static_cast<Eigen::Index>(b)] * std::polar(1.0, -n * azimuths[b]);
  return sum / static_cast<double>(azimuths.size());
}

std::string name_multiple(int n, int subsystems) {
  if (n == 0) return "collective";
  if (2 * std::abs(n) == subsystems) return "differential";
  // exp(i (w t + n psi)) goes round towards smaller azimuths if n > 0.
  const std::string sense = n > 0 ? "regressive" : "progressive";
  return std::abs(n) == 1 ? sense : sense + " order " + std::to_string(std::abs(n));
}

}  // namespace

SubsystemShape calc_subsystem_shape(std::size_t subsystem, const VectorXd& q, const VectorXcd& x,
                                    SteadyModel& model) {
  const std::vector<NodeMotion> real = move(subsystem, q, x.real(), model);
  const std::vector<NodeMotion> imag = move(subsystem, q, x.imag(), model);
  const std::vector<NodePlace> places = places_at(subsystem, q, model);
  constexpr std::complex<double> i(0.0, 1.0);
  SubsystemShape shape;
  for (VectorXcd& motion : shape.motions) motion.resize(std::ssize(places));
  shape.weighed.resize(6 * std::ssize(places));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    shape.bodies.push_back(places[k].body);
    shape.nodes.push_back(real[k].p + i * imag[k].p);
    shape.rotations.push_back(real[k].rotation + i * imag[k].rotation);
    const Eigen::Matrix3d to_root = model.root_axes(subsystem, places[k].body).transpose();
    const Eigen::Vector3cd displacement = real[k].centre + i * imag[k].centre;
    const Eigen::Vector3cd centre = to_root.cast<std::complex<double>>() * displacement;
    shape.weighed.segment<3>(6 * at) = std::sqrt(places[k].mass) * displacement;
    shape.weighed.segment<3>(6 * at + 3) = std::sqrt(places[k].inertia) * shape.rotations.back();
    const std::complex<double> twist =
        to_root.row(0).cast<std::complex<double>>() * shape.rotations.back();
    for (std::size_t c = 0; c < 3; ++c)
      shape.motions[c][at] = std::sqrt(places[k].mass) * centre[static_cast<Eigen::Index>(c)];
    shape.motions[3][at] = std::sqrt(places[k].inertia) * twist;
  }
  const auto& coordinates = model.coordinates(subsystem);
  for (const SolidDeformation& solid : model.solids(subsystem)) {
    const auto own = steady::find_deformation(coordinates, solid.body, x);
    shape.solids.emplace_back(Eigen::Map<const VectorXcd>(own.data(), std::ssize(own)));
  }
  for (std::size_t c = 0; c < 4; ++c) shape.energies[c] = shape.motions[c].squaredNorm();
  return shape;
}

std::string KindNames::find_direction(const std::array<double, 4>& energies) {
  constexpr double kAlike = 1e-4;
  static constexpr const char* kKinds[] = {"axial", "lag", "flap", "torsion"};
  const auto most = std::max_element(energies.begin(), energies.end()) - energies.begin();
  const double lag = energies[1], flap = energies[2];
  const bool is_whirl = (most == 1 || most == 2) && std::abs(lag - flap) <= kAlike * (lag + flap);
  if (!is_whirl) return kKinds[most];
  is_second_ = !is_second_;
  return is_second_ ? "flap" : "lag";
}

std::string KindNames::name(const std::vector<steady::SubsystemCoordinate>& coordinates,
                            const VectorXcd& x, const Eigen::MatrixXd& mass,
                            const SubsystemShape& shape) {
  const auto energy = [&mass](const VectorXcd& y) {
    return y.real().dot(mass * y.real()) + y.imag().dot(mass * y.imag());
  };
  // Of several subsystems that are tied, joints of one name go together.
  std::map<std::string, VectorXcd> by_joint;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const steady::SubsystemCoordinate& coordinate = coordinates[static_cast<std::size_t>(k)];
    if (coordinate.node >= 0) continue;
    VectorXcd& only =
        by_joint.try_emplace(coordinate.joint, VectorXcd::Zero(x.size())).first->second;
    only[k] = x[k];
  }
  const std::string kind = find_direction(shape.energies);
  for (const auto& [joint, only] : by_joint)
    if (energy(only) > 0.5 * energy(x))
      return joint.find(kind) == std::string::npos ? joint + ' ' + kind : joint;
  return kind;
}

std::string name_pattern(const std::vector<VectorXcd>& subsystems,
                         const std::vector<double>& azimuths) {
  if (subsystems.size() < 2) return {};
  const auto most =
      std::max_element(subsystems.begin(), subsystems.end(),
                       [](const auto& a, const auto& b) { return a.norm() < b.norm(); });
  const int count = static_cast<int>(subsystems.size());
  VectorXcd amplitudes(count);
  double explained = 0.0, all = 0.0;
  for (int b = 0; b < count; ++b) {
    const VectorXcd& x = subsystems[static_cast<std::size_t>(b)];
    if (x.size() != most->size()) return {};
    amplitudes[b] = most->dot(x) / most->squaredNorm();
    explained += std::norm(amplitudes[b]) * most->squaredNorm();
    all += x.squaredNorm();
  }
  if (explained < 0.9 * all) return {};
  int best = 0, second = 0;
  double largest = -1.0, next = -1.0;
  for (int n = -((count - 1) / 2); n <= count / 2; ++n) {
    const double size = std::norm(calc_multiple(amplitudes, azimuths, n));
    if (size > largest) {
      next = largest;
      second = best;
      largest = size;
      best = n;
    } else if (size > next) {
      next = size;
      second = n;
    }
  }
  const double sum = amplitudes.squaredNorm() / count;
  if (largest > 0.75 * sum) return name_multiple(best, count);
  if (best != -second || largest + next < 0.75 * sum) return {};
  // Both senses are equally large: a standing pattern. It is named cosine where the first subsystem
  // moves more than it would in a sine.
  const int n = std::abs(best);
  const std::complex<double> plus = calc_multiple(amplitudes, azimuths, n);
  const std::complex<double> minus = calc_multiple(amplitudes, azimuths, -n);
  const std::string name = std::abs(plus + minus) >= std::abs(plus - minus) ? "cosine" : "sine";
  return n == 1 ? name : name + " order " + std::to_string(n);
}

}  // namespace spoke::vibration
