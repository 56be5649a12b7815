// Assembles the matrices of whole beams, and takes their modes apart again body by body.

#include "models/system/beam_modes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "models/plane/beam_elements.h"
#include "models/plane/beam_properties.h"
#include "models/solid/cholesky.h"
#include "models/solid/vibration.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using solid::Sparse;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds a matrix at these rows and columns, but for those of negative numbers.
template <class Matrix, class Coordinate>
void add(const Matrix& matrix, const Coordinate& coordinate, Triplets& sum) {
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Index j = 0; j < matrix.cols(); ++j) {
      const int row = coordinate(i), column = coordinate(j);
      if (row >= 0 && column >= 0 && matrix(i, j) != 0.0)
        sum.emplace_back(row, column, matrix(i, j));
    }
}

Sparse make_sparse(Index size, const Triplets& entries) {
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Finds modes of matrices over all coordinates but those of the root, `per_node` of them.
BeamModes find_modes_of(const Sparse& M, const Sparse& K, Index per_node,
                        const ModeDamping& damping) {
  const auto damped = static_cast<Index>(damping.ratios.size());
  assert(damped > 0 && damped <= M.rows());
  const solid::Cholesky factor(K);
  assert(factor.is_definite());
  solid::ModeChoice choice;
  choice.count = static_cast<int>(std::min(damped + 1, M.rows()));
  const solid::VibrationModes found = solid::find_modes(
      M, [&](const MatrixXd& f) { return factor.solve(f); }, MatrixXd(M.rows(), 0), choice);
  BeamModes modes;
  if (found.squares.size() > damped)
    modes.stiffness_factor =
        2.0 * damping.above.value_or(damping.ratios.back()) / std::sqrt(found.squares[damped]);
  modes.shapes = MatrixXd::Zero(per_node + M.rows(), damped);
  modes.shapes.bottomRows(M.rows()) = found.shapes.leftCols(damped);
  for (Index k = 0; k < damped; ++k) {
    const double square = found.squares[k], W = std::sqrt(square);
    modes.frequencies.push_back(W);
    modes.factors.push_back(2.0 * damping.ratios[static_cast<std::size_t>(k)] * W -
                            modes.stiffness_factor * square);
  }
  return modes;
}

/// Makes a share of the forces K phi on a body's coordinates; K: of the body.
ModalShare make_share(const BeamModes& modes, MatrixXd forces, const Sparse& K) {
  ModalShare share;
  for (Index k = 0; k < forces.cols(); ++k) {
    const double W = modes.frequencies[static_cast<std::size_t>(k)];
    forces.col(k) /= W * W;
  }
  share.shapes = solid::Cholesky(K).solve(forces);
  share.weights = std::move(forces);
  return share;
}

// In space.

/// Returns the matrix over the coordinates that `coordinate(node, component)` counts from 0.
template <class Coordinate>
Sparse make_sparse(Index size, const space::BlockTridiagonal& matrix,
                   const Coordinate& coordinate) {
  Triplets entries;
  for (int k = 0; k < matrix.nodes(); ++k) {
    const auto node = static_cast<std::size_t>(k);
    add(
        matrix.diagonal[node], [&](Index c) { return coordinate(k, static_cast<int>(c)); },
        entries);
    if (k + 1 == matrix.nodes()) continue;
    Eigen::Matrix<double, 2 * space::kTwist, 2 * space::kTwist> coupling;
    coupling.setZero();
    coupling.bottomLeftCorner<space::kTwist, space::kTwist>() = matrix.below[node];
    coupling.topRightCorner<space::kTwist, space::kTwist>() = matrix.below[node].transpose();
    add(
        coupling,
        [&](Index c) {
          const int component = static_cast<int>(c) % space::kTwist;
          return coordinate(k + static_cast<int>(c) / space::kTwist, component);
        },
        entries);
  }
  return make_sparse(size, entries);
}

/// Turns the displacements and rotations of all nodes.
MatrixXd turn(const space::Rotation& rotation, const MatrixXd& shapes) {
  MatrixXd turned(shapes.rows(), shapes.cols());
  for (Index row = 0; row < shapes.rows(); row += 3)
    turned.middleRows<3>(row) = rotation.axes * shapes.middleRows<3>(row);
  return turned;
}

}  // namespace

