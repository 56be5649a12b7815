// Tests periodic systems: two blades on springs against a monodromy matrix of their equations, and
// three against multi-blade coordinates.

#include "engine/small_motions/vibration/floquet.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "engine/small_motions/vibration/multi_blade.h"
#include "engine/small_motions/vibration/periodic_basis.h"
#include "engine/small_motions/vibration/turn_modes.h"
#include "tests/contains.h"
#include "tests/engine/small_motions/steady/blades.h"
#include "tests/engine/small_motions/vibration/lag_rotor.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Complex = std::complex<double>;
using test::HubSprings;
using test::LagBlade;
using vibration::PeriodicMode;
using vibration::PeriodicSystem;
using State = Eigen::Matrix<double, 8, 8>;

PeriodicSystem make_system(int blades, double speed, const HubSprings& springs) {
  const test::LagRotor rotor = test::make_lag_rotor(blades, speed);
  return vibration::stand_on(vibration::make_periodic(rotor.linear, rotor.axes), test::in_plane(),
                             test::matrices_of(springs));
}

/// Returns the rates of x, y, zeta_1, zeta_2 and their rates, by Coleman and Feingold's equations
/// in the standing frame:
///   m x'' + c x' + k x - S sum (zeta sin psi)'' = 0, likewise y with cos psi,
///   I zeta'' + c zeta' + (k + w^2 e S) zeta + S (y'' cos psi - x'' sin psi) = 0.
State rates(double t, double w, const HubSprings& springs) {
  const LagBlade b;
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero(), C = M, K = M;
  M(0, 0) = springs.mx + 2.0 * b.mass;
  M(1, 1) = springs.my + 2.0 * b.mass;
  C(0, 0) = springs.cx;
  C(1, 1) = springs.cy;
  K(0, 0) = springs.kx;
  K(1, 1) = springs.ky;
  for (int i = 0; i < 2; ++i) {
    const double psi = 0.4 + std::numbers::pi * i + w * t, S = b.moment;
    const double s = std::sin(psi), c = std::cos(psi);
    const int z = 2 + i;
    M(z, z) = b.inertia;
    C(z, z) = b.damping;
    K(z, z) = b.stiffness + w * w * b.offset * S;
    M(z, 0) = M(0, z) = -S * s;
    M(z, 1) = M(1, z) = S * c;
    C(0, z) = -2.0 * w * S * c;
    C(1, z) = -2.0 * w * S * s;
    K(0, z) = w * w * S * s;
    K(1, z) = -w * w * S * c;
  }
  State A = State::Zero();
  A.topRightCorner<4, 4>().setIdentity();
  A.bottomLeftCorner<4, 4>() = -M.inverse() * K;
  A.bottomRightCorner<4, 4>() = -M.inverse() * C;
  return A;
}

/// Returns the multipliers of a turn by the classical method of fourth order.
Eigen::Matrix<Complex, 8, 1> integrate(double w, const HubSprings& springs) {
  constexpr int kSteps = 6000;
  const double h = 2.0 * std::numbers::pi / w / kSteps;
  State x = State::Identity();
  for (int k = 0; k < kSteps; ++k) {
    const State a = rates(k * h, w, springs), b = rates((k + 0.5) * h, w, springs);
    const State c = rates((k + 1.0) * h, w, springs);
    const State k1 = a * x, k2 = b * (x + 0.5 * h * k1), k3 = b * (x + 0.5 * h * k2);
    const State k4 = c * (x + h * k3);
    x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return x.eigenvalues();
}

}  // namespace

TEST_CASE("floquet: two hinged blades on springs have the multipliers of their equations") {
  const HubSprings equal{6.0, 6.0, 2.0, 2.0, 0.03, 0.03}, unequal{5.0, 9.0, 2.0, 1.0, 0.05, 0.02};
  bool grows = false;
  for (const HubSprings& springs : {equal, unequal})
    for (const double speed : {0.9, 1.7, 2.4}) {
      CAPTURE(speed);
      const auto modes = vibration::find_periodic_modes(make_system(2, speed, springs), 4);
      const Eigen::Matrix<Complex, 8, 1> expected = integrate(speed, springs);
      double largest = 0.0;
      for (const PeriodicMode& mode : modes) {
        CHECK((expected.array() - mode.multiplier).abs().minCoeff() < 1e-8);
        largest = std::max(largest, std::abs(mode.multiplier));
        const double period = 2.0 * std::numbers::pi / speed;
        CHECK(std::abs(std::exp(mode.s * period) - mode.multiplier) < 1e-9);
      }
      CHECK(largest == doctest::Approx(expected.cwiseAbs().maxCoeff()).epsilon(1e-8));
      grows = grows || largest > 1.001;
    }
  CHECK(grows);
}

TEST_CASE("floquet: harmonics make up a motion that obeys the equations") {
  const PeriodicSystem system = make_system(2, 1.7, {5.0, 9.0, 2.0, 1.0, 0.05, 0.02});
  for (const PeriodicMode& mode : vibration::find_periodic_modes(system, 4)) {
    for (const double t : {0.0, 0.37, 1.9}) {
      Eigen::VectorXcd x = Eigen::VectorXcd::Zero(4), v = x, a = x;
      double shares = 0.0;
      for (const vibration::Harmonic& harmonic : mode.harmonics) {
        const Complex s = mode.s + Complex(0.0, harmonic.multiple * 1.7);
        const Eigen::VectorXcd part = std::exp(s * t) * harmonic.amplitude;
        x += part;
        v += s * part;
        a += s * s * part;
        shares += harmonic.share;
      }
      CHECK(shares == doctest::Approx(1.0));
      const Eigen::VectorXcd left =
          system.M.at(1.7 * t) * a + system.C.at(1.7 * t) * v + system.K.at(1.7 * t) * x;
      CHECK(left.norm() < 1e-6 * (system.K.at(0.0) * x).norm());
    }
    for (const vibration::Harmonic& harmonic : mode.harmonics)
      if (harmonic.multiple != 0)
        CHECK(harmonic.share <=
              doctest::Approx(
                  std::find_if(mode.harmonics.begin(), mode.harmonics.end(), [](const auto& h) {
                    return h.multiple == 0;
                  })->share));
  }
}

