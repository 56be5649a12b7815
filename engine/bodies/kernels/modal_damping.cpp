// Sums over the coordinates of bodies, wherever a world keeps them.

#include "engine/bodies/kernels/modal_damping.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/table/body_kind.h"

namespace spoke {
namespace {

/// Adds factor times the weights of a mode to the right-hand side of a body.
void add_forces(double factor, Eigen::Index mode, BodyData<Plane>& body) {
  const Eigen::MatrixXd& weights = body.model->modal.weights;
  for (int k = 0; k < body.model->body->coordinates(); ++k)
    body.Q_f[body.layout.offset(k)] += factor * weights(k, mode);
}
void add_forces(double factor, Eigen::Index mode, BodyData<Space>& body) {
  body.kind->add_forces(factor, body.model->modal.weights.col(mode).data(), body);
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

/// Adds up the forces of all modes of a subsystem; velocities(body): a flex vector.
template <class World, class Velocities>
void sum_forces(const Subsystem<World>& subsystem, const SubsystemData<World>& data,
                const Velocities& velocities, double* forces) {
  std::fill_n(forces, subsystem.modal_factors.size(), 0.0);
  for (const BodyData<World>& body : data.bodies) {
    const ModalShare& share = body.model->modal;
    for (Eigen::Index mode = 0; mode < share.weights.cols(); ++mode)
      forces[share.first + mode] += project(body, mode, velocities(body));
  }
  for (std::size_t k = 0; k < subsystem.modal_factors.size(); ++k)
    forces[k] *= subsystem.modal_factors[k];
}

}  // namespace

template <class World>
void calc_modal_forces(const Subsystem<World>& subsystem, SubsystemData<World>& data) noexcept {
  assert(data.modal_forces.size() == subsystem.modal_factors.size());
  sum_forces(
      subsystem, data, [](const BodyData<World>& body) { return body.v_modal; },
      data.modal_forces.data());
}

template <class World>
void add_modal_damping(const ArenaVector<double>& modal_forces, BodyData<World>& body) noexcept {
  const ModalShare& share = body.model->modal;
  for (Eigen::Index mode = 0; mode < share.weights.cols(); ++mode) {
    const double force = modal_forces[static_cast<std::size_t>(share.first + mode)];
    add_forces(-force, mode, body);
    body.terms.dissipation += force * project(body, mode, body.coordinates.v);
  }
}

template <class World>
std::vector<double> calc_modal_deformation(const Subsystem<World>& subsystem,
                                           const SubsystemData<World>& data,
                                           const BodyData<World>& body) {
  const ModalShare& share = body.model->modal;
  if (share.is_empty()) return {};
  std::vector<double> forces(subsystem.modal_factors.size());
  sum_forces(
      subsystem, data, [](const BodyData<World>& each) { return each.coordinates.v; },
      forces.data());
  std::vector<double> flex(
      static_cast<std::size_t>(body.layout.stride() + BodyTypes<World>::Layout::kPad), 0.0);
  for (Eigen::Index mode = 0; mode < share.shapes.cols(); ++mode)
    for (Eigen::Index k = 0; k < share.shapes.rows(); ++k)
      flex[static_cast<std::size_t>(body.layout.offset(static_cast<int>(k)))] +=
          share.shapes(k, mode) * forces[static_cast<std::size_t>(share.first + mode)];
  return flex;
}

template void calc_modal_forces(const Subsystem<Plane>&, SubsystemData<Plane>&) noexcept;
template void calc_modal_forces(const Subsystem<Space>&, SubsystemData<Space>&) noexcept;
template void add_modal_damping(const ArenaVector<double>&, BodyData<Plane>&) noexcept;
template void add_modal_damping(const ArenaVector<double>&, BodyData<Space>&) noexcept;
template std::vector<double> calc_modal_deformation(const Subsystem<Plane>&,
                                                    const SubsystemData<Plane>&,
                                                    const BodyData<Plane>&);
template std::vector<double> calc_modal_deformation(const Subsystem<Space>&,
                                                    const SubsystemData<Space>&,
                                                    const BodyData<Space>&);

}  // namespace spoke
