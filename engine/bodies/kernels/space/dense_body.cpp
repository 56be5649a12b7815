// Assembles the dense matrices from the rows by node.

#include "engine/bodies/kernels/space/dense_body.h"

#include <cassert>
#include <utility>

#include "engine/bodies/space/solid_block.h"
#include "models/space/nodal_mass.h"

namespace spoke::space {
namespace {

/// Calls `visit(coordinate, rows of four)` for all coordinates of the flex vector.
template <class Visit>
void visit_rows(const FlexibleBody& body, const BodyWork& work, Visit&& visit) {
  for (int k = 0; k < body.node_count(); ++k)
    for (int c = 0; c < kTwist; ++c) {
      const int coordinate = body.coordinate(k, c);
      if (coordinate >= 0) visit(coordinate, k, c, work.rows + kNodeRows * k + 4 * c);
    }
}

/// Sets M_RR.
void set_frame_mass(double mass, const BodyTerms& terms, Eigen::Ref<Eigen::MatrixXd> all) {
  all.topLeftCorner<3, 3>() = mass * Matrix3::Identity();
  all.block<3, 3>(kRotation, 0) = skew(terms.S);
  all.block<3, 3>(0, kRotation) = skew(terms.S).transpose();
  all.block<3, 3>(kRotation, kRotation) = terms.Theta;
}

}  // namespace

Eigen::MatrixXd make_dense_elastic_block(const FlexibleBody& body, const BlockFactors& factors) {
  BlockTridiagonal sum(body.node_count());
  sum.add_scaled(factors.mass, body.M);
  sum.add_scaled(factors.stiffness, body.K);
  sum.add_scaled(factors.damping, body.D);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(body.coordinates(), body.coordinates());
  add_dense(body, sum, dense);
  return dense;
}

void shift_dense(const FlexibleBody& body, const ImplicitShift& shift,
                 Eigen::Ref<Eigen::MatrixXd> dense) {
  assert(dense.rows() == body.coordinates() && dense.cols() == body.coordinates());
  const auto shift_one = [&](auto&& values) {  // values S, a row, or S^T values, a column
    for (int k = 1; k < body.elements; ++k) {
      const ImplicitShift::Node& node = shift.nodes[static_cast<std::size_t>(k)];
      double along = 0.0;
      for (int c = 0; c < kPosition; ++c)
        if (const int at = body.coordinate(k, c); at >= 0) along += node.axis[c] * values[at];
      for (int i = 0; i < 3 * kTwist; ++i)
        if (const int at = body.coordinate(k - 1 + i / kTwist, i % kTwist); at >= 0)
          values[at] -= node.gradient[static_cast<std::size_t>(i)] * along;
    }
  };
  for (int i = 0; i < body.coordinates(); ++i) shift_one(dense.col(i));
  for (int i = 0; i < body.coordinates(); ++i) shift_one(dense.row(i));
}

void add_dense(const FlexibleBody& body, const BlockTridiagonal& matrix,
               Eigen::Ref<Eigen::MatrixXd> dense) {
  assert(matrix.nodes() == body.node_count());
  assert(dense.rows() == body.coordinates() && dense.cols() == body.coordinates());
  const auto add = [&](int a, int b, const TwistMatrix& block) {
    for (int i = 0; i < kTwist; ++i)
      for (int j = 0; j < kTwist; ++j) {
        const int row = body.coordinate(a, i), column = body.coordinate(b, j);
        if (row < 0 || column < 0) continue;
        dense(row, column) += block(i, j);
        if (a != b) dense(column, row) += block(i, j);
      }
  };
  for (int k = 0; k < body.node_count(); ++k) {
    add(k, k, matrix.diagonal[static_cast<std::size_t>(k)]);
    if (k < body.elements) add(k + 1, k, matrix.below[static_cast<std::size_t>(k)]);
  }
}

void calc_dense_mass(const FlexibleBody& body, const BodyTerms& terms, const BodyWork& work,
                     const Eigen::MatrixXd& elastic, Eigen::Ref<Eigen::MatrixXd> mass) {
  assert(mass.rows() == kTwist + body.coordinates() && mass.cols() == mass.rows());
  assert(elastic.rows() == body.coordinates() && elastic.cols() == body.coordinates());
  set_frame_mass(body.mass, terms, mass);
  visit_rows(body, work, [&](int coordinate, int node, int c, const double* row) {
    const int at = kTwist + coordinate;
    mass.block<1, 3>(at, 0) = body.C_t[static_cast<std::size_t>(node)].row(c);
    mass.block<1, 3>(at, kRotation) << row[0], row[1], row[2];
    mass.block<kTwist, 1>(0, at) = mass.block<1, kTwist>(at, 0).transpose();
  });
  mass.bottomRightCorner(body.coordinates(), body.coordinates()) = elastic;
}

void calc_dense_force(const FlexibleBody& body, const BodyTerms& terms, const BodyWork& work,
                      Eigen::Ref<Eigen::VectorXd> force) {
  assert(force.size() == kTwist + body.coordinates());
  force.head<kTwist>() = terms.Q;
  visit_rows(body, work, [&](int coordinate, int, int, const double* row) {
    force[kTwist + coordinate] = row[3];
  });
}

void calc_handle_jacobian(const FlexibleBody& body, int handle, const BodyWork& work,
                          Eigen::Ref<Eigen::MatrixXd> J) {
  assert(J.rows() == kTwist && J.cols() == kTwist + body.coordinates());
  assert(handle >= 0 && std::cmp_less(handle, body.handles.size()));
  const HandleMotion& motion = work.handles[handle];
  J.setZero();
  J.leftCols<kTwist>().setIdentity();
  J.block<3, 3>(0, kRotation) = -skew(motion.s);
  for (int c = 0; c < kTwist; ++c) {
    const int coordinate = body.coordinate(body.handles[static_cast<std::size_t>(handle)], c);
    if (coordinate < 0) continue;
    if (c < kRotation)
      J(c, kTwist + coordinate) = 1.0;
    else
      J.block<3, 1>(kRotation, kTwist + coordinate) = motion.turn.H.col(c - kRotation);
  }
}

Eigen::MatrixXd make_dense_elastic_block(const Solid& body, const BlockFactors& factors) {
  if (const ReducedSolid* reduced = body.constants->reduced())
    return (factors.mass * Eigen::VectorXd::Ones(body.coordinates()) +
            factors.stiffness * reduced->stiffness + factors.damping * reduced->damping)
        .asDiagonal();
  const NodalSolid& nodal = *body.constants->nodal();
  return factors.mass * Eigen::MatrixXd(calc_flexible_mass(nodal)) +
         factors.stiffness * Eigen::MatrixXd(nodal.K);
}

void calc_dense_mass(const Solid& body, const BodyTerms& terms, const BodyWork& work,
                     const Eigen::MatrixXd& elastic, Eigen::Ref<Eigen::MatrixXd> mass) {
  const int n = body.coordinates();
  assert(mass.rows() == kTwist + n && mass.cols() == mass.rows() && elastic.rows() == n);
  set_frame_mass(body.constants->mass, terms, mass);
  for (int k = 0; k < n; ++k) {
    const double* row = work.rows + kSolidRow * k;
    mass.block<1, 3>(kTwist + k, 0) = body.constants->C_t().row(k);
    mass.block<1, 3>(kTwist + k, kRotation) << row[0], row[1], row[2];
    mass.block<kTwist, 1>(0, kTwist + k) = mass.block<1, kTwist>(kTwist + k, 0).transpose();
  }
  mass.bottomRightCorner(n, n) = elastic;
}

void calc_dense_force(const Solid& body, const BodyTerms& terms, const BodyWork& work,
                      Eigen::Ref<Eigen::VectorXd> force) {
  assert(force.size() == kTwist + body.coordinates());
  force.head<kTwist>() = terms.Q;
  for (int k = 0; k < body.coordinates(); ++k) force[kTwist + k] = work.rows[kSolidRow * k + 3];
}

void calc_handle_jacobian(const Solid& body, int handle, const BodyWork& work,
                          Eigen::Ref<Eigen::MatrixXd> J) {
  assert(J.rows() == kTwist && J.cols() == kTwist + body.coordinates());
  const HandleMotion& motion = work.handles[handle];
  const SolidPlace& place = body.handle(static_cast<std::size_t>(handle));
  J.setZero();
  J.leftCols<kTwist>().setIdentity();
  J.block<3, 3>(0, kRotation) = -skew(motion.s);
  for (std::size_t i = 0; i < place.at.size(); ++i) {
    const Twist& column = place.columns[i];
    J.block<3, 1>(0, kTwist + place.at[i]) = linear(column);
    J.block<3, 1>(kRotation, kTwist + place.at[i]) =
        motion.turn.H.lazyProduct(Angular(angular(column)));
  }
}

}  // namespace spoke::space
