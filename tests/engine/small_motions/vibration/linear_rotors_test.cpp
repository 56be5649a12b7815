// Linear models of several rotors on one support: what their matrices must equal.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "tests/engine/small_motions/vibration/rotors_on_carrier.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using test::kSprings;
using test::make_on_carrier;
using test::message_of;
using test::RotorText;

/// Lists the signals of a list by their names.
std::vector<std::string> names_of(const std::vector<LinearSignal>& signals) {
  std::vector<std::string> names;
  for (const LinearSignal& signal : signals) names.push_back(signal.name);
  return names;
}

/// Returns the number of each name in a list, which must have it once.
std::vector<Index> places_in(const std::vector<LinearSignal>& signals,
                             const std::vector<std::string>& names) {
  const std::vector<std::string> all = names_of(signals);
  std::vector<Index> places;
  for (const std::string& name : names) {
    CAPTURE(name);
    REQUIRE(std::count(all.begin(), all.end(), name) == 1);
    places.push_back(std::find(all.begin(), all.end(), name) - all.begin());
  }
  return places;
}
/// Lists outputs without those of the support's tip, which is the hub of its last rotor.
std::vector<std::string> without_tip(const std::vector<LinearSignal>& outputs) {
  std::vector<std::string> names = names_of(outputs);
  std::erase_if(names, [](const std::string& name) { return name.starts_with("support.tip"); });
  return names;
}
Index place_in(const std::vector<LinearSignal>& signals, const std::string& name) {
  return places_in(signals, {name}).front();
}

/// Returns C (s - A)^-1 B + D.
MatrixXcd respond(const LinearSystem& system, std::complex<double> s) {
  const Index n = system.A.rows();
  const MatrixXcd sA = s * MatrixXcd::Identity(n, n) - MatrixXd(system.A);
  return MatrixXd(system.C) * sA.partialPivLu().solve(MatrixXcd(MatrixXd(system.B))) +
         MatrixXd(system.D);
}

/// Whether matrices are the same, each entry by the largest of its row and column.
bool are_near(const MatrixXcd& a, const MatrixXcd& b, double error) {
  for (Index r = 0; r < a.rows(); ++r)
    for (Index c = 0; c < a.cols(); ++c) {
      const double size =
          std::sqrt(b.row(r).cwiseAbs().maxCoeff() * b.col(c).cwiseAbs().maxCoeff());
      if (!(std::abs(a(r, c) - b(r, c)) <= error * size)) return false;
    }
  return true;
}

/// A load and sensors of all blades.
const std::string kOnBlades = R"(
[[load]]
frame = "body"
force = [0.3, 0.0, 2.0]
[[sensor]]
name = "near"
quantity = "section_force"
position = 0.5
[[sensor]]
name = "end"
quantity = "acceleration"
frame = "hub"
)";

RotorText main_rotor(const std::string& name) {
  return {.name = name,
          .speed = 20.0,
          .place = "[0.3, 0.2, 1]",
          .blades = 3,
          .drive = "{ kind = \"free\", initial_speed = 20.0 }"};
}
RotorText tail_rotor(const std::string& name) {
  return {.name = name,
          .speed = 31.0,
          .place = "[-3, 0.1, 0.5]",
          .hub = "axis = [0, 1, 0], mass = 0.5, inertia = 0.02",
          .blades = 4,
          .drive = "{ kind = \"free\", initial_speed = 31.0 }"};
}

std::string hub_load(const std::string& rotor, const std::string& force,
                     const std::string& torque = "[0, 0, 0]") {
  return "[[hub_load]]\n" + (rotor.empty() ? rotor : "rotor = \"" + rotor + "\"\n") +
         "frame = \"inertial\"\nforce = " + force + "\ntorque = " + torque + "\n";
}

}  // namespace

