// Copies the system with the courses of its loads, readings, and the memory of the state.

#include "engine/step/copy_context.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <memory>
#include <vector>

#include "engine/bodies/table/state_values.h"

namespace spoke {
namespace {

using CourseCopies = std::map<const LoadCourse*, std::shared_ptr<LoadCourse>>;

/// Gives loads courses of their own, which the program may scale. Those of one load stay one.
template <class World>
void part_courses(System<World>& system) {
  CourseCopies own;
  const auto part = [&own](auto& loads) {
    for (auto& load : loads) {
      std::shared_ptr<LoadCourse>& course = own[load.course.get()];
      if (!course) course = std::make_shared<LoadCourse>(*load.course);
      load.course = course;
    }
  };
  for (Subsystem<World>& subsystem : system.subsystems)
    for (TreeBody<World>& body : subsystem.bodies) {
      part(body.loads);
      part(body.drags);
    }
}

/// Lets the readings of a copy follow its own courses of loads.
void follow_courses(const SystemContext<Plane>&, SystemContext<Plane>&) {}
void follow_courses(const SystemContext<Space>& original, SystemContext<Space>& copy) {
  CourseCopies own;
  for (std::size_t i = 0; i < copy.system.subsystems.size(); ++i)
    for (std::size_t j = 0; j < copy.system.subsystems[i].bodies.size(); ++j) {
      const std::vector<BodyLoad<Space>>& loads = copy.system.subsystems[i].bodies[j].loads;
      for (std::size_t k = 0; k < loads.size(); ++k)
        own[original.system.subsystems[i].bodies[j].loads[k].course.get()] = loads[k].course;
    }
  for (SubsystemData<Space>& subsystem : copy.data.subsystems)
    for (Reading<Space>& reading : subsystem.readings)
      for (OutboardLoad& outboard : reading.loads)
        outboard.load.course = own.at(outboard.load.course.get());
}

}  // namespace

template <class World>
void copy_readings(const SystemContext<World>& original, SystemContext<World>& copy) {
  for (std::size_t i = 0; i < copy.data.subsystems.size(); ++i) {
    SubsystemData<World>& data = copy.data.subsystems[i];
    data.readings = original.data.subsystems[i].readings;
    data.reading_count = original.data.subsystems[i].reading_count;
    place_reading_ring(data);
  }
  follow_courses(original, copy);
}

template <class World>
void begin_copy(const SystemContext<World>& original, SystemContext<World>& copy) {
  copy.formulation = original.formulation;
  copy.integrator = original.integrator;
  copy.linear_range = original.linear_range;
  copy.loads_tie_subsystems = original.loads_tie_subsystems;
  copy.loop_limits = original.loop_limits;
  copy.loop_limits.has_started = true;
  copy.system = original.system;
  copy.data.names = original.data.names;
  part_courses(copy.system);
  copy.work.bodies.constants = original.work.bodies.constants;
  copy.work.dense = original.work.dense;
}

template <class World>
void end_copy(SystemContext<World>& original, std::int64_t steps, SystemContext<World>& copy) {
  copy.loop_limits = original.loop_limits;
  copy.loop_start = original.loop_start;
  for (std::size_t i = 0; i < copy.data.subsystems.size(); ++i)
    copy.data.subsystems[i].loops.use = original.data.subsystems[i].loops.use;
  copy.data.shared_loops.rows.use = original.data.shared_loops.rows.use;
  // Besides the values of a saved state it holds the pivots of loops at the start.
  const Memory from = original.data.state_memory(), to = copy.data.state_memory();
  assert(from.size() == to.size());
  for (std::size_t k = 0; k < to.size(); ++k) {
    assert(from[k].size() == to[k].size());
    std::copy(from[k].begin(), from[k].end(), to[k].begin());
  }
  std::vector<double> values;
  original.data.take_state(steps, values);
  copy.data.put_state(values, steps);  // with the record of the step
}

template void begin_copy(const SystemContext<Plane>&, SystemContext<Plane>&);
template void begin_copy(const SystemContext<Space>&, SystemContext<Space>&);
template void copy_readings(const SystemContext<Plane>&, SystemContext<Plane>&);
template void copy_readings(const SystemContext<Space>&, SystemContext<Space>&);
template void end_copy(SystemContext<Plane>&, std::int64_t, SystemContext<Plane>&);
template void end_copy(SystemContext<Space>&, std::int64_t, SystemContext<Space>&);

}  // namespace spoke
