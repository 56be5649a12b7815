// The start of closed loops: what is moved, what is redundant, what is refused.

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "engine/bodies/kernels/samples.h"
#include "engine/simulation.h"
#include "engine/step/loops/loop_rank.h"
#include "models/error.h"
#include "tests/contains.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"
#include "tests/message_of.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

spatial::SubsystemJoint& joint_of(spatial::Model& model, std::size_t index) {
  return model.subsystems[0].joints[index];
}

/// Moves a joint from 0 by a table.
void drive(spatial::SubsystemJoint& joint, double by) {
  joint.joint.coordinates[0].initial = joint.joint.coordinates[0].initial_speed = 0.0;
  joint.joint.orientation = Vector(0.0, 0.0, 0.5 * std::numbers::pi);
  joint.joint.coordinates[0].motion =
      spatial::MotionTable{Curve({0.0, 0.5, 1.0}, {0.0, 0.5 * by, by})};
}

void allocate_with(const spatial::Model& model, double duration, SystemContext<Space>& context) {
  context.system = make_system(model);
  context.integrator = {make_generalized_alpha(0.8, 1e-3), {1e-10, 0, 50}};
  context.loop_limits.duration = duration;
  allocate(context);
}

constexpr const char* kNone = "no error";

std::string refusal_of(const spatial::Model& model) {
  return message_of<InputError>([&] {
    SystemContext<Space> context;
    allocate_with(model, 1.0, context);
  });
}

/// A slider-crank, 0.15 m and 0.3 m, whose slider goes along x. Speeds are asked of the crank
/// alone.
std::string make_slider_crank(const std::string& crank, const std::string& rod = "") {
  return "world='space'\n[hub.drive]\nkind='fixed'\n[[subsystem]]\nname='sc'\nbody=["
         "{ name='crank', kind='rigid', mass=0.3, center=[0.075,0,0], inertia=6e-4 },"
         "{ name='rod', kind='rigid', mass=0.066, center=[0.15,0,0], "
         "inertia=[1e-6,4.95e-4,4.95e-4] },"
         "{ name='slider', kind='rigid', mass=0.25, inertia=1e-4 } ]\njoint=["
         "{ name='A', parent='hub', child='crank', kind='revolute', axis=[0,0,1], " +
         crank +
         " }, { name='B', parent='crank', child='rod', kind='revolute', axis=[0,0,1],"
         " offset=[0.15,0,0]" +
         rod +
         " }, { name='C', parent='rod', child='slider', kind='revolute', axis=[0,0,1],"
         " offset=[0.3,0,0] } ]\n"
         "loop=[ { name='guide', kind='prismatic', axis=[1,0,0], from={ body='slider' },"
         " to={ body='hub' } } ]\n[integration]\nstep=1e-3\nduration=1\n";
}

}  // namespace

TEST_CASE("the speed of a joint that is held stays, and the others follow") {
  SystemContext<Space> context;
  allocate_with(parse_model(make_slider_crank("initial=0.5, initial_speed=20, hold=true")), 1.0,
                context);
  SubsystemData<Space>& data = context.data.subsystems[0];
  const auto angle = [&](std::size_t j) { return data.bodies[j].joint.coordinates.q[0]; };
  const auto speed = [&](std::size_t j) { return data.bodies[j].joint.coordinates.v[0]; };
  CHECK(angle(0) == 0.5);
  CHECK(speed(0) == 20.0);
  // The rod's angle in space: sin phi = -r/l sin theta.
  const double phi = std::asin(-0.5 * std::sin(0.5));
  const double phi_rate = -0.5 * 20.0 * std::cos(0.5) / std::cos(phi);
  CHECK(angle(1) == doctest::Approx(phi - 0.5).epsilon(1e-12));
  // The guide keeps the slider in the direction that the given coordinates make, 0.5.
  CHECK(angle(2) == doctest::Approx(0.5 - phi).epsilon(1e-12));
  CHECK(speed(1) == doctest::Approx(phi_rate - 20.0).epsilon(1e-12));
  CHECK(speed(2) == doctest::Approx(-phi_rate).epsilon(1e-12));
  update_kinematics(context.system.subsystems[0], data);
  const double slide = -0.15 * 20.0 * std::sin(0.5) - 0.3 * phi_rate * std::sin(phi);
  CHECK(data.twists[2][0] == doctest::Approx(slide * std::cos(0.5)).epsilon(1e-12));
  CHECK(context.loop_start.speeds.empty());
  CHECK(context.loop_start.moves.size() == 2);
}

