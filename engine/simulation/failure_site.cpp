// Searches the bodies whose step has failed.

#include "engine/simulation/failure_site.h"

#include <cassert>
#include <cmath>
#include <sstream>

#include "engine/bodies/kernels/deformation_limits.h"
#include "engine/bodies/kernels/plane/body_energies.h"
#include "engine/bodies/table/body_kind.h"
#include "engine/step/stages.h"

namespace spoke {
namespace {

constexpr const char* kNotFinite = " is not finite";

// Differences between worlds: names of coordinates, and the place of their values.

/// Returns "axial displacement u of node 3", "deflection v of node 4" or "rotation psi of node 0".
std::string name_coordinate(const plane::FlexibleBody& body, int coordinate) {
  static constexpr const char* kNames[] = {"axial displacement u", "deflection v", "rotation psi"};
  for (int node = 0; node <= body.elements; ++node)
    for (int c = 0; c < kTwist; ++c)
      if (body.coordinate(node, c) == coordinate)
        return std::string(kNames[c]) + " of node " + std::to_string(node);
  return "coordinate " + std::to_string(coordinate);
}

CoordinateViolation find_violation(const BodyData<Plane>& body) {
  const LimitViolation found = find_limit_violation(body);
  if (found.coordinate < 0) return {};
  return {name_coordinate(*body.model->body, found.coordinate), found.value, found.limit};
}
CoordinateViolation find_violation(const BodyData<Space>& body) {
  return body.kind->find_violation(body);
}

/// Returns the first coordinate without an acceleration; empty if there is none.
std::string find_lost(const BodyData<Plane>& body) {
  const plane::FlexibleBody& model = *body.model->body;
  for (int k = 0; k < model.coordinates(); ++k)
    if (!std::isfinite(body.a_found[body.layout.offset(k)])) return name_coordinate(model, k);
  return {};
}
std::string find_lost(const BodyData<Space>& body) { return body.kind->find_lost(body); }

double sum_of(const BodyLoad<Plane>& load) { return load.force.x() + load.force.y() + load.moment; }
double sum_of(const BodyLoad<Space>& load) { return load.force.sum() + load.moment.sum(); }

std::string name_load(const BodyLoad<Plane>& load) {
  std::ostringstream text;
  text << "the load at x = " << load.points.front().x << " m in its frame";
  return text.str();
}
std::string name_load(const BodyLoad<Space>&) { return "a load on it"; }

double strain_energy_of(const BodyData<Plane>& body) { return calc_strain_energy(body); }
double strain_energy_of(const BodyData<Space>& body) { return body.kind->calc_strain_energy(body); }

std::string describe_violation(const CoordinateViolation& violation) {
  if (!std::isfinite(violation.value)) return kNotFinite;
  std::ostringstream text;
  text << " = " << violation.value << " is beyond what its linear model can mean (limit "
       << violation.limit << ")";
  return text.str();
}

/// Returns a name like "the acceleration of the deflection v of node 4".
template <class World>
std::string name_acceleration(const BodyData<World>& body) {
  const std::string lost = find_lost(body);
  return "the acceleration of " + (lost.empty() ? "its frame" : "the " + lost);
}

/// Calls `apply` with the indices and data of each body of the subsystems whose step has failed,
/// root to tip.
template <class World, class Apply>
void for_each_failed(const StepData<World>& data, Apply&& apply) {
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const SubsystemData<World>& subsystem = data.subsystems[i];
    if (subsystem.progress->outcome == StepOutcome::done) continue;
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j)
      apply(static_cast<int>(i), static_cast<int>(j), subsystem.bodies[j]);
  }
}

/// Finds the first body with a load that is not finite at the time of the failed pass.
template <class World>
FailureSite find_bad_load(const StepData<World>& data) {
  FailureSite found;
  for_each_failed(data, [&](int i, int j, const BodyData<World>& body) {
    const double t = data.subsystems[static_cast<std::size_t>(i)].progress->control.time;
    for (const BodyLoad<World>& load : body.model->loads) {
      if (std::isfinite(load.course->value(t) * sum_of(load)) || found.is_known()) continue;
      found = {i, j, name_load(load), kNotFinite, stages::kMass, true};
    }
  });
  return found;
}

