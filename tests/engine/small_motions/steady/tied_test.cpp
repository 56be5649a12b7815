// Steady states of subsystems of one hub that loops and couplings between them tie: those of the
// same as one subsystem, values found with other programs, and how blades are told apart.

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/engine/loops/tied_arms.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using doctest::Approx;
using test::kArms;
using test::make_hammond;
using test::make_tied_arms;
using test::message_of;

constexpr double kPi = std::numbers::pi;

struct Tie {
  std::string text;
  int count;  ///< of rigid ones a ring would be another machine
};
const std::vector<Tie> kTies{{"kind='distance'", kArms - 2},
                             {"kind='distance', stiffness=3e4, damping=400", kArms - 1},
                             {"kind='bearing', axis=[0,0.2,1], stiffness=[[3e3,800],[-500,2e3]],"
                              " damping=[[30,4],[-4,20]]",
                              kArms},
                             {"coupling", kArms - 2},
                             {"coupling, stiffness=80, damping=2", kArms - 2}};

Scenario parse(const std::string& text) { return parse_scenario(text, "tied.toml"); }

/// Returns the eigenvalues of modes in the order of their sizes, without the slow ones.
std::vector<std::complex<double>> list_eigenvalues(const ModesResult& found) {
  std::vector<std::complex<double>> list;
  for (const Mode& mode : found.modes) list.push_back(mode.eigenvalue);
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return std::pair(std::abs(a.imag()), a.real()) < std::pair(std::abs(b.imag()), b.real());
  });
  return list;
}

void check_equal(const ModesResult& one, const ModesResult& other, double tolerance) {
  const auto a = list_eigenvalues(one), b = list_eigenvalues(other);
  REQUIRE(a.size() == b.size());
  REQUIRE(!a.empty());
  for (std::size_t k = 0; k < a.size(); ++k) {
    CAPTURE(k);
    CAPTURE(a[k].imag());
    CHECK(std::abs(a[k] - b[k]) < tolerance * (1.0 + std::abs(a[k])));
  }
}

std::map<std::string, double> list_joints(const EquilibriumResult& found, bool is_apart) {
  std::map<std::string, double> joints;
  for (std::size_t i = 0; i < found.blades.size(); ++i)
    for (const JointPosition& joint : found.blades[i].joints) {
      // "hinge 2" of the third arm is "hinge2 2" of the one subsystem.
      const bool is_arm = is_apart && found.blades[i].name.starts_with("arm");
      const std::size_t space = std::min(joint.name.find(' '), joint.name.size());
      joints[is_arm ? joint.name.substr(0, space) + std::to_string(i) + joint.name.substr(space)
                    : joint.name] = joint.value;
    }
  return joints;
}

/// A rotor of equal flexible blades on a driven hub, each tied to the next by a spring and damper.
/// `is_skew`: whether the ties are not alike in both directions.
std::string make_flexible_ring(int blades, bool is_skew) {
  return "world='space'\n[hub]\nradius=0.1\n[hub.drive]\nkind='constant'\nspeed=25\n"
         "[blade]\ncount=" +
         std::to_string(blades) +
         "\nlength=2.0\nbodies=2\nelements=1\n[blade.sections]\nmass_per_length=2\n"
         "axial_stiffness=2e6\nflap_stiffness=2e3\nlag_stiffness=6e3\ntorsion_stiffness=2e3\n"
         "[[blade.loop]]\nname='tie'\nkind='distance'\nstiffness=4e3\ndamping=30\n"
         "from={ station=1.0 }\nto={ blade='next', station=" +
         std::string(is_skew ? "2.0" : "1.0") + " }\n" + test::kOfASecond;
}

}  // namespace

