// Tests that subsystems that are alike, taken apart into patterns, have the roots and vectors of
// the whole model.

#include "engine/small_motions/vibration/coupled_roots.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "engine/small_motions/steady/derivatives.h"
#include "models/scenario.h"

namespace spoke {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using steady::LinearModel;

Scenario read(const std::string& model, int blades) {
  return read_scenario(std::string(SPOKE_MODELS_DIR) + '/' + model,
                       {"blade.count=" + std::to_string(blades), "blade.bodies=2",
                        "blade.elements=2", "damping.stiffness_factor=0.002"});
}

/// Checks that roots by patterns are roots of the whole with their vectors, and that none are left
/// out.
void check_roots(const Scenario& scenario, double speed, std::size_t families) {
  const auto model = steady::make_steady_model(scenario, {speed});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  const LinearModel linear = steady::linearize(equilibrium, *model);
  CHECK(std::set<std::size_t>(linear.alike.begin(), linear.alike.end()).size() == families);
  const vibration::Pencil whole(linear);
  const MatrixXd M = whole.dense_mass(), C = whole.dense_damping(), K = whole.dense_stiffness();
  const vibration::PencilFactor factor(whole, 0.5);  // stiff coordinates count no more than others
  const int count = 20;
  const auto expected = vibration::find_roots(whole, count);
  const auto roots = vibration::find_coupled_roots(linear, model->azimuths(), count);
  REQUIRE(roots.size() == expected.size());
  MatrixXcd vectors(whole.size(), count);
  for (int k = 0; k < count; ++k) {
    const vibration::Root& root = roots[static_cast<std::size_t>(k)];
    CAPTURE(k);
    // A free hub drifts in a frame that turns: double roots that are found to the square root of
    // round-off.
    CHECK(std::abs(std::abs(root.s) - std::abs(expected[static_cast<std::size_t>(k)].s)) <
          1e-6 * (1.0 + std::abs(root.s)));
    const Eigen::VectorXcd x = root.x.cwiseQuotient(whole.scale());
    vectors.col(k) = x.normalized();
    CHECK(std::abs((x.adjoint() * M * x)(0) - 1.0) < 1e-9);
    const Eigen::VectorXcd left = root.s * root.s * (M * x) + root.s * (C * x) + K * x;
    CHECK(factor.solve(left.real()).norm() + factor.solve(left.imag()).norm() <
          1e-7 * x.norm() * (1.0 + std::norm(root.s)));
  }
  // Patterns that share a root are independent.
  for (int k = 1; k < count; ++k)
    for (int l = 0; l < k; ++l)
      if (std::abs(roots[static_cast<std::size_t>(k)].s) > 1.0)
        CHECK(std::abs(vectors.col(k).dot(vectors.col(l))) < 0.999);
}

Scenario make_uneven() {
  Scenario scenario = read("free_hub_satellite.toml", 6);
  const double azimuths[] = {0.0, 0.5, 1.3, 1.9, 3.1, 4.4};
  for (std::size_t i = 0; i < 6; ++i) scenario.rotor.blades[i].azimuth = azimuths[i];
  scenario.rotor.blades[2].density *= 1.5;
  return scenario;
}

/// Checks the coupling of each subsystem with the hub against its own derivatives.
void check_couplings(const Scenario& scenario, double speed) {
  const auto model = steady::make_steady_model(scenario, {speed});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  const LinearModel linear = steady::linearize(equilibrium, *model);
  const steady::HubKinematics hub = steady::make_hub_kinematics(*model);
  const std::vector<int>& free = model->free_components();
  const auto check = [](const MatrixXd& found, const MatrixXd& expected) {
    CHECK((found - expected).norm() < 1e-7 * expected.norm() + 1e-9);
  };
  for (std::size_t i = 0; i < model->subsystems(); ++i) {
    CAPTURE(i);
    const steady::SubsystemDerivatives by =
        calc_derivatives(i, steady::make_state(equilibrium.q[i]), true, *model);
    const auto n = by.by_q.cols(), d = static_cast<Eigen::Index>(model->twist_size());
    const MatrixXd M_bh = model->matrices(i).mass.bottomLeftCorner(n, d);
    const auto columns = [&](const MatrixXd& m) { return MatrixXd(m(Eigen::all, free)); };
    const auto rows = [&](const MatrixXd& m) { return MatrixXd(m(free, Eigen::all)); };
    const steady::HubCoupling& coupling = linear.couplings[i];
    check(coupling.M_bh, columns(M_bh));
    check(coupling.C_bh, columns(M_bh * hub.P1 - by.by_twist.topRows(n)));
    check(coupling.K_bh,
          columns(M_bh * hub.P0 - by.by_turn.topRows(n) - by.by_twist.topRows(n) * hub.W));
    check(coupling.M_hb, rows(M_bh.transpose()));
    check(coupling.C_hb, rows(-by.by_v.bottomRows(d)));
    check(coupling.K_hb, rows(-by.by_q.bottomRows(d)));
  }
}

}  // namespace

TEST_CASE("coupled roots: patterns of alike blades have the roots of the whole model") {
  check_roots(read("free_hub_satellite.toml", 5), 0.2, 1);
  check_roots(read("free_hub_satellite.toml", 3), 0.2, 1);
  check_roots(read("satellite_booms.toml", 6), 0.3, 1);
  // About an axle blades of two densities are alike; a hub that flies turns about the mass centre,
  // from which no two are as far.
  Scenario on_axle = make_uneven();
  on_axle.rotor.hub.support = HubSupport::axle;
  check_roots(on_axle, 0.2, 2);
  check_roots(make_uneven(), 0.2, 6);
}

TEST_CASE("coupled roots: blades that are alike meet the hub as each does by itself") {
  check_couplings(read("free_hub_satellite.toml", 5), 0.2);
  check_couplings(read("satellite_booms.toml", 5), 0.3);
  check_couplings(make_uneven(), 0.2);
}

}  // namespace spoke
