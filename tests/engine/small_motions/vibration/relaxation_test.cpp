// Small motions of joints that relax: against the roots of closed form, against the same spring and
// damper as two joints with next to no mass between, and against runs.

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "engine/critical.h"
#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/simulation.h"
#include "models/scenario.h"
#include "tests/contains.h"
#include "tests/engine/serial.h"
#include "tests/message_of.h"
#include "tests/models/inline_toml.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::contains;
using test::message_of;
using Complex = std::complex<double>;

/// A mass of 2 kg on a spring of 50 N/m beside one of 80 N/m that relaxes within 0.3 s.
const std::string kMassOnRubber = R"(
world = "space"
[hub.drive]
kind = "fixed"
[[subsystem]]
name = "mount"
body = [{ name = "mass", kind = "rigid", mass = 2.0, inertia = 0.2 }]
[[subsystem.joint]]
name = "rubber"
parent = "hub"
child = "mass"
kind = "prismatic"
axis = [1.0, 0.0, 0.0]
stiffness = 50.0
relaxation = { stiffness = 80.0, time = 0.3 }
[integration]
step = 0.002
duration = 1.0
)";

std::vector<Complex> roots_of(const MatrixXd& A) {
  const Eigen::VectorXcd values = Eigen::EigenSolver<MatrixXd>(A, false).eigenvalues();
  return {values.begin(), values.end()};
}

/// Returns how far the nearest of some roots is from `root`.
double distance(const std::vector<Complex>& roots, Complex root) {
  double least = 1e300;
  for (const Complex& other : roots) least = std::min(least, std::abs(other - root));
  return least;
}

/// A load of the tip of an arm, and sensors.
std::string load_and_sensors(const std::string& arm) {
  const auto sensor = [&arm](const std::string& name, const std::string& quantity,
                             const std::string& position) {
    return "[[sensor]]\nname = \"" + name + "\"\nquantity = \"" + quantity + "\"\nsubsystem = \"" +
           arm + "\"\nbody = \"bar\"\nposition = " + position + "\n";
  };
  return "[[load]]\nname = \"pull\"\nsubsystem = \"" + arm +
         "\"\nbody = \"bar\"\nposition = 1.2\nframe = \"section\"\nforce = [0.0, 1.0, 0.5]\n" +
         sensor("inner", "section_force", "0.0") + sensor("shake", "acceleration", "1.2");
}

/// Arms on hinges across their axes whose springs relax, or as two hinges with next to no inertia
/// between, of which one has the spring and one the damper. The drive turns the hub, on a mast that
/// leans on a spring of the same kind if it is supported.
std::string rotor(bool is_chain, bool is_supported, int count = 3) {
  const auto hinge = [is_chain](const std::string& of, const std::string& name,
                                const std::string& parent, const std::string& child,
                                const std::string& axis, const std::string& at, double k,
                                double time) {
    const auto joint = [&](const std::string& own, const std::string& from, const std::string& to,
                           const std::string& place, const std::string& keys) {
      return "[[" + of + ".joint]]\nname = \"" + own + "\"\nparent = \"" + from + "\"\nchild = \"" +
             to + "\"\nkind = \"revolute\"\naxis = " + axis + "\n" + place + keys + "\n";
    };
    const std::string spring = std::to_string(k), T = std::to_string(time);
    if (!is_chain)
      return joint(name, parent, child, at,
                   "relaxation = { stiffness = " + spring + ", time = " + T + " }");
    return joint(name + "_spring", parent, "link_" + name, at, "stiffness = " + spring) +
           joint(name, "link_" + name, child, "", "damping = " + std::to_string(k * time));
  };
  const auto link = [is_chain](const std::string& of, const std::string& name) {
    return is_chain ? "[[" + of + ".body]]\nname = \"link_" + name +
                          "\"\nkind = \"rigid\"\nmass = 1e-7\ninertia = 1e-7\n"
                    : std::string();
  };
  std::string text = R"(
world = "space"
[hub]
mass = 3.0
inertia = [0.2, 0.2, 0.3]
[hub.drive]
kind = "constant"
speed = 12.0
)";
  if (is_supported)
    text += R"([support]
from = "ground"
[[support.body]]
name = "mast"
kind = "rigid"
mass = 6.0
center = [0.0, 0.0, 1.0]
inertia = [2.0, 2.0, 0.1]
[[support.body]]
name = "head"
kind = "rigid"
mass = 2.0
inertia = 0.3
[[support.joint]]
name = "foot"
parent = "ground"
child = "mast"
kind = "revolute"
axis = [1.0, 0.0, 0.0]
stiffness = 4000.0
damping = 2.0
)" + link("support", "lean") +
            hinge("support", "lean", "mast", "head", "[0.0, 1.0, 0.0]",
                  "offset = [0.0, 0.0, 1.5]\n", 900.0, 0.4) +
            R"([support.axle]
