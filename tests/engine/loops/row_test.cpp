// Many loops in one subsystem, each of which meets few others: a row of four-bar linkages.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

constexpr int kCount = 6;

spatial::Subsystem& row_of(spatial::Model& model) { return model.subsystems[0]; }

/// A row on a hub that turns freely, of which every third closure gives.
spatial::Model make_row() {
  spatial::Model model = make_four_bars(kCount, LoopKind::spherical);
  model.hub.inertia = Vector(0.4, 0.5, 6.0).asDiagonal();
  model.hub.drive = FreeDrive{0.3};
  for (int k = 1; k < kCount; k += 3) {
    Loop& loop = row_of(model).loops[static_cast<std::size_t>(k)];
    loop.stiffness = {4000.0, 4000.0, 4000.0};
    loop.damping = {3.0, 3.0, 3.0};
  }
  return model;
}

spatial::Model shuffled(spatial::Model model) {
  std::mt19937 random(7);
  std::shuffle(row_of(model).loops.begin(), row_of(model).loops.end(), random);
  return model;
}

/// Four-bars that share nothing, in one subsystem or in one each.
spatial::Model make_singles(bool in_one) {
  spatial::Model model;
  for (int k = 0; k < 3; ++k) {
    spatial::Model one = make_four_bars(1, LoopKind::spherical);
    spatial::Subsystem& own = row_of(one);
    const std::string prefix(1, static_cast<char>('a' + k));
    own.name += prefix;
    for (spatial::Body& body : own.bodies) body.name += prefix;
    for (spatial::SubsystemJoint& joint : own.joints) {
      joint.child += prefix;
      if (joint.parent != "hub") joint.parent += prefix;
      joint.joint.coordinates[0].initial_speed *= 1.0 + k;
    }
    for (Loop& loop : own.loops) {
      loop.name += prefix;
      loop.from.name += prefix;
      loop.to.name += prefix;
    }
    if (k == 0) {
      model = one;
      continue;
    }
    if (!in_one) {
      model.subsystems.push_back(own);
      continue;
    }
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(row_of(model).bodies, own.bodies);
    append(row_of(model).joints, own.joints);
    append(row_of(model).loops, own.loops);
  }
  return model;
}

/// Coordinates of all joints, sorted.
std::vector<double> angles_of(const Run<Space>& run) {
  std::vector<double> values;
  for (const SubsystemData<Space>& subsystem : run.context.data.subsystems)
    for (const BodyData<Space>& body : subsystem.bodies)
      values.push_back(body.joint.coordinates.q[0]);
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<Method> methods() { return {make_generalized_alpha(0.8, 1e-3), Rk4{1e-3}}; }

}  // namespace

TEST_CASE("three formulations move a row of linkages alike, in any order of its loops") {
  for (const Method& method : methods()) {
    const auto run = [&](const spatial::Model& model, Formulation formulation) {
      auto made = std::make_unique<Run<Space>>(
          make_system(model), RunSetup{.method = method, .formulation = formulation});
      made->advance(100);
      return made;
    };
    const auto structured = run(make_row(), Formulation::structured);
    for (const Formulation formulation :
         {Formulation::structured, Formulation::subsystem, Formulation::augmented})
      CHECK(largest_difference(*structured, *run(shuffled(make_row()), formulation)) < 1e-10);
    const LoopReport& report = structured->context.data.subsystems[0].loops.report;
    CHECK(report.opening < 1e-12);
    CHECK(report.least_pivot > 0.5);
  }
}

TEST_CASE("the matrix of a row of linkages is a narrow band, in any order of its loops") {
  for (const bool is_shuffled : {false, true}) {
    const spatial::Model model = make_four_bars(20, LoopKind::spherical);
    const Run<Space> run(make_system(is_shuffled ? shuffled(model) : model),
                         {make_generalized_alpha(0.8, 1e-3)});
    const LoopData<Space>& loops = run.context.data.subsystems[0].loops;
    REQUIRE(loops.rows == 60);
    for (int r = 0; r < loops.rows; ++r) CHECK(r - loops.matrix.first(r) < 6);
  }
}

TEST_CASE("a row of linkages has equal bits on executors, threads and windows") {
  spatial::Model model = shuffled(make_row());
  model.hub.drive = ConstantSpeed{0.3};
  for (const Method& method : methods()) check_equal_bits(make_system(model), method, 60);
}

TEST_CASE("linkages that share nothing move as each does alone") {
  for (const Method& method : methods()) {
    const auto run = [&](bool in_one) {
      Run<Space> made(make_system(make_singles(in_one)), {method});
      made.advance(200);
      return angles_of(made);
    };
    const std::vector<double> together = run(true), apart = run(false);
    REQUIRE(together.size() == 9);
    REQUIRE(apart.size() == 9);
    for (std::size_t k = 0; k < 9; ++k) CHECK(std::abs(together[k] - apart[k]) < 1e-12);
  }
}

TEST_CASE("each closure of a row has one redundant row, that across the plane") {
  constexpr int kMany = 12;
  const Run<Space> run(make_system(make_four_bars(kMany, LoopKind::spherical)),
                       {make_generalized_alpha(0.8, 1e-3)});
  const std::vector<LoopRowPlace>& dropped = run.context.loop_start.dropped;
  REQUIRE(dropped.size() == kMany);
  for (int k = 0; k < kMany; ++k) {
    CHECK(dropped[static_cast<std::size_t>(k)].loop == k);
    CHECK(dropped[static_cast<std::size_t>(k)].row == 2);
  }
}