TEST_CASE("a speed that is given and not held is shared out, which is told") {
  SystemContext<Space> context;
  allocate_with(parse_model(make_slider_crank("initial_speed=20")), 1.0, context);
  REQUIRE(context.loop_start.speeds.size() == 1);
  const LoopSpeed& told = context.loop_start.speeds[0];
  CHECK(told.body == 0);
  CHECK(told.is_angle);
  CHECK(told.from == 20.0);
  // The nearest speeds to (20, 0, 0) along (1, -3/2, 1/2), the way that the mechanism can go.
  CHECK(told.to == doctest::Approx(20.0 / 3.5).epsilon(1e-12));
}

TEST_CASE("joints that cannot all be held are named") {
  const auto refusal = [](const std::string& crank, const std::string& rod) {
    return refusal_of(parse_model(make_slider_crank(crank, rod)));
  };
  const std::string open = refusal("initial=0.5, hold=true", ", hold=true");
  CHECK(contains(open, "loop \"guide\" of sc: cannot be closed while joints are held (A, B)"));
  const std::string fast = refusal("initial_speed=20, hold=true", ", hold=true");
  CHECK(contains(fast, "initial_speed of the joints that are held (A, B)"));
  CHECK(refusal("hold=true, initial_speed=20", ", initial_speed=-30, hold=true") == kNone);
}

TEST_CASE("rows that others make up are redundant, the later of equal ones") {
  Eigen::MatrixXd rows(4, 3);
  rows << 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 1, 1e-12;
  const Eigen::MatrixXd given = Eigen::MatrixXd::Zero(4, 0);
  const RowRank rank = find_redundant_rows(rows, given, 1e-9);
  int redundant = 0;
  for (const bool is : rank.is_redundant) redundant += is;
  CHECK(redundant == 2);
  CHECK(find_redundant_rows(rows.topRows(2), given.topRows(2), 1e-9).is_redundant ==
        std::vector<bool>{false, false});
  Eigen::MatrixXd equal(2, 3);
  equal << 1, 2, 3, 1, 2, 3;
  CHECK(find_redundant_rows(equal, given.topRows(2), 1e-9).is_redundant ==
        std::vector<bool>{false, true});
}

TEST_CASE("as many rows are redundant as the rank says, and others make them up") {
  std::srand(11);
  for (const auto& [count, rank] : {std::pair(8, 5), std::pair(30, 21)}) {
    const Eigen::MatrixXd rows =
        Eigen::MatrixXd::Random(count, rank) * Eigen::MatrixXd::Random(rank, 40);
    const Eigen::MatrixXd given = rows * Eigen::MatrixXd::Random(40, 2);
    const RowRank found = find_redundant_rows(rows, given, 1e-9);
    CHECK(std::count(found.is_redundant.begin(), found.is_redundant.end(), false) == rank);
    Eigen::MatrixXd independent(0, 40);
    for (Eigen::Index r = 0; r < count; ++r) {
      if (found.is_redundant[static_cast<std::size_t>(r)]) {
        CHECK(found.left.row(r).norm() < 1e-12);
        continue;
      }
      independent.conservativeResize(independent.rows() + 1, 40);
      independent.bottomRows(1) = rows.row(r);
    }
    CHECK(independent.fullPivLu().rank() == rank);
  }
}

TEST_CASE("what is prescribed shows where the rows that a redundant one is made of do not") {
  Eigen::MatrixXd rows(3, 2), given(3, 1);
  rows << 1, 0, 0, 2, 1, 2;
  given << 1, 3, 4;  // as the rows add up
  RowRank rank = find_redundant_rows(rows, given, 1e-9);
  double left = 0.0;
  for (Eigen::Index r = 0; r < 3; ++r)
    if (rank.is_redundant[static_cast<std::size_t>(r)])
      left = std::max(left, std::abs(rank.left(r, 0)));
  CHECK(left < 1e-14);
  given << 1, 3, 5;
  rank = find_redundant_rows(rows, given, 1e-9);
  for (Eigen::Index r = 0; r < 3; ++r)
    if (rank.is_redundant[static_cast<std::size_t>(r)])
      left = std::max(left, std::abs(rank.left(r, 0)));
  CHECK(left > 0.1);
}

TEST_CASE("loops are closed by moving joints, and their speeds follow") {
  spatial::Model model = make_four_bars(1);
  joint_of(model, 1).joint.coordinates[0].initial = 1.2;  // the second bar, upright at pi/2
  joint_of(model, 1).joint.coordinates[0].initial_speed = 0.0;
  SystemContext<Space> context;
  allocate_with(model, 1.0, context);
  const SubsystemData<Space>& data = context.data.subsystems[0];
  CHECK(context.loop_start.moves.size() == 3);
  // A parallelogram: both bars have one angle and one speed.
  const auto angle = [&](std::size_t j) { return data.bodies[j].joint.coordinates.q[0]; };
  const auto speed = [&](std::size_t j) { return data.bodies[j].joint.coordinates.v[0]; };
  const std::size_t second = context.system.subsystems[0].bodies[1].parent < 0 ? 1 : 2;
  CHECK(angle(0) == doctest::Approx(angle(second)).epsilon(1e-13));
  CHECK(speed(0) == doctest::Approx(speed(second)).epsilon(1e-13));
  CHECK(std::abs(speed(0)) > 0.1);
}

