// Examines the points of drives, and of tables of joints, the mount and anchors.

#include "engine/simulation/jumps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <sstream>

#include "engine/simulation/anchors.h"
#include "models/start.h"

namespace spoke {
namespace {

constexpr const char* kFirstDrive = "the drive";
constexpr double kNotable = 0.01;  ///< least notable change, by the largest change

/// Returns the magnitude of the mean rate of a curve between two times.
double rate_between(const Curve& course, double from, double to) {
  assert(from < to);
  return std::abs(course.value(to) - course.value(from)) / (to - from);
}

/// Whether the curve changes between two times much faster than just before and just after: points
/// of a smooth table may be close to one another.
bool stands_out(const Curve& course, double from, double to, double step_size) {
  constexpr double kFaster = 4.0;
  const double around = kLeastSteps * step_size;
  const double before = rate_between(course, from - around, from);
  const double after = rate_between(course, to, to + around);
  return rate_between(course, from, to) > kFaster * std::max(before, after);
}

/// A change of a curve's value.
struct Change {
  double time = 0.0, duration = 0.0;  ///< [s]
  double size = 0.0;
};

/// Returns the changes between neighbouring points, two or a few, that begin between `begin` and
/// `end`.
std::vector<Change> find_changes(const Curve& course, double begin, double end, double step_size) {
  const std::vector<double>&times = course.times(), &values = course.values();
  double largest = 0.0;
  for (std::size_t k = 1; k < times.size(); ++k)
    largest = std::max(largest, std::abs(values[k] - values[k - 1]));
  const double least = kLeastSteps * step_size;
  std::vector<Change> found;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double from = times[k - 1], to = times[k], change = values[k] - values[k - 1];
    const bool is_within = to > begin && from < end && to - from < least;
    if (!is_within || std::abs(change) <= kNotable * largest) continue;
    // The interval may stand out by itself, or together with the next ones.
    if (stands_out(course, from, to, step_size)) {
      found.push_back({from, to - from, change});
    } else if (stands_out(course, from, from + least, step_size)) {
      const auto next = std::upper_bound(times.begin(), times.end(), from + least);
      const std::size_t last = static_cast<std::size_t>(next - times.begin()) - 1;
      found.push_back({from, times[last] - from, values[last] - values[k - 1]});
    }
  }
  return found;
}

std::string describe(const std::string& name, double change, const std::string& unit) {
  std::ostringstream text;
  text << name << " by " << change << " " << unit;
  return text.str();
}

/// Adds jumps of the speed where a table of places begins or ends while it moves.
void add_kinks(const Curve& course, const std::string& name, const std::string& unit, double begin,
               double end, std::vector<Jump>& jumps) {
  const std::vector<double>& times = course.times();
  if (times.size() < 2) return;
  double largest = 0.0;
  for (std::size_t k = 1; k < times.size(); ++k)
    largest = std::max(largest, rate_between(course, times[k - 1], times[k]));
  const auto add = [&](double t, double change) {
    if (t > begin && t < end && std::abs(change) > kNotable * largest)
      jumps.push_back({t, 0.0, name, describe(name + " changes its speed", change, unit + "/s")});
  };
  add(times.front(), course.derivative(times.front()));
  add(times.back(), -course.derivative(times.back()));
}

void sort_by_time(std::vector<Jump>& jumps) {
  std::stable_sort(jumps.begin(), jumps.end(),
                   [](const Jump& one, const Jump& other) { return one.time < other.time; });
}

void append(std::vector<Jump> more, std::vector<Jump>& jumps) {
  std::move(more.begin(), more.end(), std::back_inserter(jumps));
}

std::vector<Change> find_drive_changes(const Drive& drive, double begin, double end,
                                       double step_size) {
  if (const auto* table = std::get_if<SpeedTable>(&drive))
    return find_changes(table->speed, begin, end, step_size);
  std::vector<Change> ramps;
  if (const auto* spin = std::get_if<SpinUp>(&drive)) {
    ramps.push_back({0.0, spin->ramp, spin->speed});
  } else if (const auto* cycle = std::get_if<SpinUpHoldSpinDown>(&drive)) {
    // A cycle without a ramp has begun at its speed.
    if (cycle->ramp > 0.0) ramps.push_back({0.0, cycle->ramp, cycle->speed});
    ramps.push_back({cycle->ramp + cycle->hold, cycle->ramp_down, -cycle->speed});
  }
  std::erase_if(ramps, [&](const Change& ramp) {
    const bool is_within = ramp.time + ramp.duration >= begin && ramp.time < end;
    return ramp.duration >= kLeastSteps * step_size || !is_within || ramp.size == 0.0;
  });
  return ramps;
}

/// Returns a name like "the joint "pitch" of blade 1".
std::string name_joint(const spatial::Joint& joint, std::size_t number, const std::string& tree) {
  const std::string which =
      joint.name.empty() ? "joint " + std::to_string(number + 1) : "joint \"" + joint.name + "\"";
  return "the " + which + " of " + tree;
}

void add_joint_jumps(const spatial::Joint& joint, const std::string& name, double end,
                     double step_size, std::vector<Jump>& jumps) {
  for (int c = 0; c < count_coordinates(joint.kind); ++c) {
    const auto& motion = joint.coordinates[static_cast<std::size_t>(c)].motion;
    const auto* table = motion ? std::get_if<spatial::MotionTable>(&*motion) : nullptr;
    if (!table) continue;
    append(find_course_jumps(table->value, name, slides(joint.kind, c) ? "m" : "rad", 0.0, end,
                             step_size),
           jumps);
  }
}

void add_vector_jumps(const spatial::VectorCourse& course, const std::string& name,
                      const std::string& unit, double begin, double end, double step_size,
                      std::vector<Jump>& jumps) {
  const auto* table = std::get_if<spatial::VectorTable>(&course);
  if (!table) return;
  for (std::size_t c = 0; c < table->components.size(); ++c)
    append(find_course_jumps(table->components[c], name + " along " + "xyz"[c], unit, begin, end,
                             step_size),
           jumps);
}

void add_anchor_jumps(const std::vector<Anchor>& anchors, double end, double step_size,
                      std::vector<Jump>& jumps) {
  for (const Anchor& anchor : anchors)
    if (const auto* motion = std::get_if<spatial::MountMotion>(&anchor.motion))
      append(find_anchor_jumps(anchor.name, *motion, 0.0, end, step_size), jumps);
}

void add_spatial_jumps(const spatial::Model& model, double end, double step_size,
                       std::vector<Jump>& jumps) {
  if (model.hub.mount) {
    add_vector_jumps(model.hub.mount->translation, "the mount's translation", "m", 0.0, end,
                     step_size, jumps);
    add_vector_jumps(model.hub.mount->rotation, "the mount's rotation", "rad", 0.0, end, step_size,
                     jumps);
  }
  add_anchor_jumps(model.anchors, end, step_size, jumps);
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    for (std::size_t k = 0; k < model.blades[i].joints.size(); ++k) {
      const spatial::Joint& joint = model.blades[i].joints[k].joint;
      add_joint_jumps(joint, name_joint(joint, k, "blade " + std::to_string(i + 1)), end, step_size,
                      jumps);
    }
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (std::size_t k = 0; k < subsystem.joints.size(); ++k) {
      const spatial::Joint& joint = subsystem.joints[k].joint;
      add_joint_jumps(joint, name_joint(joint, k, "subsystem \"" + subsystem.name + "\""), end,
                      step_size, jumps);
    }
}

}  // namespace

