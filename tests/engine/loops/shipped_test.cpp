// Shipped mechanisms as they are run: what their files say to compare them with.

#include "tests/shipped.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "engine/simulation.h"

using doctest::Approx;
using namespace spoke;

namespace {

Simulation simulate(const std::string& name) {
  return Simulation(test::read_shipped(name), {Formulation::structured, ExecutorKind::serial, 1});
}

}  // namespace

TEST_CASE("the shipped squeezer ends where the test set says") {
  Simulation squeezer = simulate("andrews_squeezer");
  squeezer.run_until(INFINITY);
  for (const auto& [joint, angle] :
       {std::pair{"beta", 15.81077119629904}, std::pair{"Theta", -15.75637105984298},
        std::pair{"gamma", 0.04082224013073101}, std::pair{"Phi", -0.5347301163226948},
        std::pair{"delta", 0.5244099658805304}, std::pair{"Omega", 0.5347301163226948},
        std::pair{"epsilon", 1.048080741042263}})
    CHECK(std::abs(squeezer.sensor(std::string("squeezer.") + joint) - angle) < 1e-4);
  CHECK(squeezer.sensor("squeezer.crank.rotation.z") == Approx(1139.920302151208).epsilon(2e-5));
}

TEST_CASE("the shipped linkages go as the bars' differential equation") {
  Simulation linkage = simulate("four_bar");
  linkage.run_until(INFINITY);
  CHECK(std::abs(linkage.sensor("linkage.B0.x") - 0.32845811154) < 1e-4);
  CHECK(std::abs(1.0 + linkage.sensor("linkage.B0.y") - 0.94451853818) < 1e-4);
}

TEST_CASE("Bricard's mechanism falls and comes back, with the energy that it had") {
  Simulation ring = simulate("bricard");
  double residual = 0.0, fastest = 0.0, deepest = 0.0;
  ring.run_until(INFINITY, [&](double, std::span<const double>) {
    residual = std::max(residual, std::abs(ring.sensor("energy.residual")));
    fastest = std::max(fastest, ring.sensor("energy.kinetic"));
    deepest = std::min(deepest, ring.sensor("ring.corner.x"));
  });
  CHECK(fastest > 4.0);
  CHECK(residual < 1e-5 * fastest);
  CHECK(deepest == Approx(-2.0).epsilon(1e-3));  // the other way round
}

TEST_CASE("the car stays level and goes on, and its springs come to rest where they were") {
  Simulation car = simulate("vehicle");
  car.run_until(2.9);
  const double before = car.sensor("front_left.wheel.z"), height = car.sensor("hub.z");
  CHECK(std::abs(car.hub_frame().velocity.z()) < 1e-4);
  car.run_until(3.1);
  CHECK(std::abs(car.sensor("front_left.wheel.z") - before) > 0.03);
  car.run_until(INFINITY);
  CHECK(std::abs(car.sensor("front_left.wheel.z") - before) < 1e-4);
  CHECK(car.sensor("hub.z") > height + 0.01);
  const spatial::Vector velocity = car.hub_frame().velocity;
  CHECK((velocity - spatial::Vector(10.0, 0.0, 0.0)).norm() < 1e-3);
  CHECK(std::abs(car.sensor("hub.rotation.y")) < 2e-3);
  CHECK(std::abs(car.sensor("hub.y")) < 1e-9);
}