TEST_CASE("tied subsystems: their equilibrium, modes and linear model are those of one subsystem") {
  for (const std::size_t hub : {0, 3})
    for (const Tie& tie : kTies) {
      CAPTURE(test::kHubs[hub].name);
      CAPTURE(tie.text);
      const std::string& on = test::kHubs[hub].text;
      const Scenario apart = parse(make_tied_arms(on, true, tie.text, tie.count));
      const Scenario together = parse(make_tied_arms(on, false, tie.text, tie.count));
      const EquilibriumResult found = solve_equilibrium(apart, {});
      const EquilibriumResult expected = solve_equilibrium(together, {});
      REQUIRE(found.blades.size() == (hub == 3 ? kArms + 1 : kArms));
      const auto joints = list_joints(found, true), same = list_joints(expected, false);
      REQUIRE(joints.size() == same.size());
      for (const auto& joint : joints) {
        CAPTURE(joint.first);
        CHECK(joint.second == Approx(same.at(joint.first)).epsilon(1e-9).scale(1.0));
      }
      CHECK((found.hub_force - expected.hub_force).norm() < 1e-7 * expected.hub_force.norm());
      CHECK((found.hub_moment - expected.hub_moment).norm() < 1e-7 * expected.hub_force.norm());
      // The support that moves sees arms that are not alike.
      const ModeFrame frame = hub == 3 ? ModeFrame::floquet : ModeFrame::turning;
      check_equal(solve_modes(apart, {.count = 40, .frame = frame}),
                  solve_modes(together, {.count = 40, .frame = frame}), 1e-6);
      if (hub == 3) continue;
      const auto roots = [](const Scenario& scenario) {
        Eigen::VectorXcd list =
            Eigen::MatrixXd(solve_linear_system(scenario, {}, ModeFrame::turning).A).eigenvalues();
        return list.imag().maxCoeff();
      };
      CHECK(roots(apart) == Approx(roots(together)).epsilon(1e-6));
    }
}

TEST_CASE("tied subsystems: loads of bodies and loops in equilibrium are those of a run at rest") {
  // On a hub that stands, hinges with springs come to rest.
  const std::string text =
      "world='space'\n[hub]\ninertia=5\n[hub.drive]\nkind='fixed'\n" + test::kWeight +
      "[[subsystem]]\nname='a'\nbody=[ { name='rod', kind='rigid', mass=2, center=[0.5,0,0],"
      " inertia=[0.01,0.2,0.2] } ]\njoint=[ { name='hinge', parent='hub', child='rod',"
      " kind='universal', axes=[[0,1,0],[0,0,1]], stiffness=[30,20], damping=[4,4] } ]\n"
      "loop=[ { name='tie', kind='distance', from={ body='rod', point=[0.8,0,0.1] },"
      " to={ subsystem='b', body='rod', point=[0.7,0,0] } } ]\n"
      "[[subsystem]]\nname='b'\nazimuth=1.2\nbody=[ { name='rod', kind='rigid', mass=3,"
      " center=[0.4,0,0], inertia=[0.01,0.2,0.2] } ]\njoint=[ { name='hinge', parent='hub',"
      " child='rod', kind='universal', axes=[[0,1,0],[0,0,1]], stiffness=[50,70], damping=[4,4] } "
      "]\n";
  const std::string sensors =
      "[[sensor]]\nname='tie'\nquantity='loop_reaction'\nframe='hub'\nsubsystem='a'\nloop='tie'\n"
      "[[sensor]]\nname='foot'\nquantity='joint_reaction'\nsubsystem='b'\nbody='rod'\n";
  const EquilibriumResult found = solve_equilibrium(parse(text + test::kOfASecond), {});
  Simulation run(
      parse(text + sensors +
            "[initial]\nstate='equilibrium'\n[integration]\nstep=1e-3\nduration=0.05\n"));
  for (int k = 0; k < 50; ++k) run.step();
  for (const BladeEquilibrium& blade : found.blades)
    for (const JointPosition& joint : blade.joints) CHECK(std::abs(joint.value) > 1e-3);
  const auto value = [&run](const std::string& name) { return run.sensor(name); };
  REQUIRE(found.blades[0].loops.size() == 1);
  CHECK(found.blades[1].loops.empty());
  const LoopLoad& tie = found.blades[0].loops[0];
  CHECK(tie.force.norm() > 1.0);
  for (int c = 0; c < 3; ++c) {
    const std::string axis(1, static_cast<char>('x' + c));
    CAPTURE(axis);
    CHECK(tie.force[c] == Approx(value("a.tie.force." + axis)).epsilon(1e-6).scale(1.0));
  }
  // What the rod's end bears, of its weight and of the tie.
  const SectionLoad& foot = found.blades[1].loads[0];
  CHECK(foot.force.norm() > 5.0);
  CHECK(foot.force.norm() == Approx(std::hypot(value("b.foot.force.x"), value("b.foot.force.y"),
                                               value("b.foot.force.z")))
                                 .epsilon(1e-6));
}

