// Inverts one block of (P 11), the mass matrix of a body, and multiplies it with the rows of its
// joints (docs/formulation.md, section 4.2).

#include <cassert>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/step/formulation/loops/loops.h"
#include "engine/step/formulation/subsystem.h"
#include "engine/step/formulation/tree_joints.h"
#include "engine/support/dense.h"

namespace spoke::subsystem {

namespace {

template <class Matrix>
std::span<std::byte> bytes(Matrix& matrix) {
  return memory_of(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

/// Declares the parts of bodies, of the synthesis for the whole subsystem, and of loops.
template <class World>
void declare_parts(SubsystemData<World>& data, SubsystemWork<World>& work) {
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    const PartMaker maker = maker_of_body(j, data);
    BodyWork<World>& body = work.bodies[j];
    BodyParts& parts = data.parts.bodies[j];
    parts.inverse = maker.cover("inverse", Mark::none, bytes(body.inverse_columns),
                                bytes(body.products), bytes(body.biases));
    parts.workspace = maker.cover("workspace", Mark::none, bytes(body.mass), bytes(body.jacobians));
  }
  const PartMaker& maker = data.part_maker;
  SubsystemParts& parts = data.parts;
  parts.effective = maker.cover("effective inertia", Mark::none, data.effective,
                                bytes(work.solution), bytes(work.response));
  parts.workspace = maker.cover("workspace", Mark::none, bytes(work.D), bytes(work.columns),
                                bytes(work.inverse_columns), bytes(work.inertia));
  for (std::size_t k = 0; k < work.loops.size(); ++k) {
    auto& loop = work.loops[k];
    maker.add(declare_loop_rows(k, data), bytes(loop.right), bytes(loop.solution),
              bytes(loop.response));
  }
  declare_loop_matrix(data);
}

}  // namespace

template <class World>
void allocate(const std::vector<DenseBlocks>& elastic, SubsystemData<World>& data,
              SubsystemWork<World>& work) {
  assert(elastic.size() == data.bodies.size());
  constexpr int d = World::kTwist;
  work.bodies = ArenaVector<BodyWork<World>>(data.bodies.size(), *data.arena);
  int coordinates = 0;
  for (std::size_t j = 0; j < data.bodies.size(); ++j) {
    BodyWork<World>& body = work.bodies[j];
    const typename World::Body& model = *data.bodies[j].model->body;
    const int n = dense_size(model), m = handle_count(model);
    body.elastic = elastic[j];
    body.mass.setZero(n, n);
    body.jacobians.setZero(m * d, n);
    body.inverse_columns.setZero(n, m * d + 1);
    body.products.setZero(m * d, m * d + 1);
    body.biases.setZero(d, m);
    work.first_coordinate.push_back(coordinates);
    coordinates += joint_coordinates(*data.bodies[j].model);
    const int parent = data.bodies[j].model->parent;
    work.root_of.push_back(parent < 0 ? static_cast<int>(j) : work.root_of[parent]);
  }
  const int C1 = d * static_cast<int>(data.bodies.size());
  work.D.setZero(C1, C1);
  work.solution.setZero(C1, d + 1);
  work.multipliers.setZero(C1);
  work.columns.setZero(C1, coordinates);
  work.inverse_columns.setZero(C1, coordinates);
  work.inertia.setZero(coordinates, coordinates);
  work.response.setZero(coordinates, d + 1);
  for (const LoopPath& path : data.loops.paths) {
    typename SubsystemWork<World>::LoopColumns& columns = work.loops.emplace_back();
    columns.right.setZero(C1, path.rows);
    columns.solution.setZero(C1, path.rows);
    columns.response.setZero(coordinates, path.rows);
  }
  declare_parts(data, work);
}

template <class World>
void invert_body(const BodyData<World>& data, const TwistOf<World>& twist, bool implicit,
                 BodyWork<World>& work) noexcept {
  assert(work.elastic[implicit]);
  assert(work.mass.rows() == dense_size(*data.model->body));
  assert(work.biases.cols() == handle_count(*data.model->body));
  constexpr int d = World::kTwist;
  // (1) M of (P 3) is assembled; its Cholesky factor takes its place.
  calc_dense_mass(data, *work.elastic[implicit], implicit, work.mass);
  factorise_cholesky(work.mass);
  // (2) The right-hand sides are J^T and Q.
  Eigen::MatrixXd &J = work.jacobians, &columns = work.inverse_columns;
  for (int h = 0; h < work.biases.cols(); ++h) {
    calc_handle_jacobian(data, h, J.middleRows<d>(d * h));
    work.biases.col(h) = calc_handle_bias(data, h, twist);
  }
  columns.leftCols(J.rows()) = J.transpose();
  calc_dense_force(data, columns.col(J.rows()));
  // (3) M^-1 [J^T, Q] follows, and J times that: the body's share of Phi M^-1 Phi^T and of Phi M^-1
  // Q.
  solve_cholesky(work.mass, columns);
  work.products.noalias() = J.lazyProduct(columns);
}

template <class World>
PartList parts_of_inverted(std::size_t j, const SubsystemData<World>& data) {
  const BodyParts& parts = data.parts.bodies[j];
  PartList list{parts.coordinates, data.parts.twists, parts.terms};
  if constexpr (tree::kHasJointCoordinates<World>)
    list.push_back(data.parts.rotations);  // for its handles
  graph::add_to(list, graph::maybe(parts.tension), graph::maybe(parts.carried), parts.tiles);
  return list;
}

template void allocate(const std::vector<DenseBlocks>&, SubsystemData<Plane>&,
                       SubsystemWork<Plane>&);
template void invert_body(const BodyData<Plane>&, const Twist&, bool, BodyWork<Plane>&) noexcept;
template PartList parts_of_inverted(std::size_t, const SubsystemData<Plane>&);
template PartList parts_of_inverted(std::size_t, const SubsystemData<Space>&);
template void allocate(const std::vector<DenseBlocks>&, SubsystemData<Space>&,
                       SubsystemWork<Space>&);
template void invert_body(const BodyData<Space>&, const space::Twist&, bool,
                          BodyWork<Space>&) noexcept;

}  // namespace spoke::subsystem
