// Takes time out of loads, motors and prescribed motions.

#include "engine/small_motions/steady/steady_loads.h"

#include "models/space/body.h"
#include "models/space/hub.h"
#include "models/space/tension_place.h"
#include "models/space/tree_joint.h"

namespace spoke::steady {
namespace {

/// Keeps of a load that is constant in the inertial frame the part that is constant in the hub's
/// frame, too: in the plane the moment, in space the parts along the axis.
void keep_axial(const System<Plane>&, BodyLoad<Plane>& load) {
  if (load.frame == LoadFrame::inertial) load.force.setZero();
}
void keep_axial(const System<Plane>&, HubLoad& load) {
  if (load.frame == LoadFrame::inertial) load.force.setZero();
}

space::Position axial_part(const System<Space>& system, const space::Position& vector) {
  const space::Position axis = make_rotation(system.hub.orientation) * space::Position(0, 0, 1);
  return axis * axis.dot(vector);
}
void keep_axial(const System<Space>& system, BodyLoad<Space>& load) {
  if (load.frame != spatial::LoadFrame::inertial) return;
  load.force = axial_part(system, load.force);
  load.moment = axial_part(system, load.moment);
}
void keep_axial(const System<Space>& system, space::HubLoad& load) {
  if (load.frame != LoadFrame::inertial) return;
  load.force = axial_part(system, load.force);
  load.moment = axial_part(system, load.moment);
}

Position steady_gravity(const System<Plane>& system, bool turns) {
  const bool falls = system.hub.support == HubSupport::free;
  return turns || falls ? Position(0.0, 0.0) : system.gravity;
}
space::Position steady_gravity(const System<Space>& system, bool turns) {
  if (system.hub.support == HubSupport::free) return space::Position::Zero();
  return turns ? axial_part(system, system.gravity) : system.gravity;
}

double steady_value(const Curve& curve, Instant instant) {
  return instant == Instant::start ? curve.value(0.0) : curve.values().back();
}

double steady_value(const space::DrivenMotion& motion, Instant instant) {
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion))
    return steady_value(table->value, instant);
  if (const auto* azimuth = std::get_if<spatial::AzimuthMotion>(&motion)) return azimuth->mean;
  return std::get<space::SaidMotion>(motion).value;
}

std::vector<Curve*> hold_joints(System<Plane>&, Instant) { return {}; }
/// Holds prescribed joints at their steady values, those of controllers at the initial angle, and
/// returns the motors of the others.
std::vector<Curve*> hold_joints(System<Space>& system, Instant instant) {
  std::vector<Curve*> motors;
  for (Subsystem<Space>& subsystem : system.subsystems) {
    for (TreeBody<Space>& body : subsystem.bodies) {
      space::JointCourse& course = body.joint.course;
      for (space::DrivenMotion& motion : course.driven)
        motion = spatial::MotionTable{Curve(steady_value(motion, instant))};
      if (course.control >= 0) {
        const DemandedAngle& control = subsystem.controls[static_cast<std::size_t>(course.control)];
        const double own = std::get<spatial::MotionTable>(course.driven[0]).value.value(0.0);
        course.driven[0] = spatial::MotionTable{Curve(own + control.sign * control.initial)};
        course.control = -1;
      }
      for (Curve& effort : course.efforts) motors.push_back(&effort);
    }
    subsystem.controls.clear();
  }
  return motors;
}

}  // namespace

template <class World>
SteadyLoads<World>::SteadyLoads(System<World>& system, bool turns, Instant instant)
    : system_(system), gravity_(steady_gravity(system, turns)) {
  system.gravity_ramp = 0.0;
  const auto hold = [this, instant](auto& load) {
    auto course = std::make_shared<LoadCourse>();
    courses_.push_back({course, steady_value(load.course->factor, instant)});
    load.course = course;
  };
  for (Subsystem<World>& subsystem : system.subsystems)
    for (TreeBody<World>& body : subsystem.bodies) {
      for (BodyLoad<World>& load : body.loads) {
        if (turns) keep_axial(system, load);
        hold(load);
      }
      for (BodyDrag<World>& drag : body.drags) hold(drag);
    }
  for (Curve* motor : hold_joints(system, instant))
    efforts_.push_back({motor, steady_value(*motor, instant)});
  for (auto& load : system.hub_loads) {
    if (turns) keep_axial(system, load);
    load.ramp = 0.0;
    efforts_.push_back({&load.factor, steady_value(load.factor, instant)});
  }
  set_share(1.0);
}

template <class World>
void SteadyLoads<World>::set_share(double share) {
  system_.gravity = share * gravity_;
  for (const Scaled& scaled : courses_) *scaled.course = {Curve(share * scaled.full), 0.0};
  for (const Effort& effort : efforts_) *effort.curve = Curve(share * effort.full);
}

template class SteadyLoads<Plane>;
template class SteadyLoads<Space>;

}  // namespace spoke::steady