/// Finds the first body with a coordinate that is not finite, or else the one farthest beyond its
/// limit.
template <class World>
FailureSite find_worst(const StepData<World>& data) {
  FailureSite worst;
  double largest = 0.0;
  for_each_failed(data, [&](int i, int j, const BodyData<World>& body) {
    const CoordinateViolation violation = find_violation(body);
    if (violation.coordinate.empty()) return;
    const double severity =
        std::isfinite(violation.value) ? std::abs(violation.value) / violation.limit : HUGE_VAL;
    if (severity <= largest) return;
    largest = severity;
    worst = {i, j, violation.coordinate, describe_violation(violation), stages::kRecovery};
  });
  return worst;
}

/// Finds the first body that reported a failure; its accelerations failed if its coordinates are
/// finite.
template <class World>
FailureSite find_reported(const StepData<World>& data) {
  FailureSite found;
  for_each_failed(data, [&](int i, int j, const BodyData<World>& body) {
    if (found.is_known() || body.report.failed == 0.0) return;
    found = {i, j, name_acceleration(body), kNotFinite, stages::kRecovery};
  });
  return found;
}

/// Finds the body with the largest change of a coordinate in the last iteration.
template <class World>
FailureSite find_most_changed(const StepData<World>& data) {
  FailureSite found;
  double largest = 0.0;
  for_each_failed(data, [&](int i, int j, const BodyData<World>& body) {
    if (found.is_known() && body.report.change <= largest) return;
    largest = body.report.change;
    found = {i, j, "change of a coordinate", "", stages::kRecovery};
  });
  return found;
}

/// Finds the body with the largest strain energy; rigid ones have none.
template <class World>
FailureSite find_most_strained(const StepData<World>& data) {
  FailureSite found;
  double largest = 0.0;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j) {
      const double strain = strain_energy_of(data.subsystems[i].bodies[j]);
      if (strain <= largest) continue;
      largest = strain;
      found = {static_cast<int>(i), static_cast<int>(j), "", "", stages::kSensors};
    }
  return found;
}

/// Returns the loop whose opening is the largest.
template <class World>
std::size_t find_widest(const Subsystem<World>& subsystem, const LoopData<World>& loops) {
  std::size_t widest = 0, r = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k)
    for (std::size_t row = 0; row < subsystem.loops[k].rows.size(); ++row) {
      const double opening = std::abs(loops.states[r].opening);
      if (loops.use[r++] == LoopRowUse::sprung || opening <= most) continue;
      most = opening;
      widest = k;
    }
  return widest;
}

/// Finds the loop that cannot be closed any more: one that is lost, or in a singular position.
template <class World>
FailureSite find_lost_loop(const System<World>& system, const StepData<World>& data,
                           StepOutcome outcome) {
  constexpr double kSingular = 1e-3;
  FailureSite found;
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    const LoopData<World>& loops = data.subsystems[i].loops;
    if (loops.is_empty() || data.subsystems[i].progress->outcome == StepOutcome::done) continue;
    const LoopReport& report = loops.report;
    const bool is_singular = report.least_pivot < kSingular || !std::isfinite(report.least_pivot);
    const bool is_lost = outcome == StepOutcome::left_limits && has_lost_loop(report);
    if (!is_singular && !is_lost) continue;
    std::size_t k = 0;
    while (k + 1 < loops.paths.size() && loops.paths[k + 1].first_row <= report.row) ++k;
    if (!is_singular) k = find_widest(system.subsystems[i], loops);
    const LoopModel& loop = system.subsystems[i].loops[k];
    const std::string what = loop.is_coupling() ? "coupling" : "closure of loop";
    found = {static_cast<int>(i), loop.from.body, what + " \"" + loop.name + "\"",
             is_singular ? " is lost in a singular position" : " is lost: it opens",
             stages::kLoopFactor};
    found.is_loop = true;
    return found;
  }
  return found;
}

}  // namespace

const StepProgress& failed_progress(const StepTable& data) {
  for (const StepProgress& progress : data.progress)
    if (progress.outcome != StepOutcome::done) return progress;
  return data.progress.front();
}

template <class World>
FailureSite find_site(const SystemContext<World>& context, StepOutcome outcome) {
  const StepData<World>& data = context.data;
  if (outcome == StepOutcome::energy_grew) return find_most_strained(data);
  if (FailureSite loop = find_lost_loop(context.system, data, outcome); loop.is_known())
    return loop;
  if (outcome == StepOutcome::not_converged) return find_most_changed(data);
  FailureSite site = find_bad_load(data);
  if (!site.is_known()) site = find_worst(data);
  if (!site.is_known()) site = find_reported(data);
  return site;
}

template FailureSite find_site(const SystemContext<Plane>&, StepOutcome);
template FailureSite find_site(const SystemContext<Space>&, StepOutcome);

}  // namespace spoke