TEST_CASE("Hammond's rotor with a ring of dampers, and with one of it missing: modes") {
  const double speed = 200.0 * kPi / 30.0;
  // By a program of the authors' own, with the blades as one subsystem.
  const double whole = -1.0494524, broken = -0.5608588;
  const auto slowest = [](const ModesResult& found) {
    double growth = -1e9;
    for (const Mode& mode : found.modes)
      if (mode.eigenvalue.real() < -1e-6) growth = std::max(growth, mode.eigenvalue.real());
    return growth;
  };
  const ModesResult ring = solve_modes(parse(make_hammond(speed, 0)), {.count = 6});
  CHECK(ring.frame == ModeFrame::fixed);
  CHECK(slowest(ring) == Approx(whole).epsilon(1e-6));
  const ModesResult open = solve_modes(parse(make_hammond(speed, 1)), {.count = 6});
  CHECK(open.frame == ModeFrame::floquet);
  CHECK(slowest(open) == Approx(broken).epsilon(1e-6));
}

TEST_CASE("a ring of blades: a pattern of lag has the dampers of its own neighbours") {
  // Of N hinges with a spring k, pattern n has dampers of 2 c (1 - cos(2 pi n/N)). A damper d
  // between neighbours at a right angle, at the radius a from the hinges, has c = d a^2/2.
  const double a = 1.5, d = 0.5 * 4067.5 / (a * a * 0.5), inertia = 1084.7, k = 2e5;
  const ModesResult found =
      solve_modes(parse(make_hammond(0.0, 0, ", stiffness=" + test::number(k))), {.count = 6});
  const auto damping_of = [&](const std::string& name) {
    for (const Mode& mode : found.modes)
      if (mode.name.find(name) != std::string::npos) return -2.0 * mode.eigenvalue.real() * inertia;
    FAIL(name);
    return 0.0;
  };
  // Both ends move alike in the collective pattern, against one another in the differential.
  CHECK(std::abs(damping_of("collective")) < 1e-6);
  const double c = d * a * a * 0.5;
  CHECK(damping_of("differential") == Approx(4.0 * c).epsilon(1e-6));
}

TEST_CASE("a ring of blades: seen from outside roots are shifted by multiples of the speed") {
  constexpr double kSpeed = 25.0;
  for (const int blades : {3, 4, 5})
    for (const bool is_skew : {false, true}) {
      CAPTURE(blades);
      CAPTURE(is_skew);
      const Scenario scenario = parse(make_flexible_ring(blades, is_skew));
      const ModesResult fixed = solve_modes(scenario, {.count = 12, .frame = ModeFrame::fixed});
      const ModesResult turning = solve_modes(scenario, {.count = 500});
      CHECK(turning.frame == ModeFrame::turning);
      for (const Mode& mode : fixed.modes) {
        CAPTURE(mode.name);
        double nearest = 1e9;
        for (const Mode& other : turning.modes)
          for (int n = -blades / 2; n <= blades / 2; ++n)
            for (const double sign : {1.0, -1.0}) {
              const std::complex<double> shifted(other.eigenvalue.real(),
                                                 sign * other.eigenvalue.imag() + n * kSpeed);
              nearest = std::min(nearest, std::abs(mode.eigenvalue - shifted));
            }
        CHECK(nearest < 1e-6 * (1.0 + std::abs(mode.eigenvalue)));
      }
    }
}

