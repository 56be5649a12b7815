// Sums over the coordinates of bodies, wherever a world keeps them.

#include "engine/kernels/modal_damping.h"

#include <algorithm>
#include <cassert>

#include "engine/space/body_data.h"

namespace spoke {
namespace {

/// Calls visit(coordinate, its place in the right-hand side).
template <class Visit>
void visit_forces(BodyData<Plane>& body, const Visit& visit) {
  for (int k = 0; k < body.model->body->coordinates(); ++k)
    visit(k, body.Q_f[body.layout.offset(k)]);
}
template <class Visit>
void visit_forces(BodyData<Space>& body, const Visit& visit) {
  const space::FlexibleBody& flexible = *body.model->body->flexible();
  for (int node = flexible.first_node(); node < flexible.node_count(); ++node)
    for (int c = 0; c < space::kTwist; ++c)
      if (const int k = flexible.coordinate(node, c); k >= 0)
        visit(k, body.work.rows[space::kNodeRows * node + 4 * c + 3]);
}

/// Returns w.x of one mode over a body's coordinates, x a flex vector.
template <class World>
double project(const BodyData<World>& body, Eigen::Index mode, const double* x) {
  const Eigen::MatrixXd& weights = body.model->modal.weights;
  double sum = 0.0;
  for (Eigen::Index k = 0; k < weights.rows(); ++k)
    sum += weights(k, mode) * x[body.layout.offset(static_cast<int>(k))];
  return sum;
}

/// Calls visit(mode of the body's beam, its force).
template <class World, class Visit>
void visit_modes(const ArenaVector<double>& forces, const BodyData<World>& body,
                 const Visit& visit) {
  const ModalShare& share = body.model->modal;
  for (Eigen::Index mode = 0; mode < share.weights.cols(); ++mode)
    visit(mode, forces[static_cast<std::size_t>(share.first + mode)]);
}

}  // namespace

template <class World>
void calc_modal_forces(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  assert(data.modal_forces.size() == subsystem.modal_factors.size());
  std::fill(data.modal_forces.begin(), data.modal_forces.end(), 0.0);
  for (const BodyData<World>& body : data.bodies) {
    const ModalShare& share = body.model->modal;
    for (Eigen::Index mode = 0; mode < share.weights.cols(); ++mode)
      data.modal_forces[static_cast<std::size_t>(share.first + mode)] +=
          project(body, mode, body.v_modal);
  }
  for (std::size_t k = 0; k < subsystem.modal_factors.size(); ++k)
    data.modal_forces[k] *= subsystem.modal_factors[k];
}

template <class World>
void add_modal_damping(const ArenaVector<double>& modal_forces, BodyData<World>& body) noexcept {
  const Eigen::MatrixXd& weights = body.model->modal.weights;
  visit_modes(modal_forces, body, [&](Eigen::Index mode, double force) {
    visit_forces(body, [&](int k, double& row) { row -= weights(k, mode) * force; });
    body.terms.dissipation += force * project(body, mode, body.coordinates.v);
  });
}

template <class World>
std::vector<double> calc_modal_deformation(const SubsystemData<World>& data,
                                           const BodyData<World>& body) {
  const Eigen::MatrixXd& shapes = body.model->modal.shapes;
  if (shapes.cols() == 0) return {};
  std::vector<double> flex(
      static_cast<std::size_t>(body.layout.stride() + BodyTypes<World>::Layout::kPad), 0.0);
  visit_modes(data.modal_forces, body, [&](Eigen::Index mode, double force) {
    for (Eigen::Index k = 0; k < shapes.rows(); ++k)
      flex[static_cast<std::size_t>(body.layout.offset(static_cast<int>(k)))] +=
          shapes(k, mode) * force;
  });
  return flex;
}

template void calc_modal_forces(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;
template void calc_modal_forces(const Subsystem<Space>&, SubsystemData<Space>&) noexcept;
template void add_modal_damping(const ArenaVector<double>&, BodyData<Plane>&) noexcept;
template void add_modal_damping(const ArenaVector<double>&, BodyData<Space>&) noexcept;
template std::vector<double> calc_modal_deformation(const SubsystemData<Plane>&,
                                                    const BodyData<Plane>&);
template std::vector<double> calc_modal_deformation(const SubsystemData<Space>&,
                                                    const BodyData<Space>&);

}  // namespace spoke