body = "head"
offset = [0.0, 0.0, 0.5]
)";
  text += "[[subsystem]]\nname = \"arm\"\ncount = " + std::to_string(count) +
          "\nazimuth = 0.2\n[[subsystem.body]]\nname = \"grip\"\nkind = \"rigid\"\nmass = 0.4\n"
          "center = [0.1, 0.0, 0.0]\ninertia = 0.01\n" +
          link("subsystem", "lag") + R"([[subsystem.body]]
name = "bar"
kind = "beam"
length = 1.2
bodies = 1
elements = 2
[subsystem.body.sections]
mass_per_length = 1.5
axial_stiffness = 1e5
flap_stiffness = 60.0
lag_stiffness = 160.0
torsion_stiffness = 30.0
flap_inertia = 1e-3
lag_inertia = 2e-3
[[subsystem.joint]]
name = "flap"
parent = "hub"
child = "grip"
kind = "revolute"
axis = [0.0, -1.0, 0.0]
offset = [0.2, 0.0, 0.0]
stiffness = 30.0
)" +
          hinge("subsystem", "lag", "grip", "bar", "[0.0, 0.0, 1.0]", "offset = [0.3, 0.0, 0.0]\n",
                90.0, 0.15) +
          R"([damping]
stiffness_factor = 1e-3
)";
  for (int k = 1; k <= count; ++k) text += load_and_sensors("arm" + std::to_string(k));
  return text + R"([integration]
step = 0.001
duration = 1.0
)";
}

Scenario read(const std::string& text) { return parse_scenario(text, "relaxing.toml"); }

/// Returns C (s - A)^-1 B + D.
MatrixXcd transfer(const LinearSystem& of, Complex s) {
  const MatrixXcd A = MatrixXd(of.A).cast<Complex>();
  const MatrixXcd resolvent = s * MatrixXcd::Identity(A.rows(), A.cols()) - A;
  return MatrixXd(of.C).cast<Complex>() *
             resolvent.partialPivLu().solve(MatrixXd(of.B).cast<Complex>()) +
         MatrixXd(of.D).cast<Complex>();
}

/// Compares two systems by the inputs and outputs of equal names; returns how many pairs there are.
int compare(const LinearSystem& a, const LinearSystem& b, Complex s, double tolerance) {
  const MatrixXcd of_a = transfer(a, s), of_b = transfer(b, s);
  int pairs = 0;
  for (std::size_t j = 0; j < a.inputs.size(); ++j)
    for (std::size_t k = 0; k < b.inputs.size(); ++k) {
      // The motor of a hinge acts on one of the chain's two.
      const std::string& input = a.inputs[j].name;
      if (input != b.inputs[k].name || contains(input, "lag") || contains(input, "lean")) continue;
      const auto at = static_cast<Index>(j), bt = static_cast<Index>(k);
      for (std::size_t m = 0; m < a.outputs.size(); ++m)
        for (std::size_t n = 0; n < b.outputs.size(); ++n) {
          // The hinge is the sum of the chain's two.
          const std::string& name = a.outputs[m].name;
          if (name != b.outputs[n].name || contains(name, "lag") || contains(name, "lean"))
            continue;
          const Complex x = of_a(static_cast<Index>(m), at), y = of_b(static_cast<Index>(n), bt);
          CAPTURE(name);
          CAPTURE(input);
          CAPTURE(x.real() + x.imag());
          CAPTURE(y.real() + y.imag());
          CHECK(std::abs(x - y) <= tolerance * std::abs(x) + 5e-6 * of_a.col(at).norm() + 1e-12);
          ++pairs;
        }
    }
  return pairs;
}

}  // namespace

TEST_CASE("a mass on a spring that relaxes has the roots of its cubic equation") {
  const Scenario scenario = read(kMassOnRubber);
  // m x'' = -c x - k x + z, z' = (k x - z)/T
  MatrixXd exact(3, 3);
  exact << 0.0, 1.0, 0.0, -(50.0 + 80.0) / 2.0, 0.0, 0.5, 80.0 / 0.3, 0.0, -1.0 / 0.3;
  const std::vector<Complex> expected = roots_of(exact);
  const LinearSystem system = solve_linear_system(scenario);
  REQUIRE(system.states.size() == 3);
  CHECK(system.states[1].name == "mount / rubber relaxation");
  CHECK(system.states[1].unit == "N");
  for (const Complex& root : roots_of(MatrixXd(system.A)))
    CHECK(distance(expected, root) < 1e-8 * std::abs(root));
  const ModesResult modes = solve_modes(scenario);
  REQUIRE(modes.modes.size() == 2);
  for (const Mode& mode : modes.modes)
    CHECK(distance(expected, mode.eigenvalue) < 1e-8 * std::abs(mode.eigenvalue));
  const EquilibriumResult rest = solve_equilibrium(scenario);
  REQUIRE(rest.stability);
  CHECK(rest.stability->motions == SmallMotions::decay);
}

