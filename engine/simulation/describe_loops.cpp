// Puts names of subsystems, joints, loops and rows in the place of indices.

#include "engine/simulation/describe_loops.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace spoke {
namespace {

/// Returns "x" for an axis along x, either way, likewise y and z; else its components.
std::string describe_axis(const space::Position& axis) {
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  std::ostringstream text;
  text.precision(4);
  for (int c = 0; c < 3; ++c)
    if (std::abs(std::abs(axis[c]) - 1.0) < 1e-12) {
      text << kNames[static_cast<std::size_t>(c)];
      return text.str();
    }
  const auto number = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
  text << "[" << number(axis[0]) << ", " << number(axis[1]) << ", " << number(axis[2]) << "]";
  return text.str();
}

std::string describe_row(const LoopRow& row) {
  switch (row.kind) {
    case LoopRow::Kind::displacement:
      return "displacement along " + describe_axis(row.axis);
    case LoopRow::Kind::alignment:
      return "rotation about " +
             describe_axis(space::Position(cross(row.axis, row.other).normalized()));
    case LoopRow::Kind::rotation:
      return "rotation about " + describe_axis(row.axis);
    case LoopRow::Kind::coupling:
      return "coupling";
    case LoopRow::Kind::distance:
      break;
  }
  return "distance";
}

}  // namespace

template <class World>
LoopsAtStart describe_loops(const SystemContext<World>& context,
                            const std::vector<SubsystemNames>& names) {
  const LoopStart& start = context.loop_start;
  const auto& subsystems = context.system.subsystems;
  LoopsAtStart described;
  for (std::size_t i = 0; i < start.freedoms.size(); ++i) {
    if (subsystems[i].loops.empty()) continue;
    const LoopFreedoms& own = start.freedoms[i];
    described.subsystems.push_back(
        {names[i].name, own.joints, own.deformations, own.rows, own.independent, own.mobility()});
  }
  for (const LoopRowPlace& place : start.dropped) {
    const auto i = static_cast<std::size_t>(place.subsystem);
    const LoopModel& loop = subsystems[i].loops[static_cast<std::size_t>(place.loop)];
    described.redundant.push_back(names[i].name + " / " + loop.name + ": " +
                                  describe_row(loop.rows[static_cast<std::size_t>(place.row)]));
  }
  for (const LoopMove& move : start.moves) {
    const auto i = static_cast<std::size_t>(move.subsystem);
    described.moved.push_back(
        {names[i].name + " / " + names[i].joints[static_cast<std::size_t>(move.body)], move.by,
         move.is_angle ? "rad" : "m"});
  }
  for (const LoopSpeed& speed : start.speeds) {
    const auto i = static_cast<std::size_t>(speed.subsystem);
    described.speeds.push_back(
        {names[i].name + " / " + names[i].joints[static_cast<std::size_t>(speed.body)], speed.from,
         speed.to, speed.is_angle ? "rad/s" : "m/s"});
  }
  return described;
}

template LoopsAtStart describe_loops(const SystemContext<Plane>&,
                                     const std::vector<SubsystemNames>&);
template LoopsAtStart describe_loops(const SystemContext<Space>&,
                                     const std::vector<SubsystemNames>&);

}  // namespace spoke
