// Finds how shapes turn by the motion of nodes.

#include "engine/small_motions/vibration/shaft_turn.h"

#include <algorithm>
#include <cmath>

#include "engine/support/dense.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kExact = 1e-6;  ///< of shapes, which are differences, by their size

/// Whether all nodes of a subsystem are on the hub's axis in equilibrium.
bool is_on_axis(std::size_t i, double length, const Linearised& all) {
  steady::SubsystemResponse response;
  all.model.evaluate(i, make_state(all.equilibrium, i), all.model.no_offset(), response);
  const std::vector<steady::NodePlace> places = all.model.places(i);
  return std::all_of(places.begin(), places.end(), [length](const steady::NodePlace& place) {
    return std::hypot(place.p.x(), place.p.y()) <= kExact * length;
  });
}

/// Returns displacements and rotations of all nodes, the latter by a length, in columns by
/// independent coordinate.
MatrixXd list_shapes(std::size_t i, double length, const Linearised& all) {
  const Index n = all.linear.subsystem(i).M.rows();
  MatrixXd shapes;
  for (Index k = 0; k < n; ++k) {
    const Eigen::VectorXcd unit = VectorXd(VectorXd::Unit(n, k)).cast<std::complex<double>>();
    const Eigen::VectorXcd x =
        all.linear.motion_of(i, unit, Eigen::VectorXcd::Zero(all.linear.M.rows()));
    const SubsystemShape shape = calc_subsystem_shape(i, all.equilibrium.q[i], x, all.model);
    if (k == 0) shapes.resize(6 * std::ssize(shape.nodes), n);
    for (std::size_t node = 0; node < shape.nodes.size(); ++node) {
      const Index at = 6 * static_cast<Index>(node);
      shapes.block<3, 1>(at, k) = shape.nodes[node].real();
      shapes.block<3, 1>(at + 3, k) = length * shape.rotations[node].real();
    }
  }
  return shapes;
}

/// Returns the derivative of shapes by the angle at which they are turned about z.
MatrixXd turn_shapes(const MatrixXd& shapes) {
  MatrixXd turned = MatrixXd::Zero(shapes.rows(), shapes.cols());
  for (Index at = 0; at < shapes.rows(); at += 3) {
    turned.row(at) = -shapes.row(at + 1);
    turned.row(at + 1) = shapes.row(at);
  }
  return turned;
}

/// Takes entries that are whole numbers but for the error of differences for these.
void settle(MatrixXd& G) {
  for (Index k = 0; k < G.size(); ++k) {
    double& entry = G.data()[k];
    const double whole = std::round(entry);
    if (std::abs(entry - whole) < kExact) entry = whole;
  }
}

}  // namespace

MatrixXd find_turn(std::size_t subsystem, const Linearised& all) {
  if (!all.model.is_spatial() || all.linear.subsystem(subsystem).M.rows() == 0) return {};
  double length = 0.0;
  for (const steady::SubsystemCoordinate& coordinate : all.model.coordinates(subsystem))
    if (!coordinate.turns) length = std::max(length, coordinate.scale);
  if (!(length > 0.0)) length = 1.0;
  if (!is_on_axis(subsystem, length, all)) return {};
  const MatrixXd shapes = list_shapes(subsystem, length, all);
  const VectorXd size = shapes.colwise().norm();
  if (!(size.minCoeff() > 0.0)) return {};
  const MatrixXd scaled = shapes * size.cwiseInverse().asDiagonal(), turned = turn_shapes(scaled);
  LeastSquares least;
  least.compute(scaled);
  if (least.rank() < scaled.cols()) return {};
  MatrixXd G(scaled.cols(), scaled.cols());
  for (Index k = 0; k < scaled.cols(); ++k) G.col(k) = least.solve(turned.col(k));
  if (!((scaled * G - turned).colwise().norm().maxCoeff() < kExact)) return {};
  G = (size.cwiseInverse().asDiagonal() * G * size.asDiagonal()).eval();
  settle(G);
  return G;
}

MatrixXd turn_by(const MatrixXd& G, double psi) {
  return MatrixXd::Identity(G.rows(), G.cols()) + std::sin(psi) * G + (1.0 - std::cos(psi)) * G * G;
}

steady::LinearSubsystem stand_shaft(const steady::LinearSubsystem& turning, const MatrixXd& G,
                                    double speed) {
  const MatrixXd W = speed * G, size = W.cwiseAbs();
  const SecondOrder all = stand_columns({turning.M, turning.C, turning.K}, W);
  steady::LinearSubsystem standing = turning;
  standing.C = all.C;
  standing.K = all.K;
  standing.K_terms =
      (turning.K_terms.size() > 0 ? turning.K_terms : MatrixXd(turning.K.cwiseAbs())) +
      turning.C.cwiseAbs() * size + turning.M.cwiseAbs() * size * size;
  return standing;
}

steady::SizedMatrices stand_shaft_at(double psi, const steady::LinearSubsystem& turning,
                                     const MatrixXd& G, double speed) {
  const steady::LinearSubsystem own = stand_shaft(turning, G, speed);
  const MatrixXd back = turn_by(G, -psi);
  return {back.transpose() * own.M * back, back.transpose() * own.C * back,
          back.transpose() * own.K * back, own.K_terms};
}

}  // namespace spoke::vibration