BeamModes find_damped_modes(const space::Beam& beam, const std::vector<double>& nodes,
                            const ModeDamping& damping) {
  const space::FlexibleBody whole = make_beam_body(beam, nodes, ReferenceFrame::clamped, {0});
  const auto free = [](int node, int c) { return space::kTwist * (node - 1) + c; };
  const auto held = [&](int node, int c) { return node == 0 ? -1 : free(node, c); };
  const Index size = whole.coordinates();
  BeamModes modes = find_modes_of(make_sparse(size, whole.M, held),
                                  make_sparse(size, whole.K, held), space::kTwist, damping);
  modes.shapes = turn(whole.pose.R, modes.shapes);
  return modes;
}

ModalShare make_modal_share(const BeamModes& modes, const space::FlexibleBody& body, int node) {
  constexpr int d = space::kTwist;
  const Index rows = Index{d} * body.node_count();
  assert(node >= 0 && Index{d} * node + rows <= modes.shapes.rows());
  const MatrixXd phi = turn(body.pose.R.inverse(), modes.shapes.middleRows(Index{d} * node, rows));
  MatrixXd on_nodes = MatrixXd::Zero(rows, phi.cols());
  for (int k = 0; k < body.node_count(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    on_nodes.middleRows<d>(d * k) += body.K.diagonal[at] * phi.middleRows<d>(d * k);
    if (k == body.elements) continue;
    on_nodes.middleRows<d>(d * k) += body.K.below[at].transpose() * phi.middleRows<d>(d * (k + 1));
    on_nodes.middleRows<d>(d * (k + 1)) += body.K.below[at] * phi.middleRows<d>(d * k);
  }
  MatrixXd forces(body.coordinates(), phi.cols());
  for (int k = 0; k < body.node_count(); ++k)
    for (int c = 0; c < d; ++c)
      if (const int at = body.coordinate(k, c); at >= 0) forces.row(at) = on_nodes.row(d * k + c);
  return make_share(
      modes, std::move(forces),
      make_sparse(body.coordinates(), body.K, [&](int k, int c) { return body.coordinate(k, c); }));
}

// In the plane.

namespace {

/// Calls visit(e, element) for the elements of one body of a blade.
template <class Visit>
void visit_elements(const Blade& blade, int j, const Visit& visit) {
  const std::vector<plane::BeamElement> elements =
      make_beam_elements(plane::make_beam_properties(blade, j));
  for (int e = 0; e < blade.elements; ++e)
    visit(e, elements[std::min(static_cast<std::size_t>(e), elements.size() - 1)]);
}

}  // namespace

BeamModes find_damped_modes(const Blade& blade, const ModeDamping& damping) {
  Triplets mass, stiffness;
  for (int j = 0; j < blade.bodies; ++j)
    visit_elements(blade, j, [&](int e, const plane::BeamElement& element) {
      const int first = kTwist * (blade.elements * j + e - 1);  // the root's are left out
      const auto coordinate = [first](Index c) { return first + static_cast<int>(c); };
      add(element.mass, coordinate, mass);
      add(element.stiffness, coordinate, stiffness);
    });
  const Index size = Index{kTwist} * blade.bodies * blade.elements;
  return find_modes_of(make_sparse(size, mass), make_sparse(size, stiffness), kTwist, damping);
}

plane::StrainDamping find_strain_damping(const Blade& blade, const Damping& damping) {
  double of_modes = 0.0;
  if (!damping.modes.ratios.empty())
    of_modes = find_damped_modes(blade, damping.modes).stiffness_factor;
  return {damping.directions.axial + of_modes, damping.directions.lag + of_modes};
}

ModalShare make_modal_share(const BeamModes& modes, const Blade& blade,
                            const plane::FlexibleBody& body, int j) {
  assert(j >= 0 && j < blade.bodies && body.elements == blade.elements);
  MatrixXd forces = MatrixXd::Zero(body.coordinates(), modes.shapes.cols());
  Triplets stiffness;
  visit_elements(blade, j, [&](int e, const plane::BeamElement& element) {
    const auto coordinate = [&](Index c) {
      return body.coordinate(e + static_cast<int>(c) / kTwist, static_cast<int>(c) % kTwist);
    };
    add(element.stiffness, coordinate, stiffness);
    const MatrixXd on_nodes = element.stiffness * modes.shapes.middleRows<2 * kTwist>(
                                                      Index{kTwist} * (blade.elements * j + e));
    for (Index c = 0; c < on_nodes.rows(); ++c)
      if (const int at = coordinate(c); at >= 0) forces.row(at) += on_nodes.row(c);
  });
  return make_share(modes, std::move(forces), make_sparse(body.coordinates(), stiffness));
}

}  // namespace spoke
