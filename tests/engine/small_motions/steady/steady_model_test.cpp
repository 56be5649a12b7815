// Compares forces at zero accelerations, masses and linear models with the results of the step
// graph.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/small_motions/steady/derivatives.h"
#include "engine/small_motions/steady/linear_model.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/shipped.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns a state in which all coordinates are moved.
SubsystemState make_moved(std::size_t subsystem, const SteadyModel& model) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  SubsystemState state = make_state(model.initial(subsystem));
  for (Eigen::Index k = 0; k < state.q.size(); ++k) {
    const double scale = model.coordinates(subsystem)[static_cast<std::size_t>(k)].scale;
    state.q[k] += 0.02 * scale * uniform(random);
    state.v[k] = 0.1 * scale * uniform(random);
    state.q_elastic[k] = 1e-4 * scale * uniform(random);
    state.v_elastic[k] = 1e-4 * scale * uniform(random);
  }
  return state;
}

/// Checks F = M a where the hub has no acceleration, and the part of elastic forces in F.
void check_forces(const Scenario& scenario, double speed) {
  const auto model = make_steady_model(scenario, {speed});
  for (std::size_t i = 0; i < std::min<std::size_t>(model->subsystems(), 2); ++i) {
    const SubsystemState state = make_moved(i, *model);
    HubOffset offset = model->no_offset();
    offset.twist.setLinSpaced(0.1, 0.3);
    SubsystemResponse response;
    model->evaluate(i, state, offset, response);
    const VectorXd a = model->accelerations(i);
    const SubsystemMatrices matrices = model->matrices(i);
    const VectorXd inertia = matrices.mass.bottomRightCorner(a.size(), a.size()) * a;
    CHECK((inertia - response.force).norm() < 1e-8 * response.force.norm());
    CHECK((matrices.mass - matrices.mass.transpose()).norm() < 1e-13 * matrices.mass.norm());
    const VectorXd momenta = matrices.mass.rightCols(a.size()) * state.v;
    CHECK((model->momenta(i, state.v) - momenta).norm() < 1e-12 * momenta.norm());
  }
}

TEST_CASE("steady model: forces at zero accelerations are mass times the step's accelerations") {
  check_forces(test::make_planar({}), 3.0);
  Scenario chord = test::make_planar({});
  chord.rotor.blades[0].reference_frame = ReferenceFrame::chord;
  check_forces(chord, 3.0);
  check_forces(test::read_shipped("wu_haug_rotor"), 4.0);
  check_forces(test::read_shipped("spatial_wu_haug"), 4.0);
  check_forces(test::read_shipped("articulated_rotor"), 36.0);
  check_forces(test::read_shipped("tree_of_bodies"), 1.0);
  check_forces(test::read_shipped("heavy_top"), 0.0);
  Scenario bent = test::read_shipped("nrel_5mw_rotor");
  bent.space->blades[0].beam.reference_frame = ReferenceFrame::chord;
  check_forces(bent, 1.3);
}

/// Checks K and C of a subsystem against differences of the accelerations, with all forces moving.
void check_linear(const Scenario& scenario, double speed) {
  const auto model = make_steady_model(scenario, {speed});
  const Equilibrium equilibrium = find_equilibrium(*model);
  const LinearModel linear = linearize(equilibrium, *model);
  const VectorXd& q = equilibrium.q[0];
  const LinearSubsystem& subsystem = linear.subsystems[0];
  const auto accelerate = [&](const VectorXd& moved, const VectorXd& v) {
    SubsystemResponse response;
    model->evaluate(0, {moved, v, moved, v}, model->no_offset(), response);
    return model->accelerations(0);
  };
  const VectorXd still = VectorXd::Zero(q.size());
  MatrixXd by_q(q.size(), q.size()), by_v(q.size(), q.size());
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const VectorXd step = VectorXd::Unit(q.size(), k) * 1e-6 *
                          model->coordinates(0)[static_cast<std::size_t>(k)].scale;
    by_q.col(k) = (accelerate(q + step, still) - accelerate(q - step, still)) / (2.0 * step[k]);
    by_v.col(k) = (accelerate(q, step) - accelerate(q, -step)) / (2.0 * step[k]);
  }
  CHECK((subsystem.K + subsystem.M * by_q).norm() < 1e-6 * subsystem.K.norm());
  CHECK((subsystem.C + subsystem.M * by_v).norm() <
        1e-6 * (subsystem.C.norm() + 1e-9 * subsystem.K.norm()));
}

TEST_CASE("linear model: stiffness and damping are those of the step's accelerations") {
  check_linear(test::make_planar({}), 3.0);
  check_linear(test::make_spatial({}), 3.0);
  check_linear(test::read_shipped("wu_haug_rotor"), 4.0);
  check_linear(test::read_shipped("articulated_rotor"), 36.0);
  check_linear(test::read_shipped("nrel_5mw_rotor"), 1.267);
}

}  // namespace
}  // namespace spoke::steady