std::vector<Jump> find_course_jumps(const Curve& course, const std::string& name,
                                    const std::string& unit, double begin, double end,
                                    double step_size) {
  std::vector<Jump> jumps;
  for (const Change& change : find_changes(course, begin, end, step_size))
    jumps.push_back(
        {change.time, change.duration, name, describe(name + " moves", change.size, unit)});
  add_kinks(course, name, unit, begin, end, jumps);
  return jumps;
}

std::string describe_drive(const Scenario& scenario, int rotor) {
  return rotor == 0 ? kFirstDrive
                    : kFirstDrive + (" of \"" + hub_of(*scenario.space, rotor).name + '"');
}

std::vector<Jump> find_drive_jumps(const Drive& drive, const std::string& name, double begin,
                                   double end, double step_size) {
  assert(step_size > 0.0);
  std::vector<Jump> jumps;
  for (const Change& change : find_drive_changes(drive, begin, end, step_size))
    jumps.push_back({change.time, change.duration, name,
                     describe(name + " changes the speed", change.size, "rad/s")});
  return jumps;
}

std::vector<Jump> find_anchor_jumps(std::string_view name, const spatial::MountMotion& motion,
                                    double begin, double end, double step_size) {
  const std::string source = describe_anchor(name);
  std::vector<Jump> jumps;
  add_vector_jumps(motion.translation, "the translation of " + source, "m", begin, end, step_size,
                   jumps);
  add_vector_jumps(motion.rotation, "the rotation of " + source, "rad", begin, end, step_size,
                   jumps);
  for (Jump& jump : jumps) jump.source = source;
  return jumps;
}

std::vector<Jump> find_jumps(const Scenario& scenario, double step_size) {
  const double end = scenario.integration.duration;
  std::vector<Jump> jumps;
  const auto add_drive = [&](const Drive& drive, int rotor) {
    append(find_drive_jumps(drive, describe_drive(scenario, rotor), 0.0, end, step_size), jumps);
  };
  add_drive(drive_of(scenario), 0);
  if (scenario.space)
    for (int r = 1; r < count_rotors(*scenario.space); ++r)
      add_drive(hub_of(*scenario.space, r).drive, r);
  if (scenario.space)
    add_spatial_jumps(*scenario.space, end, step_size, jumps);
  else
    add_anchor_jumps(scenario.rotor.anchors, end, step_size, jumps);
  sort_by_time(jumps);
  return jumps;
}

void replace_jumps(const std::string& source, double t, std::vector<Jump> next,
                   std::vector<Jump>& jumps) {
  std::erase_if(jumps, [&](const Jump& jump) { return jump.source == source && jump.time >= t; });
  append(std::move(next), jumps);
  sort_by_time(jumps);
}

std::string blame_jump(const std::vector<Jump>& jumps, double t, double step_size) {
  const auto is_near = [&](const Jump& jump) {
    return t >= jump.time && t - jump.time <= 2.0 * kLeastSteps * step_size;
  };
  const auto near = std::find_if(jumps.begin(), jumps.end(), is_near);
  if (near == jumps.end()) return {};
  std::ostringstream text;
  text << (near->source == kFirstDrive ? "the drive's speed jumps" : near->text)
       << " at t = " << near->time << " s, " << advise_on_jump(*near, step_size);
  return text.str();
}

std::string advise_on_jump(const Jump& jump, double step_size) {
  std::ostringstream text;
  if (jump.duration == 0.0)
    return "give the first and the last value of the table twice, so that it begins and ends at "
           "rest";
  text << "let the change take " << kLeastSteps * step_size << " s or more";
  // For a ramp shorter than a step a smaller step is not suggested: it is hardly meant.
  if (jump.duration > step_size)
    text << ", or take an integration.step of " << jump.duration / kLeastSteps << " s or less";
  return text.str();
}

}  // namespace spoke
