// From a scenario to its linear model at rest, and its ends.

#include "engine/vibration/rest_frequencies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "engine/kernels/natural_frequencies.h"
#include "engine/steady/alike_trees.h"
#include "engine/steady/linear_model.h"
#include "engine/vibration/coupled_roots.h"
#include "engine/vibration/largest_root.h"

namespace spoke::vibration {
namespace {

using steady::HubCoupling;
using steady::LinearModel;
using steady::LinearTree;
using steady::SteadyModel;

/// Undeformed, joints where they start.
steady::Equilibrium make_rest(SteadyModel& model) {
  steady::Equilibrium rest;
  rest.alike = find_alike(model);
  for (std::size_t i = 0; i < model.trees(); ++i) {
    rest.q.push_back(model.initial(i));
    model.settle(i, rest.q.back());
  }
  return rest;
}

/// Leaves of the damping that of joints, without what flexible bodies have.
void keep_joint_damping(const steady::Equilibrium& rest, SteadyModel& model, LinearModel& linear) {
  for (std::size_t i = 0; i < model.trees(); ++i) {
    if (linear.alike[i] != i) continue;
    steady::TreeResponse response;
    model.evaluate(i, steady::make_state(rest.q[i]), model.no_offset(), response);
    linear.trees[i].C -= model.matrices(i).damping;
  }
}

void remove_damping(LinearModel& linear) {
  linear.C.setZero();
  for (LinearTree& tree : linear.trees) tree.C.setZero();
  for (HubCoupling& coupling : linear.couplings) {
    coupling.C_bh.setZero();
    coupling.C_hb.setZero();
  }
}

/// The least root that is not zero, of those that `find` has so many of; 0 if there is none.
template <class Find>
double find_least(const Find& find) {
  for (Eigen::Index count = 8;; count *= 2) {
    const std::vector<Root> roots = find(count);
    for (const Root& root : roots)
      if (root.s != 0.0) return std::abs(root.s);
    if (std::ssize(roots) < count) return 0.0;
  }
}

double find_lowest(const LinearModel& linear, const SteadyModel& model) {
  if (linear.is_coupled()) {
    std::vector<double> azimuths;
    for (std::size_t i = 0; i < model.trees(); ++i) azimuths.push_back(model.azimuth(i));
    return find_least(
        [&](Eigen::Index count) { return find_coupled_roots(linear, azimuths, count); });
  }
  double lowest = 0.0;
  for (std::size_t i = 0; i < model.trees(); ++i) {
    if (linear.alike[i] != i) continue;
    const Pencil pencil(linear, {i});
    const double least = find_least([&](Eigen::Index count) { return find_roots(pencil, count); });
    if (lowest == 0.0 || (least > 0.0 && least < lowest)) lowest = least;
  }
  return lowest;
}

/// The least of the steps for shares, in eighths, of what dampers of joints add at most.
double find_rk4_step(const FrequencyRange& range, const Damping& damping, double joints) {
  constexpr int kShares = 8;
  if (range.highest == 0.0) return std::numeric_limits<double>::infinity();
  double step = calc_rk4_largest_step(range, damping);
  for (int k = 1; joints > 0.0 && k <= kShares; ++k) {
    const double factor = damping.mass_factor + joints * k / kShares;
    step = std::min(step, calc_rk4_largest_step(range, {factor, damping.stiffness_factor}));
  }
  return step;
}

}  // namespace

RestFrequencies find_rest_frequencies(const Scenario& scenario) {
  const std::unique_ptr<SteadyModel> model =
      steady::make_steady_model(scenario, {.instant = steady::Instant::start});
  model->set_share(0.0);
  const steady::Equilibrium rest = make_rest(*model);
  LinearModel linear = linearize(rest, *model);
  const double square =
      find_largest_root({linear, &LinearModel::K, &LinearTree::K, &HubCoupling::K_bh});
  keep_joint_damping(rest, *model, linear);
  const double joints =
      find_largest_root({linear, &LinearModel::C, &LinearTree::C, &HubCoupling::C_bh});
  remove_damping(linear);
  RestFrequencies found;
  found.lowest = find_lowest(linear, *model);
  if (found.lowest > 0.0) found.highest = std::sqrt(std::max(0.0, square));
  const Damping& damping = scenario.space ? scenario.space->damping : scenario.rotor.damping;
  found.rk4_step = find_rk4_step({found.lowest, found.highest}, damping, joints);
  return found;
}

}  // namespace spoke::vibration