TEST_CASE("floquet: three blades have the roots of multi-blade coordinates but for whole turns") {
  for (const double speed : {-1.2, 2.2}) {
    const HubSprings springs{5.0, 9.0, 2.0, 1.0, 0.05, 0.02};
    const test::LagRotor rotor = test::make_lag_rotor(3, speed);
    const auto fixed = vibration::find_fixed_roots(
        vibration::stand_on(
            vibration::make_fixed_frame(rotor.linear, rotor.azimuths, rotor.names, rotor.axes),
            test::in_plane(), test::matrices_of(springs)),
        5);
    const auto modes = vibration::find_periodic_modes(make_system(3, speed, springs), 5);
    REQUIRE(modes.size() == 5);
    const double period = 2.0 * std::numbers::pi / std::abs(speed);
    for (const vibration::Root& root : fixed) {
      double nearest = 1e9;
      for (const PeriodicMode& mode : modes)
        nearest = std::min({nearest, std::abs(std::exp(root.s * period) - mode.multiplier),
                            std::abs(std::exp(std::conj(root.s) * period) - mode.multiplier)});
      CHECK(nearest < 1e-8);
    }
  }
}

TEST_CASE("floquet: a system that is reduced has the multipliers of the whole") {
  // Soft enough for the steps of the whole to resolve all of it.
  Scenario scenario = test::make_planar({.bodies = 1, .elements = 2, .axial_stiffness = 50.0});
  scenario.rotor.blades.push_back(scenario.rotor.blades[0]);
  scenario.rotor.blades[1].azimuth += 2.1;
  constexpr double kSpeed = 2.0;
  const auto model = steady::make_steady_model(scenario, {.speed = kSpeed, .is_axial = true});
  const steady::Equilibrium equilibrium = steady::find_equilibrium(*model);
  const auto free = steady::HubFreedom::all;
  const PeriodicSystem system = vibration::stand_on(
      vibration::make_periodic(
          steady::linearize(equilibrium, *model, free),
          vibration::make_standing_axes(steady::list_components(*model, free), false, kSpeed)),
      Eigen::MatrixXd::Identity(3, 3),
      {Eigen::Vector3d(1.0, 2.0, 1.0).asDiagonal(), Eigen::Vector3d(0.1, 0.2, 0.1).asDiagonal(),
       Eigen::Vector3d(8.0, 17.0, 5.0).asDiagonal()});
  REQUIRE(system.size() == 15);
  constexpr int kCount = 3;
  const auto reduced = vibration::find_periodic_modes(system, kCount);
  auto whole = vibration::find_modes_over_turn(system, system.size());
  whole.resize(kCount);
  REQUIRE(reduced.size() == kCount);
  for (std::size_t k = 0; k < kCount; ++k) {
    CHECK(std::abs(reduced[k].multiplier - whole[k].multiplier) < 1e-8);
    CHECK(std::abs(reduced[k].s - whole[k].s) < 1e-8 * std::abs(whole[k].s));
    for (const vibration::Harmonic& harmonic : reduced[k].harmonics)
      for (const vibration::Harmonic& same : whole[k].harmonics)
        if (harmonic.multiple == same.multiple) CHECK(std::abs(harmonic.share - same.share) < 1e-7);
  }
  // The basis is smaller, and the first one not enough.
  const Eigen::MatrixXd V = vibration::find_low_motions(system, kCount);
  const Eigen::MatrixXd& M = system.M.parts[0];
  CHECK(V.cols() < system.size());
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(V.cols(), V.cols());
  CHECK((V.transpose() * M * V - unit).norm() < 1e-9);
  auto modes = vibration::find_modes_over_turn(vibration::project(system, V), kCount);
  for (PeriodicMode& mode : modes)
    for (vibration::Harmonic& harmonic : mode.harmonics)
      harmonic.amplitude = (V * harmonic.amplitude).eval();
  const Eigen::MatrixXd more = vibration::find_missing_motions(system, V, modes);
  CHECK(more.cols() > 0);
  CHECK((V.transpose() * M * more).norm() < 1e-9);
}

TEST_CASE("floquet: what it cannot take is refused with the size") {
  CHECK(test::message_of([] { vibration::find_periodic_modes(make_system(2, 0.0, {}), 1); }) ==
        "the frame \"floquet\" expects a hub that turns: at rest nothing is periodic");
  PeriodicSystem large{{}, {}, {}, 1.0, 1, {1, 301}};
  large.M = large.C = large.K = vibration::make_zero_periodic(601, 0);
  CHECK(test::message_of([&] { vibration::find_periodic_modes(large, 1); }) ==
        "the frame \"floquet\" expects at most 600 coordinates, got 601");
  // Of what the hub does not couple each part counts.
  large.hub = 0;
  large.starts = {0};
  CHECK(test::message_of([&] { vibration::find_periodic_modes(large, 1); }) ==
        "the frame \"floquet\" expects at most 600 coordinates of each blade, got 601");
  large.starts = {0, 300};
  CHECK_NOTHROW(vibration::require_periodic(large));
}

}  // namespace spoke
