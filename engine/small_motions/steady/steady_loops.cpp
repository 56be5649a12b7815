// Reads the states of rows that the step's own kernel finds.

#include "engine/small_motions/steady/steady_loops.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "engine/bodies/kernels/loops/bearing_force.h"
#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/loops/loop_readings.h"
#include "engine/small_motions/steady/subsystem_access.h"

namespace spoke::steady {

template <class World>
std::vector<std::vector<LoopRowUse>> start_loops_of(System<World>& system,
                                                    const LoopLimits& limits) {
  std::vector<std::vector<LoopRowUse>> use(system.subsystems.size());
  if (std::all_of(system.subsystems.begin(), system.subsystems.end(),
                  [](const Subsystem<World>& subsystem) { return subsystem.loops.empty(); }))
    return use;
  SystemContext<World> context;
  context.system = system;
  context.integrator = {Rk4{1.0}, {}};
  context.loop_limits = limits;
  allocate(context);
  for (std::size_t i = 0; i < use.size(); ++i) {
    use[i] = context.data.subsystems[i].loops.use;
    Subsystem<World>& subsystem = system.subsystems[i];
    if (subsystem.loops.empty()) continue;
    subsystem.loops = context.system.subsystems[i].loops;
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      const BodyData<World>& body = context.data.subsystems[i].bodies[j];
      std::vector<double> q(static_cast<std::size_t>(count_joint_coordinates(*body.model)));
      take_joint_position(body, q.data());
      make_absolute(body, q.data());
      put_initial(q.data(), subsystem.bodies[j]);
    }
  }
  return use;
}

template <class World>
std::vector<ClosureRow> list_rows(const Subsystem<World>& subsystem,
                                  const SubsystemData<World>& data) {
  std::vector<ClosureRow> rows;
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    for (const LoopRow& row : subsystem.loops[k].rows)
      rows.push_back(
          {k, data.loops.use[rows.size()] == LoopRowUse::dropped, row.stiffness, row.damping});
    if (!subsystem.loops[k].bearing) continue;
    rows[rows.size() - 2].other = 1;
    rows.back().other = -1;
  }
  return rows;
}

namespace {

/// Sets the stiffness of the rows of bearings with matrices, by their speeds in the table.
template <class World>
void put_bearings(const System<World>& system, std::size_t i, std::vector<ClosureRow>& rows,
                  const StepData<World>& data) {
  const Subsystem<World>& subsystem = system.subsystems[i];
  for (std::size_t k = 0; k < subsystem.loops.size(); ++k) {
    const LoopModel& loop = subsystem.loops[k];
    if (!loop.bearing || loop.is_share) continue;
    const auto [from, to] = calc_place_motions(system, i, loop, 0.0, data);
    const Eigen::Matrix2d K =
        loop.bearing->at(calc_bearing_speed(*loop.bearing, from, to)).stiffness;
    ClosureRow* row = &rows[static_cast<std::size_t>(data.subsystems[i].loops.paths[k].first_row)];
    for (int r = 0; r < 2; ++r) {
      row[r].stiffness = K(r, r);
      row[r].cross_stiffness = K(r, 1 - r);
    }
  }
}

/// Returns the force of a row of a bearing with matrices. If springs are held, that of the state
/// takes its place as far as its rates, and its speed, change it.
double calc_bearing_row(const ClosureRow& row, const SubsystemState& state, Eigen::Index r,
                        double force, const Eigen::VectorXd& openings) {
  if (!state.holds_springs) return force;
  force += row.stiffness * openings[r] + row.cross_stiffness * openings[r + row.other];
  return state.multipliers.size() > 0 ? state.multipliers[r] + force : force;
}

}  // namespace

template <class World>
void put_loops(const System<World>& system, std::size_t i, const SubsystemState& state,
               std::vector<ClosureRow>& rows, StepData<World>& data, SubsystemResponse& response) {
  const Eigen::Index count = std::ssize(rows);
  assert(state.multipliers.size() == 0 || state.multipliers.size() == count);
  response.openings.resize(count);
  response.multipliers.setZero(count);
  if (count == 0) return;
  if (!state.holds_springs) put_bearings(system, i, rows, data);
  const auto& states = data.subsystems[i].loops.states;
  for (Eigen::Index r = 0; r < count; ++r)
    response.openings[r] = states[static_cast<std::size_t>(r)].opening;
  for (Eigen::Index r = 0; r < count; ++r) {
    const ClosureRow& row = rows[static_cast<std::size_t>(r)];
    const LoopRowState<World>& motion = states[static_cast<std::size_t>(r)];
    if (row.is_dropped) continue;
    double& force = response.multipliers[r];
    if (row.other != 0) {
      force = calc_bearing_row(row, state, r, motion.force, response.openings);
      continue;
    }
    if (!row.is_rigid() && !state.holds_springs)
      force = -row.stiffness * motion.opening;
    else if (state.multipliers.size() > 0)
      force = state.multipliers[r];
    force -= row.damping * motion.rate;
  }
}

template <class World>
std::vector<LoopLoad> calc_loop_loads(const System<World>& system, std::size_t i,
                                      const Eigen::VectorXd& multipliers,
                                      const StepData<World>& data) {
  std::vector<LoopLoad> loads;
  const std::span<const double> by_row(multipliers.data(),
                                       static_cast<std::size_t>(multipliers.size()));
  for (std::size_t k = 0; k < system.subsystems[i].loops.size(); ++k) {
    const LoopModel& loop = system.subsystems[i].loops[k];
    if (loop.is_coupling() || loop.is_share) continue;
    LoopLoad& load = loads.emplace_back();
    load.name = loop.name;
    const LoopVector reaction = calc_loop_reaction(system, i, k, 0.0, data, by_row);
    load.force = reaction.in_hub.head<3>();
    load.moment = reaction.in_hub.tail<3>();
    if (loop.kind == LoopKind::distance) load.tension = reaction.in_loop[0];
  }
  return loads;
}

template std::vector<std::vector<LoopRowUse>> start_loops_of(System<Plane>&, const LoopLimits&);
template std::vector<std::vector<LoopRowUse>> start_loops_of(System<Space>&, const LoopLimits&);
template std::vector<ClosureRow> list_rows(const Subsystem<Plane>&, const SubsystemData<Plane>&);
template std::vector<ClosureRow> list_rows(const Subsystem<Space>&, const SubsystemData<Space>&);
template void put_loops(const System<Plane>&, std::size_t, const SubsystemState&,
                        std::vector<ClosureRow>&, StepData<Plane>&, SubsystemResponse&);
template void put_loops(const System<Space>&, std::size_t, const SubsystemState&,
                        std::vector<ClosureRow>&, StepData<Space>&, SubsystemResponse&);
template std::vector<LoopLoad> calc_loop_loads(const System<Plane>&, std::size_t,
                                               const Eigen::VectorXd&, const StepData<Plane>&);
template std::vector<LoopLoad> calc_loop_loads(const System<Space>&, std::size_t,
                                               const Eigen::VectorXd&, const StepData<Space>&);

}  // namespace spoke::steady
