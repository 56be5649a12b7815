#include "tests/engine/bodies/space/rigid_tree_steps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spoke::space::testing {
namespace {

void advance_all(const Rk4& method, int stage, RigidTree& tree) {
  tree.for_coordinates([&](Coordinates& coordinates) {
    CoordinateBlock block = coordinates.block();
    if (coordinates.has_rotation())
      advance(method, stage, coordinates.rotation(block));
    else
      spoke::advance(method, stage, block);
  });
}

void predict_all(const GeneralizedAlpha& method, RigidTree& tree) {
  tree.for_coordinates([&](Coordinates& coordinates) {
    CoordinateBlock block = coordinates.block();
    if (coordinates.has_rotation())
      predict(method, 2, coordinates.rotation(block));
    else
      spoke::predict(method, 2, block);
  });
}

/// Evaluates, and takes the results as the accelerations of the coordinates.
void take_accelerations(RigidTree& tree) {
  tree.hand_out(tree.eliminate(), [](Coordinates& coordinates, const double* a) {
    std::copy_n(a, coordinates.a.size(), coordinates.a.begin());
  });
}

}  // namespace

void start(RigidTree& tree) {
  tree.update(0.0);
  take_accelerations(tree);
}

void start(const GeneralizedAlpha& method, RigidTree& tree) {
  tree.for_coordinates([](Coordinates& coordinates) {
    CoordinateBlock block = coordinates.block();
    clear_accelerations(block);
  });
  tree.update(0.0);
  tree.hand_out(tree.eliminate(), [&](Coordinates& coordinates, const double* a) {
    CoordinateBlock block = coordinates.block();
    complete_restart(method, a, block);
  });
}

void step(const Rk4& method, int n, RigidTree& tree) {
  for (const int stage : {1, 2, 3, 0}) {
    advance_all(method, stage, tree);
    const double done = stage == 0 ? 1.0 : Rk4::nodes[static_cast<std::size_t>(stage)];
    tree.update((n - 1 + done) * method.step);
    take_accelerations(tree);
  }
}

int step(const GeneralizedAlpha& method, int n, RigidTree& tree, double tolerance) {
  predict_all(method, tree);
  for (int pass = 1; pass <= 50; ++pass) {
    tree.update(n * method.step, {method.position_gain, method.velocity_gain});
    double change = 0.0;
    tree.hand_out(tree.eliminate(), [&](Coordinates& coordinates, const double* a) {
      CoordinateBlock block = coordinates.block();
      change = std::max(change, correct(method, a, block).change);
    });
    if (change <= tolerance) return pass;
  }
  throw std::runtime_error("a step of a tree did not converge");
}

void run_rk4(double t, double h, RigidTree& tree) {
  start(tree);
  const int steps = static_cast<int>(std::lround(t / h));
  for (int n = 1; n <= steps; ++n) step(Rk4{t / steps}, n, tree);
}

void run_generalized_alpha(double t, double h, double radius, RigidTree& tree) {
  const int steps = static_cast<int>(std::lround(t / h));
  const GeneralizedAlpha method = make_generalized_alpha(radius, t / steps);
  start(method, tree);
  for (int n = 1; n <= steps; ++n) step(method, n, tree);
  tree.update(t);
}

}  // namespace spoke::space::testing