TEST_CASE("linear rotors: one without mass leaves the matrices of the other as they are") {
  const auto sets = [](bool turns) {
    RotorText main = main_rotor("");
    if (!turns) main.drive = "{ kind = \"free\", initial_speed = 0.0 }";
    const LinearSystem one = solve_linear_system(
        make_on_carrier(kSprings, {main}, kOnBlades + hub_load("", "[3, 2, 0]")));
    main.name = "main";
    const RotorText tail{.name = "tail",
                         .speed = turns ? 90.0 : 0.0,
                         .place = "[-3, 0, 0.5]",
                         .hub = "axis = [0, 1, 0], mass = 1e-8, inertia = 1e-9"};
    const LinearSystem two = solve_linear_system(
        make_on_carrier(kSprings, {main, tail}, kOnBlades + hub_load("main", "[3, 2, 0]")));
    return std::pair(one, two);
  };
  for (const bool turns : {true, false}) {
    const auto [one, two] = sets(turns);
    CHECK(two.frame == (turns ? ModeFrame::fixed : ModeFrame::turning));
    CHECK(names_of(two.states) == names_of(one.states));
    const auto states = places_in(two.states, names_of(one.states));
    const auto inputs = places_in(two.inputs, names_of(one.inputs));
    const auto shown = without_tip(one.outputs);
    const auto outputs = places_in(two.outputs, shown);
    const auto of_one = places_in(one.outputs, shown);
    CHECK(std::ssize(two.inputs) == std::ssize(one.inputs) + 6);
    CHECK(std::ssize(two.outputs) == std::ssize(one.outputs) + 12);
    CHECK(two.left_out_inputs == one.left_out_inputs);
    CHECK(two.left_out == one.left_out);
    CHECK(are_near(MatrixXd(two.A)(states, states), MatrixXd(one.A), 1e-6));
    CHECK(are_near(MatrixXd(two.B)(states, inputs), MatrixXd(one.B), 1e-6));
    CHECK(are_near(MatrixXd(two.C)(outputs, states), MatrixXd(one.C)(of_one, Eigen::all), 1e-6));
    CHECK(are_near(MatrixXd(two.D)(outputs, inputs), MatrixXd(one.D)(of_one, Eigen::all), 1e-6));
  }
}

TEST_CASE("linear rotors: eigenvalues are those of the modes") {
  const auto rotors = [](double share) {
    RotorText main = main_rotor("main"), tail = tail_rotor("tail");
    main.drive = "{ kind = \"constant\", speed = " + std::to_string(share * main.speed) + " }";
    tail.drive = "{ kind = \"free\", initial_speed = " + std::to_string(share * tail.speed) + " }";
    return make_on_carrier(kSprings, {main, tail});
  };
  for (const double share : {1.0, 0.0}) {
    const Scenario scenario = rotors(share);
    const LinearSystem system = solve_linear_system(scenario);
    const ModesResult modes = solve_modes(scenario, {.count = 30, .frame = system.frame});
    const Eigen::VectorXcd roots = MatrixXd(system.A).eigenvalues();
    CHECK(system.frame == (share > 0.0 ? ModeFrame::fixed : ModeFrame::turning));
    for (const Mode& mode : modes.modes) {
      CAPTURE(mode.name);
      const double error = (roots.array() - mode.eigenvalue).abs().minCoeff();
      // What turns freely has a pair of roots at zero, which round-off takes apart by its root.
      CHECK(error < (mode.frequency > 0.0 ? 1e-6 * mode.frequency : 1e-3));
    }
  }
}