TEST_CASE("hinges that relax move as a spring and a damper with next to no mass between") {
  const LinearSystem relaxing = solve_linear_system(read(rotor(false, false)));
  const LinearSystem chain = solve_linear_system(read(rotor(true, false)));
  // By each: flap, two elements of six motions, the hinge, its force.
  CHECK(relaxing.states.size() == 3 * (2 * 14 + 1));
  for (const Complex s : {Complex(0.0, 3.0), Complex(0.4, 11.0), Complex(-0.1, 40.0)})
    CHECK(compare(relaxing, chain, s, 1e-4) > 20);
}

TEST_CASE("from outside hinges and a foot that relax move as on a chain") {
  const LinearSystem relaxing = solve_linear_system(read(rotor(false, true)), {}, ModeFrame::fixed);
  const LinearSystem chain = solve_linear_system(read(rotor(true, true)), {}, ModeFrame::fixed);
  for (const Complex s : {Complex(0.0, 3.0), Complex(0.4, 11.0), Complex(-0.1, 40.0)})
    CHECK(compare(relaxing, chain, s, 1e-4) > 20);
  // modes() by another way than linearize()
  std::vector<Complex> roots = roots_of(MatrixXd(relaxing.A));
  for (const Mode& mode : solve_modes(read(rotor(false, true))).modes)
    CHECK(distance(roots, mode.eigenvalue) < 1e-6 * std::max(1.0, std::abs(mode.eigenvalue)));
}

TEST_CASE("from outside roots of hinges that relax are those of the turning frame, shifted") {
  const std::vector<Complex> turning =
      roots_of(MatrixXd(solve_linear_system(read(rotor(false, false, 4))).A));
  const std::vector<Complex> fixed =
      roots_of(MatrixXd(solve_linear_system(read(rotor(false, false, 4)), {}, ModeFrame::fixed).A));
  REQUIRE(fixed.size() == turning.size());
  for (const Complex& root : fixed) {
    if (std::abs(root) > 1e3) continue;  // stiff ones have fewer digits
    double least = 1e300;
    for (const double shift : {-12.0, 0.0, 12.0})
      least = std::min(least, distance(turning, root + Complex(0.0, shift)));
    CHECK(least < 1e-6 * std::max(1.0, std::abs(root)));
  }
}

TEST_CASE("a column buckles as if springs that relax were not there") {
  // A bar of 2 kg stands on a hinge, its centre 0.5 m above.
  const Scenario scenario = read(R"(
world = "space"
[hub.drive]
kind = "fixed"
[gravity]
acceleration = [-1.0, 0.0, 0.0]
[[subsystem]]
name = "column"
body = [{ name = "bar", kind = "rigid", mass = 2.0, center = [0.5, 0.0, 0.0], inertia = 0.2 }]
[[subsystem.joint]]
name = "foot"
parent = "hub"
child = "bar"
kind = "revolute"
axis = [0.0, 1.0, 0.0]
stiffness = 7.0
relaxation = { stiffness = 30.0, time = 0.5 }
[integration]
step = 0.002
duration = 1.0
)");
  CriticalOptions options;
  options.of = "load=gravity";
  options.from = 1.0;
  options.to = 20.0;
  const CriticalResult found = solve_critical(scenario, options);
  REQUIRE(found.critical);
  CHECK(std::abs(found.critical->value - 7.0) < 1e-6);
}

TEST_CASE("hinges that relax have the periodic modes of a chain, and those of other frames") {
  const ModeOptions floquet{.count = 8, .frame = ModeFrame::floquet};
  const ModesResult relaxing = solve_modes(read(rotor(false, true, 2)), floquet);
  std::vector<Complex> chain;
  for (const Mode& mode : solve_modes(read(rotor(true, true, 2)), floquet).modes)
    chain.push_back(mode.eigenvalue);
  REQUIRE(relaxing.modes.size() == 8);
  for (const Mode& mode : relaxing.modes) {
    CAPTURE(mode.name);
    CHECK(distance(chain, mode.eigenvalue) < 1e-4 * std::max(1.0, std::abs(mode.eigenvalue)));
  }
}

TEST_CASE("a note says where gravity across the axis counts in the mean alone") {
  const ModeOptions floquet{.count = 4, .frame = ModeFrame::floquet};
  const auto notes = [&](const std::string& text) {
    std::string all;
    for (const std::string& note : solve_modes(read(text), floquet).notes) all += note;
    return all;
  };
  const std::string words = "count by their part along it alone", text = rotor(false, false, 2);
  CHECK_FALSE(contains(notes(text), words));
  CHECK(contains(notes(text + "[gravity]\nacceleration = [0.0, -9.81, 0.0]\n"), words));
}

}  // namespace spoke