TEST_CASE("a length that is not given is that at the start") {
  spatial::Model model = make_four_bars(1, LoopKind::distance);
  model.subsystems[0].loops[0].to.point = Vector(0.5, 0.0, 0.0);
  SystemContext<Space> context;
  allocate_with(model, 1.0, context);
  CHECK(context.system.subsystems[0].loops[0].rows[0].rest == doctest::Approx(0.5));
  CHECK(context.loop_start.moves.empty());
}

TEST_CASE("loops that cannot be closed, or fight what is prescribed, are refused by their names") {
  SUBCASE("too far apart") {
    spatial::Model model = make_four_bars(1);
    model.subsystems[0].loops[0].to.point = Vector(9.0, 0.0, 0.0);
    const std::string message = refusal_of(model);
    CHECK(contains(message, "subsystem.1.loop.1: loop \"loop0\" of bars: cannot be closed"));
    CHECK(contains(message, " m at best"));
    CHECK(contains(message, "comes to 6"));
  }
  SUBCASE("no freedom") {
    spatial::Model model = make_four_bars(1);
    Loop brace;
    brace.name = "brace";
    brace.kind = LoopKind::distance;
    brace.from = on_body("coupler0", Vector::UnitX());
    brace.to.carrier = LoopPlace::Carrier::hub;
    model.subsystems[0].loops.push_back(brace);
    CHECK(contains(refusal_of(model), "loop \"brace\" of bars: the mechanism has no freedom"));
    model.hub.drive = ConstantSpeed{1.0};  // it is a truss that turns
    CHECK(refusal_of(model) == kNone);
  }
  SUBCASE("two driven joints in a loop of one freedom") {
    spatial::Model model = make_four_bars(1);
    drive(joint_of(model, 0), 0.3);
    CHECK(refusal_of(model) == kNone);
    drive(joint_of(model, 1), 0.3);
    CHECK(contains(refusal_of(model), "fights it"));
  }
  SUBCASE("places that coincide have no direction") {
    spatial::Model model = make_four_bars(1, LoopKind::distance);
    CHECK(contains(refusal_of(model), "its places coincide at the start"));
  }
  SUBCASE("an anchor that moves where the mechanism cannot follow") {
    spatial::Model model = make_four_bars(1);
    Anchor anchor;
    anchor.name = "plate";
    anchor.frame = Anchor::Frame::hub;
    spatial::MountMotion motion;
    motion.translation =
        spatial::VectorHarmonic{Vector::Zero(), Vector::Zero(), Vector(0.0, 0.0, 0.1), 3.0, 0.0};
    motion.rotation = spatial::VectorHarmonic{};
    anchor.motion = motion;
    model.anchors.push_back(anchor);
    Loop& loop = model.subsystems[0].loops[0];
    loop.to = {};
    loop.to.carrier = LoopPlace::Carrier::anchor;
    loop.to.name = "plate";
    loop.to.point = Vector(1.0, 1.0, 0.0);
    CHECK(contains(refusal_of(model), "fights it"));
  }
}

TEST_CASE("rows of a mechanism in a plane that lie across it are redundant") {
  SystemContext<Space> context;
  allocate_with(make_four_bars(1), 1.0, context);
  CHECK(context.loop_start.dropped.size() == 3);
  CHECK(context.loop_start.freedoms[0].mobility() == 1);
}

TEST_CASE("a redundant row that opens in a run ends it, with the loop's name") {
  // The program lifts an anchor out of the plane of a linkage, which cannot follow.
  spatial::Model model = make_four_bars(1);
  Anchor anchor;
  anchor.name = "plate";
  anchor.frame = Anchor::Frame::hub;
  anchor.motion = ProgramAnchorMotion{};
  model.anchors.push_back(anchor);
  Loop& loop = model.subsystems[0].loops[0];
  loop.to = {};
  loop.to.carrier = LoopPlace::Carrier::anchor;
  loop.to.name = "plate";
  loop.to.point = Vector(1.0, 1.0, 0.0);
  Scenario scenario;
  scenario.space = model;
  scenario.integration.step = 1e-3;
  scenario.integration.duration = 1.0;
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  AnchorMotion up = simulation.anchor_motion("plate");
  up.acceleration.z() = 1.0;
  simulation.set_anchor_motion("plate", up);
  const std::string message = message_of<DivergenceError>([&] { simulation.run_until(1.0); });
  CHECK(contains(message, "closure of loop \"loop0\""));
  CHECK(contains(message, "loop factor"));
  CHECK(simulation.time() < 0.1);
}