TEST_CASE("linear rotors: the order in which they are given does not change responses") {
  const auto make = [](const RotorText& first, const RotorText& second) {
    return make_on_carrier(
        kSprings, {first, second},
        kOnBlades + hub_load("main", "[3, 2, 1]") + hub_load("tail", "[-1, 2, 3]"));
  };
  const LinearSystem one = solve_linear_system(make(main_rotor("main"), tail_rotor("tail")));
  const LinearSystem other = solve_linear_system(make(tail_rotor("tail"), main_rotor("main")));
  // Names of the other, of those of the one.
  const auto exchange = [](std::vector<std::string> names) {
    const auto replace = [](const std::string& from, const std::string& to, std::string& name) {
      const std::size_t at = name.find(from);
      if (at == std::string::npos) return false;
      name.replace(at, from.size(), to);
      return true;
    };
    for (std::string& name : names)
      replace("blades 1 to 3", "blades 5 to 7", name) ||
          replace("blades 4 to 7", "blades 1 to 4", name) || replace("tail.", "", name) ||
          replace("hub /", "main.hub /", name) || replace("axle", "main.axle", name);
    return names;
  };
  CHECK(std::ssize(other.inputs) == std::ssize(one.inputs));
  CHECK(std::ssize(other.outputs) == std::ssize(one.outputs));
  const auto inputs = places_in(other.inputs, exchange(names_of(one.inputs)));
  const auto shown = without_tip(one.outputs);
  const auto outputs = places_in(other.outputs, exchange(shown));
  const auto of_one = places_in(one.outputs, shown);
  places_in(one.inputs, {"axle / torque", "tail.axle / torque", "tail.hub / hub_load.2"});
  places_in(one.states, {"support / tail.axle", "rate of support / axle"});
  for (const double frequency : {3.0, 17.0, 60.0}) {
    const std::complex<double> s(1.0, frequency);
    CHECK(are_near(respond(other, s)(outputs, inputs), respond(one, s)(of_one, Eigen::all), 1e-6));
  }
}

TEST_CASE("linear rotors: equal ones on either side of their carrier respond alike") {
  const auto at = [](const std::string& name, const std::string& place) {
    return RotorText{.name = name, .speed = 20.0, .place = place, .blades = 3};
  };
  const LinearSystem system = solve_linear_system(
      make_on_carrier(kSprings, {at("left", "[0, 2.5, 1]"), at("right", "[0, -2.5, 1]")}));
  const MatrixXcd gains = respond(system, {0.5, 14.0});
  // Half a turn about the vertical takes one into the other.
  const std::vector<std::string> motions{"hub / x", "hub / y", "hub / z", "hub / rotation z"};
  const std::vector<std::string> efforts{"hub / force x", "hub / force y", "hub / force z",
                                         "hub / torque"};
  const Eigen::Vector4d half_turn(-1.0, -1.0, 1.0, 1.0);
  const auto of_right = [](std::vector<std::string> names) {
    for (std::string& name : names) name = "right." + name;
    return names;
  };
  std::vector<std::string> turned = motions;
  turned.back() = "hub / angle";
  const auto left_y = places_in(system.outputs, turned);
  const auto right_y = places_in(system.outputs, of_right(turned));
  const auto left_u = places_in(system.inputs, efforts);
  const auto right_u = places_in(system.inputs, of_right(efforts));
  const auto turn = [&](const MatrixXcd& m) {
    return MatrixXcd(half_turn.asDiagonal() * m * half_turn.asDiagonal());
  };
  CHECK(are_near(turn(gains(right_y, right_u)), gains(left_y, left_u), 1e-7));
  CHECK(are_near(turn(gains(right_y, left_u)), gains(left_y, right_u), 1e-7));
}

TEST_CASE("linear rotors: one that stands beside one that turns is seen from outside") {
  RotorText main = main_rotor("main");
  main.drive = "{ kind = \"fixed\" }";
  const Scenario scenario = make_on_carrier(kSprings, {main, tail_rotor("tail")});
  CHECK(solve_linear_system(scenario).frame == ModeFrame::fixed);
  CHECK(message_of([&] { solve_linear_system(scenario, {}, ModeFrame::turning); }) ==
        "the frame \"turning\" expects a hub whose support does not move, or a speed of 0: on a "
        "support the frame \"fixed\" has constant matrices");
  CHECK(solve_linear_system(scenario, {.speeds = {{"tail", 0.0}}}).frame == ModeFrame::turning);
}

