// Tests cantilevers under axial forces: frequencies from the differential equation of the beam, and
// the columns of Euler and Beck. L = m = EI = 1.

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "tests/engine/small_motions/steady/blades.h"

namespace spoke {
namespace {

using test::make_planar;
using test::make_spatial;
using test::UnitBlade;

/// Returns a function that is zero at the frequencies w of a cantilever under a tension P at its
/// tip: v'''' - P v'' = w^2 v, v = v' = 0 at the root, v'' = 0 at the tip and v''' = P v' there, or
/// v''' = 0 if the force follows the section.
double characteristic(double P, bool follows, double w) {
  const double root = std::sqrt(0.25 * P * P + w * w);
  const double a = std::sqrt(root + 0.5 * P), b = std::sqrt(root - 0.5 * P);
  const double sh = std::sinh(a), ch = std::cosh(a), s = std::sin(b), c = std::cos(b);
  const double dead = follows ? 0.0 : P;
  // Moments of sinh ax - a/b sin bx and of cosh ax - cos bx.
  const double moment[] = {a * a * sh + a * b * s, a * a * ch + b * b * c};
  const double shear[] = {a * a * a * ch + a * b * b * c - dead * (a * ch - a * c),
                          a * a * a * sh - b * b * b * s - dead * (a * sh + b * s)};
  return (moment[0] * shear[1] - moment[1] * shear[0]) / (ch * ch);
}

std::vector<double> find_frequencies(double P, bool follows, std::size_t count) {
  std::vector<double> found;
  constexpr double kStep = 0.01;
  for (double w = 1e-3; found.size() < count; w += kStep) {
    double low = w, high = w + kStep;
    const double sign = characteristic(P, follows, low);
    if (sign * characteristic(P, follows, high) > 0.0) continue;
    while (high - low > 1e-10 * high) {
      const double middle = 0.5 * (low + high);
      (sign * characteristic(P, follows, middle) > 0.0 ? low : high) = middle;
    }
    found.push_back(low);
  }
  return found;
}

/// Returns the first two components of P along a blade at an azimuth [rad].
std::string along(double P, double azimuth) {
  return '[' + std::to_string(P * std::cos(azimuth)) + ", " + std::to_string(P * std::sin(azimuth));
}
std::string tip_force(const std::string& frame, const std::string& force) {
  return "[[load]]\nframe = \"" + frame + "\"\nforce = " + force;
}
constexpr double kAzimuth = 0.3;  // of make_spatial()

/// Makes this cantilever in the plane, or in space.
Scenario in_plane(UnitBlade blade, double P, const char* frame, ReferenceFrame reference) {
  blade.more = tip_force(frame, along(P, 0.0)) + "]\n";
  Scenario scenario = make_planar(blade);
  for (Blade& each : scenario.rotor.blades) each.reference_frame = reference;
  return scenario;
}
Scenario in_space(UnitBlade blade, double P, const char* frame) {
  const bool follows = std::string(frame) == "section";
  blade.more = tip_force(frame, along(P, follows ? 0.0 : kAzimuth)) + ", 0.0]\n";
  return make_spatial(blade);
}

void check_first(const Scenario& scenario, const std::vector<double>& known, double error) {
  const ModesResult result = solve_modes(scenario, {.count = 8});
  std::size_t k = 0;
  for (const Mode& mode : result.modes) {
    if (k == known.size() || mode.name.find("lag") == std::string::npos) continue;
    CHECK(mode.frequency == doctest::Approx(known[k]).epsilon(error));
    CHECK_FALSE(mode.eigenvalue.real() > 1e-6);
    ++k;
  }
  CHECK(k == known.size());
}

/// Whether the straight column is stable: no mode grows.
bool is_stable(const Scenario& scenario) {
  for (const Mode& mode : solve_modes(scenario, {.count = 4}).modes)
    if (mode.eigenvalue.real() > 1e-6) return false;
  return true;
}

/// Returns the least compression between two at which a column is not stable.
double find_critical(const std::function<Scenario(double P)>& make, double low, double high) {
  REQUIRE(is_stable(make(low)));
  REQUIRE_FALSE(is_stable(make(high)));
  while (high - low > 1e-5 * high) {
    const double middle = 0.5 * (low + high);
    (is_stable(make(middle)) ? low : high) = middle;
  }
  return low;
}

constexpr double kEuler = M_PI * M_PI / 4.0;
/// Beck 1952, Z. angew. Math. Phys. 3, 225-228.
constexpr double kBeck = 20.0509536;

}  // namespace

TEST_CASE("columns: a force along a cantilever stiffens it, or makes it softer, within a body") {
  for (const double P : {-2.0, 2.0, 10.0, 100.0}) {
    CAPTURE(P);
    const std::vector<double> known = find_frequencies(P, false, 3);
    if (P == 100.0) CHECK(known[0] == doctest::Approx(17.61).epsilon(1e-4));
    for (const char* frame : {"hub", "inertial"}) {
      for (const ReferenceFrame reference : {ReferenceFrame::clamped, ReferenceFrame::chord}) {
        check_first(in_plane({.bodies = 4}, P, frame, reference), known, 1e-3);
        check_first(in_plane({.bodies = 1, .elements = 8}, P, frame, reference), known, 1e-3);
      }
      check_first(in_space({.bodies = 4}, P, frame), known, 1e-3);
      check_first(in_space({.bodies = 1, .elements = 8}, P, frame), known, 1e-3);
    }
    // At 100 the slope changes over a tenth of the length, less than half an element.
    const double coarse = P == 100.0 ? 2e-3 : 1e-3;
    check_first(in_plane({.bodies = 1}, P, "hub", ReferenceFrame::clamped), {known[0]}, coarse);
    check_first(in_space({.bodies = 1}, P, "hub"), {known[0]}, coarse);
  }
}

TEST_CASE("columns: a force that follows the tip's section has its own frequencies") {
  for (const double P : {-10.0, 10.0}) {
    CAPTURE(P);
    const std::vector<double> known = find_frequencies(P, true, 2);
    for (const int bodies : {1, 4}) {
      check_first(in_plane({.bodies = bodies, .elements = bodies == 1 ? 8 : 4}, P, "section",
                           ReferenceFrame::clamped),
                  known, 1e-3);
      check_first(in_space({.bodies = bodies, .elements = bodies == 1 ? 8 : 4}, P, "section"),
                  known, 1e-3);
    }
  }
}

TEST_CASE("columns: loads along a beam are gravity's, in plane and space") {
  // The hanging cantilever of docs/formulation.md, g = 20.
  const std::vector<double> known{6.59777, 25.64466};
  for (const int bodies : {1, 4}) {
    const UnitBlade blade{.bodies = bodies};
    UnitBlade with_load = blade, with_gravity = blade;
    with_load.more = "[[distributed_load]]\nframe = \"inertial\"\nforce_per_length = [20.0, 0.0]\n";
    with_gravity.more = "[gravity]\nacceleration = [20.0, 0.0]\n";
    check_first(make_planar(with_load), known, 1e-3);
    check_first(make_planar(with_gravity), known, 1e-3);
    with_load.more =
        "[[distributed_load]]\nframe = \"inertial\"\nforce_per_length = " + along(20.0, kAzimuth) +
        ", 0.0]\n";
    with_gravity.more = "[gravity]\nacceleration = " + along(20.0, kAzimuth) + ", 0.0]\n";
    check_first(make_spatial(with_load), known, 1e-3);
    check_first(make_spatial(with_gravity), known, 1e-3);
  }
}

TEST_CASE("columns: Euler's column buckles, and Beck's flutters, at its load") {
  for (const int bodies : {1, 4}) {
    CAPTURE(bodies);
    const UnitBlade blade{.bodies = bodies, .elements = bodies == 1 ? 8 : 4};
    const auto dead = [&](double P) { return in_plane(blade, -P, "hub", ReferenceFrame::clamped); };
    const auto follower = [&](double P) { return in_space(blade, -P, "section"); };
    CHECK(find_critical(dead, 2.0, 3.0) == doctest::Approx(kEuler).epsilon(2e-3));
    CHECK(find_critical(follower, 18.0, 22.0) == doctest::Approx(kBeck).epsilon(2e-3));
  }
}

TEST_CASE(
    "columns: their critical loads converge with the square of the number of bodies or faster") {
  const auto errors = [](const std::function<Scenario(int, double)>& make, double known, double low,
                         double high) {
    std::vector<double> list;
    for (const int bodies : {4, 8})
      list.push_back(std::abs(
          find_critical([&](double P) { return make(bodies, P); }, low, high) / known - 1.0));
    return list;
  };
  const auto dead = errors(
      [](int n, double P) {
        return in_plane({.bodies = n, .elements = 1}, -P, "hub", ReferenceFrame::clamped);
      },
      kEuler, 2.0, 3.0);
  CHECK(dead[1] < 0.3 * dead[0] + 2e-5);
  const auto follower =
      errors([](int n, double P) { return in_space({.bodies = n, .elements = 1}, -P, "section"); },
             kBeck, 15.0, 30.0);
  CHECK(follower[1] < 0.3 * follower[0] + 2e-5);
}

}  // namespace spoke
