// Tells whether imported matrices are those of a free body.

#include "models/solid/import_checks.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "models/solid/import_text.h"
#include "models/support/quantity.h"

namespace spoke::solid {
namespace {

constexpr double kRigid = 1e-8;            ///< |K R| / (|K| |R|) of a rigid motion
constexpr double kLeastMassPivot = 1e-11;  ///< of the Cholesky factor of m, to the largest
constexpr double kLeastBoxDensity = 1e-4;  ///< of the box around the nodes [kg/m^3]
constexpr double kLargestBoxDensity = 1e5;

using Table = Eigen::Matrix<double, Eigen::Dynamic, 3>;

Table table_of(const std::vector<space::Position>& nodes) {
  Table table(static_cast<Eigen::Index>(nodes.size()), 3);
  for (Eigen::Index i = 0; i < table.rows(); ++i) table.row(i) = nodes[static_cast<std::size_t>(i)];
  return table;
}

std::string node_name(const ImportedMatrices& matrices, Eigen::Index node) {
  return "node " + std::to_string(matrices.labels[static_cast<std::size_t>(node)]);
}

void check_definite(const ImportedMatrices& matrices, const MatrixFile& file) {
  for (Eigen::Index node = 0; node < matrices.m.cols(); ++node)
    if (!(matrices.m.coeff(node, node) > 0.0))
      fail_in_file(file.file, 0, file.key,
                   "the mass of " + node_name(matrices, node) + " is " +
                       describe(matrices.m.coeff(node, node)) +
                       ", expected a positive one: nodes that no element has must not be in the "
                       "table");
  const Eigen::SimplicialLLT<ImportedSparse> cholesky(matrices.m);
  bool is_definite = cholesky.info() == Eigen::Success;
  if (is_definite) {
    const ImportedSparse factor = cholesky.matrixL();
    const Eigen::VectorXd pivots = factor.diagonal().array().square();
    is_definite = pivots.minCoeff() > kLeastMassPivot * pivots.maxCoeff();
  }
  if (is_definite) return;
  fail_in_file(file.file, 0, file.key,
               "the mass matrix is singular or not positive definite, as those of CalculiX's "
               "C3D4, C3D10, C3D20R and C3D8I are, which integrate it with too few points, "
               "expected a positive definite one: use C3D20 or C3D8, or give the mesh in place of "
               "the matrices");
}

void check_moments(const ImportedMatrices& matrices, const MatrixFile& file) {
  const Table x = table_of(matrices.nodes);
  const Eigen::VectorXd by_node = matrices.m * Eigen::VectorXd::Ones(x.rows());
  const double mass = by_node.sum();
  const Eigen::RowVector3d least = x.colwise().minCoeff(), greatest = x.colwise().maxCoeff();
  const Eigen::RowVector3d sides = greatest - least;
  const Eigen::RowVector3d center = by_node.transpose() * x / mass;
  const double slack = 1e-6 * sides.maxCoeff();
  const auto refuse = [&](const std::string& what) {
    fail_in_file(file.file, 0, file.key,
                 what +
                     ", expected mass and places of one body: are nodes and matrices of one "
                     "model, in one unit of length?");
  };
  if (((center - least).array() < -slack).any() || ((center - greatest).array() > slack).any())
    refuse("the centre of mass lies outside the nodes");
  const Table r = x.rowwise() - center;
  const Eigen::Matrix3d moments = r.transpose() * (matrices.m * r);
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  const double size = sides.squaredNorm() * mass;
  if (!(principal[1] > 1e-12 * size)) refuse("the nodes lie on a line");
  if (!(principal.sum() <= size)) refuse("the moments of inertia are larger than the nodes allow");
  const double volume = sides.prod();
  if (mass < kLeastBoxDensity * volume || (volume > 0.0 && mass > kLargestBoxDensity * volume))
    refuse("a mass of " + describe(mass) + " kg in a box of " + describe(sides[0]) + " x " +
           describe(sides[1]) + " x " + describe(sides[2]) + " m makes no sense");
}

}  // namespace

void check_mass(const ImportedMatrices& matrices, const MatrixFile& file) {
  check_definite(matrices, file);
  check_moments(matrices, file);
}

void check_rigid_motions(const ImportedMatrices& matrices, const MatrixFile& file,
                         const std::string& missing) {
  const Table x = table_of(matrices.nodes);
  const Table r = x.rowwise() - x.colwise().mean();
  const double extent = r.rowwise().norm().maxCoeff();
  const double largest = largest_entry(matrices.K);
  const auto residual = [&](int axis, bool is_turn) {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(matrices.K.cols());
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    for (Eigen::Index i = 0; i < r.rows(); ++i)
      motion.segment<3>(3 * i) =
          is_turn ? Eigen::Vector3d(unit.cross(r.row(i).transpose()) / extent) : unit;
    return (matrices.K * motion).cwiseAbs().maxCoeff() / largest;
  };
  if (!(largest > 0.0))
    fail_in_file(file.file, 0, file.key, "has no entries but 0, expected a stiffness matrix");
  double shifts = 0.0, turns = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    shifts = std::max(shifts, residual(axis, false));
    turns = std::max(turns, residual(axis, true));
  }
  if (shifts >= kRigid)
    fail_in_file(file.file, 0, file.key,
                 "rigid shifts make forces of " + describe(shifts) +
                     " of the largest entry, expected less than 1e-8: six rigid motions missing, "
                     "exported with constraints or with too few digits" +
                     missing);
  if (turns >= kRigid)
    fail_in_file(file.file, 0, file.key,
                 "rigid rotations make forces of " + describe(turns) +
                     " of the largest entry, expected less than 1e-8: six rigid motions missing, "
                     "exported with constraints, or nodes in other axes, in another order or with "
                     "too few digits" +
                     missing);
}

}  // namespace spoke::solid