TEST_CASE("linear rotors: at rest the torque behind a shaft acts on its generator in both frames") {
  RotorText main = main_rotor("main"), tail = tail_rotor("tail");
  main.drive = tail.drive = "{ kind = \"free\" }";
  Scenario scenario = make_on_carrier(kSprings, {main, tail});
  scenario.space->rotors[0].axle.train = spatial::DriveTrain{2000.0, 5.0, 10.0, 0.02};
  const LinearSystem turning = solve_linear_system(scenario);
  const LinearSystem fixed = solve_linear_system(scenario, {}, ModeFrame::fixed);
  const std::vector<std::string> inputs{"axle / torque", "tail.axle / torque"};
  const std::vector<std::string> outputs{"hub / angle", "tail.hub / angle", "hub / x"};
  const auto answer = [&](const LinearSystem& system) {
    return MatrixXcd(respond(system, {1.0, 20.0})(places_in(system.outputs, outputs),
                                                  places_in(system.inputs, inputs)));
  };
  CHECK(turning.frame == ModeFrame::turning);
  CHECK(are_near(answer(turning), answer(fixed), 1e-6));
}

TEST_CASE("linear rotors: static gains of the second are differences of equilibria") {
  RotorText main = main_rotor("main"), tail = tail_rotor("tail");
  for (const bool turns : {true, false}) {
    CAPTURE(turns);
    main.drive = turns ? "{ kind = \"constant\", speed = 20.0 }" : "{ kind = \"fixed\" }";
    tail.drive = turns ? "{ kind = \"constant\", speed = 31.0 }" : "{ kind = \"fixed\" }";
    std::string loads = hub_load("tail", "[30, 50, -20]", "[4, 0, 3]");
    for (int blade = 4; blade <= 7; ++blade)
      loads += "[[load]]\nblade = " + std::to_string(blade) +
               "\nframe = \"body\"\nforce = [0, 0.5, 2]\n";
    const Scenario scenario =
        make_on_carrier(kSprings, {main, tail}, loads + hub_load("main", "[0, 0, 200]"));
    const LinearSystem system = solve_linear_system(scenario);
    const MatrixXd gains = respond(system, 0.0).real();
    const auto of_blade = [](int blade) {
      return "blade " + std::to_string(blade) + " / load." + std::to_string(blade - 3);
    };
    const auto of_blades =
        turns ? places_in(system.inputs,
                          {"blades 4 to 7 / load.1, load.2, load.3, load.4 collective"})
              : places_in(system.inputs, {of_blade(4), of_blade(5), of_blade(6), of_blade(7)});
    const Index of_hub = place_in(system.inputs, "tail.hub / hub_load.1");
    constexpr double kStep = 1e-2;
    for (const bool is_of_hub : {true, false}) {
      const Eigen::VectorXd by = is_of_hub ? Eigen::VectorXd(gains.col(of_hub))
                                           : gains(Eigen::all, of_blades).rowwise().sum();
      const auto solve = [&](double factor) {
        Scenario loaded = scenario;
        if (is_of_hub)
          loaded.space->hub_loads[0].factor = Curve(factor);
        else
          for (spatial::PointLoad& load : loaded.space->loads) load.factor = Curve(factor);
        return solve_equilibrium(loaded);
      };
      const EquilibriumResult at = solve(1.0), plus = solve(1.0 + kStep),
                              minus = solve(1.0 - kStep);
      const auto check = [&](const auto& value, const std::string& of, const std::string& which) {
        CAPTURE(of);
        const Vector3d known = (value(plus) - value(minus)) / (2.0 * kStep);
        Vector3d found;
        for (int c = 0; c < 3; ++c) found[c] = by[place_in(system.outputs, of + "xyz"[c] + which)];
        CHECK((found - known).norm() < 1e-5 * known.norm() + 1e-12);
      };
      for (std::size_t r = 0; r < 2; ++r)
        check(
            [&](const EquilibriumResult& e) {
              return Vector3d(at.rotors[r].hub.axes.transpose() * e.rotors[r].hub.position);
            },
            r == 0 ? "hub / " : "tail.hub / ", "");
      // The first blade of the second rotor is at azimuth zero.
      check([](const EquilibriumResult& e) { return e.blades[3].tip_displacement; },
            turns ? "blades 4 to 7 / tip." : "blade4.tip.", turns ? " collective" : "");
    }
  }
}

}  // namespace spoke
