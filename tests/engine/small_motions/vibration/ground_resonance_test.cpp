// Tests ground resonance: a rotor with lag hinges on a hub that springs hold in the plane.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <functional>
#include <string>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/vibration/eigenvalues.h"
#include "tests/engine/small_motions/steady/blades.h"

namespace spoke {
namespace {

using Eigen::MatrixXd;
using steady::HubCoupling;
using steady::LinearModel;
using Complex = std::complex<double>;

// Four uniform stiff blades of unit mass and length, hinged at the offset e.
constexpr int kBlades = 4;
constexpr double kOffset = 0.1, kHubMass = 3.0, kSpring = 7.0;

Scenario make_rotor() {
  Scenario scenario = test::make_spatial({.bodies = 1,
                                          .elements = 2,
                                          .radius = kOffset,
                                          .axial_stiffness = 1e9,
                                          .bending_stiffness = 1e6,
                                          .joint = "[[blades.joint]]\nname = \"lag_hinge\"\n"
                                                   "station = 0.0\nkind = \"revolute\"\n"
                                                   "axis = [0.0, 0.0, 1.0]\n"});
  spatial::Model& model = *scenario.space;
  for (int b = 1; b < kBlades; ++b) {
    model.blades.push_back(model.blades[0]);
    model.blades.back().azimuth += b * std::acos(-1.0) / 2.0;
  }
  model.hub.support = HubSupport::free;
  model.hub.mass = kHubMass;
  model.hub.drive = FreeDrive{};
  return scenario;
}

/// Leaves the hub its motion in the plane, held by equal springs in all directions.
void hold_in_plane(LinearModel& model) {
  model.M = MatrixXd(model.M.topLeftCorner(2, 2));
  model.C = MatrixXd(model.C.topLeftCorner(2, 2));
  model.K = MatrixXd(model.K.topLeftCorner(2, 2)) + kSpring * MatrixXd::Identity(2, 2);
  model.round_off.force.conservativeResize(2);
  model.round_off.step.conservativeResize(2);
  for (HubCoupling& tree : model.couplings) {
    for (MatrixXd* columns : {&tree.M_bh, &tree.C_bh, &tree.K_bh})
      *columns = MatrixXd(columns->leftCols(2));
    for (MatrixXd* rows : {&tree.M_hb, &tree.C_hb, &tree.K_hb}) *rows = MatrixXd(rows->topRows(2));
  }
}

/// Whether the model's vibrations grow at a speed.
bool grows(const Scenario& scenario, double speed) {
  const auto model = steady::make_steady_model(scenario, {speed});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  LinearModel linear = steady::linearize(equilibrium, *model);
  hold_in_plane(linear);
  const vibration::Pencil pencil(linear, {0, 1, 2, 3});
  for (const vibration::Root& root : vibration::find_roots(pencil, 6))
    if (root.s.real() > 1e-4) return true;
  return false;
}

/// Returns the same by Coleman and Feingold (1958, NACA report 1351), in complex coordinates of the
/// inertial frame, z of the hub and eta, the sum of lag angles times exp(i azimuth):
///
///   (M s^2 + k) z + i S s^2 eta = 0,   [I (s^2 - 2 i w s - w^2) + w^2 e S] eta - i N S/2 s^2 z = 0
bool grows_classically(double speed) {
  const double mass = kHubMass + kBlades, S = 0.5, inertia = 1.0 / 3.0;
  const Complex b(0.0, -2.0 * speed * inertia);
  const double c = speed * speed * (kOffset * S - inertia);
  // Coefficients of (M s^2 + k) (I s^2 + b s + c) - N S^2/2 s^4.
  const Complex a4 = mass * inertia - 0.5 * kBlades * S * S, a3 = mass * b;
  const Complex a2 = mass * c + kSpring * inertia, a1 = kSpring * b, a0 = kSpring * c;
  Eigen::Matrix4cd companion = Eigen::Matrix4cd::Zero();
  companion.bottomLeftCorner<3, 3>().setIdentity();
  companion.col(3) << -a0 / a4, -a1 / a4, -a2 / a4, -a3 / a4;
  const Eigen::Vector4cd roots = companion.eigenvalues();
  return roots.real().maxCoeff() > 1e-4;
}

/// Returns the speed between two at which a function of the speed changes.
double find_change(double from, double to, const std::function<bool(double)>& is_unstable) {
  const bool at_start = is_unstable(from);
  REQUIRE(is_unstable(to) != at_start);
  for (int i = 0; i < 10; ++i) {
    const double middle = 0.5 * (from + to);
    (is_unstable(middle) == at_start ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

TEST_CASE("ground resonance: the unstable range of speeds is the classical one") {
  const Scenario scenario = make_rotor();
  const auto unstable = [&scenario](double speed) { return grows(scenario, speed); };
  double inside = 0.0;
  for (double speed = 0.5; speed < 4.0 && inside == 0.0; speed += 0.05)
    if (grows_classically(speed)) inside = speed + 0.02;
  REQUIRE(inside > 0.0);
  CHECK(find_change(0.5, inside, unstable) ==
        doctest::Approx(find_change(0.5, inside, grows_classically)).epsilon(0.01));
  CHECK(find_change(inside, 6.0, unstable) ==
        doctest::Approx(find_change(inside, 6.0, grows_classically)).epsilon(0.01));
}

}  // namespace
}  // namespace spoke
