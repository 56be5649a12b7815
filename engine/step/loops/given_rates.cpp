// Moves what is prescribed at unit speed, or samples it over the run.

#include "engine/step/loops/given_rates.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/kernels/hub_motion.h"

namespace spoke {
namespace {

bool moves(const space::DrivenMotion& motion, double duration, bool hub_turns) {
  if (const auto* azimuth = std::get_if<spatial::AzimuthMotion>(&motion))
    return hub_turns && (azimuth->cosine != 0.0 || azimuth->sine != 0.0);
  if (const auto* said = std::get_if<space::SaidMotion>(&motion))
    return said->rate != 0.0 || said->acceleration != 0.0;
  const Curve& curve = std::get<spatial::MotionTable>(motion).value;
  const std::vector<double>& values = curve.values();
  return duration > curve.times().front() &&
         std::any_of(values.begin(), values.end(),
                     [&](double value) { return value != values.front(); });
}

/// Whether a drive turns the hub within the run, by its prescribed motion.
bool turns(const Drive& drive, double duration) {
  constexpr int kSamples = 64;
  if (!prescribes_motion(drive)) return false;
  for (int k = 0; k <= kSamples; ++k)
    if (calc_motion(drive, duration * k / kSamples).speed != 0.0) return true;
  return false;
}

bool moves(const spatial::VectorCourse& course) {
  if (const auto* harmonic = std::get_if<spatial::VectorHarmonic>(&course))
    return !harmonic->rate.isZero(0.0) || !harmonic->amplitude.isZero(0.0);
  const auto& components = std::get<spatial::VectorTable>(course).components;
  return std::any_of(components.begin(), components.end(), [](const Curve& curve) {
    const std::vector<double>& values = curve.values();
    return std::any_of(values.begin(), values.end(),
                       [&](double value) { return value != values.front(); });
  });
}

/// Whether an anchor moves, or may be moved by the embedding program.
bool moves(const AnchorModel& anchor) {
  const auto* motion = std::get_if<spatial::MountMotion>(&anchor.motion);
  return motion == nullptr || moves(motion->translation) || moves(motion->rotation);
}

template <class World>
void add_driven(const SystemContext<World>& context, std::size_t subsystem, double duration,
                LoopKinematics<World>& kinematics, GivenRates& given) {
  if constexpr (tree::kHasJointCoordinates<World>) {
    const Subsystem<World>& model = context.system.subsystems[subsystem];
    const bool hub_turns = turns(context.system.hub.drive, duration);
    for_loop_bodies(model, context.data.subsystems[subsystem].loops, [&](std::size_t j) {
      const space::JointCourse& course = model.bodies[j].joint.course;
      const std::vector<space::DrivenMotion>& driven = course.driven;
      for (std::size_t c = 0; c < driven.size(); ++c)
        if ((c == 0 && course.control >= 0) || (course.drive && turns(*course.drive, duration)) ||
            moves(driven[c], duration, hub_turns))
          given.add(
              kinematics.calc_driven_column(subsystem, static_cast<int>(j), static_cast<int>(c)),
              "the driven joint of body " + std::to_string(j + 1));
    });
  }
}

/// Returns the anchor that moves a place of a loop against a body; -1: none does. Of a loop between
/// subsystems the share at the end of which it is has it as `from`.
int anchor_of(const LoopModel& loop) {
  if (loop.from.is_moved()) return loop.from.anchor;
  return loop.to.is_moved() ? loop.to.anchor : -1;
}

/// Adds what anchors and mount do, at times within the run.
template <class World>
void add_places(SystemContext<World>& context, std::size_t subsystem, double duration,
                LoopKinematics<World>& kinematics, GivenRates& given) {
  constexpr int kSamples = 16;
  const std::vector<LoopModel>& loops = context.system.subsystems[subsystem].loops;
  const bool has_any = std::any_of(loops.begin(), loops.end(), [](const LoopModel& loop) {
    return loop.to.carrier == LoopPlace::Carrier::anchor ||
           loop.to.carrier == LoopPlace::Carrier::mount || anchor_of(loop) >= 0;
  });
  if (!has_any) return;
  double& time = context.data.subsystems[subsystem].progress->control.time;
  const double kept = time;
  for (int k = 0; k <= kSamples; ++k) {
    time = duration * k / kSamples;
    kinematics.evaluate();
    given.add(kinematics.given_rates(), "the motion of its anchor or mount");
  }
  time = kept;
  kinematics.evaluate();
}

}  // namespace

void GivenRates::add(const Eigen::VectorXd& column, const std::string& name) {
  assert(column.size() == columns.rows());
  columns.conservativeResize(column.size(), columns.cols() + 1);
  columns.col(columns.cols() - 1) = column;
  names.push_back(name);
}

template <class World>
GivenRates find_given_rates(SystemContext<World>& context, const LoopGroup& group, double duration,
                            LoopKinematics<World>& kinematics) {
  GivenRates given;
  given.columns.resize(std::ssize(kinematics.rigid_rows()), 0);
  for (const std::size_t i : group) add_driven(context, i, duration, kinematics, given);
  if (turns(context.system.hub.drive, duration))
    given.add(kinematics.calc_hub_column(), "the rotation of the hub");
  for (const std::size_t i : group) add_places(context, i, duration, kinematics, given);
  return given;
}

template <class World>
bool is_at_rest(const System<World>& system, double duration) {
  if (!is_prescribed(system) || turns(system.hub.drive, duration)) return false;
  if constexpr (tree::kHasJointCoordinates<World>)
    if (system.hub.mount) return false;
  return true;
}

template <class World>
bool may_be_moved(const System<World>& system, const Subsystem<World>& subsystem) {
  for (const LoopModel& loop : subsystem.loops) {
    const int anchor =
        loop.to.carrier == LoopPlace::Carrier::anchor ? loop.to.anchor : anchor_of(loop);
    if (anchor >= 0 && moves(system.anchors[static_cast<std::size_t>(anchor)])) return true;
  }
  if constexpr (tree::kHasJointCoordinates<World>)
    for (const TreeBody<World>& body : subsystem.bodies) {
      if (body.joint.course.control >= 0) return true;
      for (const space::DrivenMotion& motion : body.joint.course.driven)
        if (std::holds_alternative<space::SaidMotion>(motion)) return true;
    }
  return false;
}

template GivenRates find_given_rates(SystemContext<Plane>&, const LoopGroup&, double,
                                     LoopKinematics<Plane>&);
template bool is_at_rest(const System<Plane>&, double);
template bool may_be_moved(const System<Plane>&, const Subsystem<Plane>&);
template GivenRates find_given_rates(SystemContext<Space>&, const LoopGroup&, double,
                                     LoopKinematics<Space>&);
template bool is_at_rest(const System<Space>&, double);
template bool may_be_moved(const System<Space>&, const Subsystem<Space>&);

}  // namespace spoke