TEST_CASE("a ring of blades on a support: multi-blade coordinates have Floquet's roots") {
  constexpr double kSpeed = 20.0;
  const Scenario scenario = parse(make_hammond(kSpeed, 0, ", stiffness=3e4"));
  const ModesResult fixed = solve_modes(scenario, {.count = 6});
  const ModesResult floquet = solve_modes(scenario, {.count = 6, .frame = ModeFrame::floquet});
  CHECK(fixed.frame == ModeFrame::fixed);
  REQUIRE(fixed.modes.size() == floquet.modes.size());
  for (const Mode& mode : fixed.modes) {
    CAPTURE(mode.name);
    // A root is that of a multiplier up to whole turns.
    double nearest = 1e9;
    for (const Mode& other : floquet.modes)
      for (int n = -4; n <= 4; ++n)
        for (const double sign : {1.0, -1.0}) {
          const std::complex<double> shifted(other.eigenvalue.real(),
                                             sign * other.eigenvalue.imag() + n * kSpeed);
          nearest = std::min(nearest, std::abs(mode.eigenvalue - shifted));
        }
    CHECK(nearest < 1e-7 * (1.0 + std::abs(mode.eigenvalue)));
  }
}

TEST_CASE("a ring of blades: each has a shape of its own, and a place in results") {
  const Scenario scenario = parse(make_flexible_ring(3, false));
  const ModesResult found = solve_modes(scenario, {.count = 4, .frame = ModeFrame::fixed});
  REQUIRE(found.equilibrium.blades.size() == 3);
  CHECK(found.equilibrium.blades[1].name == "blade 2");
  for (const Mode& mode : found.modes) {
    REQUIRE(mode.shape.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(mode.shape[i].size() == found.equilibrium.blades[i].nodes.size());
  }
}

TEST_CASE(
    "tied blades: inputs of linear models are those of single blades, or of several together") {
  const std::string hinges = make_hammond(20.0, 0, ", stiffness=3e4");
  const std::size_t support = hinges.find("[support]"), blades = hinges.find("[[subsystem]]");
  const LinearSystem system = solve_linear_system(
      parse(hinges.substr(0, support) + hinges.substr(blades) +
            "[[load]]\nsubsystem='b1'\nbody='rod'\npoint=[1,0,0]\nforce=[0,1,0]\nframe='body'\n"),
      {}, ModeFrame::turning);
  std::set<std::string> names;
  for (const LinearSignal& input : system.inputs) names.insert(input.name);
  CHECK(names.size() == system.inputs.size());
  CHECK(names.contains("b1 / load.1"));
  CHECK(names.contains("b2 / lag motor"));
  CHECK(system.states.front().name == "b0 / lag");
}

TEST_CASE("tied blades: what is not taken is said") {
  const std::string skew = make_hammond(20.0, 1);
  CHECK(message_of([&] { solve_modes(parse(skew), {.frame = ModeFrame::fixed}); }) ==
        "the frame \"fixed\" expects loops between blades to tie them alike all around, as those "
        "of b0, b1, b2, b3 do not: of modes the frame \"floquet\" takes any blades");
  CHECK(message_of([&] { solve_linear_system(parse(skew), {}, ModeFrame::fixed); }) ==
        "the frame \"fixed\" expects loops between blades to tie them alike all around, as those "
        "of b0, b1, b2, b3 do not: of modes the frame \"floquet\" takes any blades");
}

}  // namespace spoke
