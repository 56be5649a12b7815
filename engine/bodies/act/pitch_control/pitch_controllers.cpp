// Takes the samples of the controllers when their time has come.

#include "engine/bodies/act/pitch_control/pitch_controllers.h"

#include <algorithm>

#include "engine/bodies/kernels/pitch_control.h"
#include "models/system/spatial_system.h"

namespace spoke {
namespace {

bool has_pitch(const Subsystem<Space>& subsystem) {
  return !subsystem.controls.empty() && subsystem.controls.front().is_pitch;
}

/// Whether demands of a subsystem are those of laws, which take samples.
bool has_law(const Subsystem<Space>& subsystem) {
  return !subsystem.controls.empty() && subsystem.controls.front().law.has_value();
}

}  // namespace

PitchControllers::PitchControllers(const System<Space>& system, StepData<Space>& data)
    : system_(system), data_(data), parts_(system.subsystems.size()) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::vector<DemandedAngle>& controls = system.subsystems[i].controls;
    if (controls.empty()) continue;
    SubsystemData<Space>& own = data.subsystems[i];
    own.controls = ArenaVector<ControlState>(controls.size(), *own.arena);
    std::transform(controls.begin(), controls.end(), own.controls.begin(),
                   [](const DemandedAngle& angle) {
                     return angle.law ? start_control(*angle.law) : start_angle(angle.initial);
                   });
    parts_[i] = own.part_maker.cover("control", Mark::state, own.controls);
    own.saved.push_back(doubles(own.controls[0], own.controls.size()));
  }
}

bool PitchControllers::acts(const System<Space>& system) {
  return std::any_of(system.subsystems.begin(), system.subsystems.end(),
                     [](const Subsystem<Space>& subsystem) { return !subsystem.controls.empty(); });
}

void PitchControllers::list_courses(int i, PartList& parts) const {
  graph::add_to(parts, graph::maybe(parts_[static_cast<std::size_t>(i)]));
}

void PitchControllers::keep_values(std::size_t i, double t, double* into) const noexcept {
  for (const ControlState& control : data_.subsystems[i].controls) {
    const space::PrescribedMotion pitch = follow(control, t);
    for (const double value : {control.demands.back(), pitch.value, pitch.rate}) *into++ = value;
  }
}

std::vector<ActorColumn> PitchControllers::columns(ColumnPlace place) const {
  if (place != ColumnPlace::behind_joints ||
      std::none_of(system_.subsystems.begin(), system_.subsystems.end(), has_pitch))
    return {};
  return {{"control.pitch.demand", "rad"},
          {"control.pitch.angle", "rad"},
          {"control.pitch.rate", "rad/s"}};
}

void PitchControllers::append_values(ColumnPlace place, std::int64_t /*step*/,
                                     std::span<const double* const> kept,
                                     std::vector<double>& values) const {
  if (columns(place).empty()) return;
  const auto shown = std::find_if(system_.subsystems.begin(), system_.subsystems.end(), has_pitch);
  const double* const first = kept[static_cast<std::size_t>(shown - system_.subsystems.begin())];
  values.insert(values.end(), first, first + kValues);
}

/// Returns the part in which the speed of a hub is that a drive does not prescribe.
PartList PitchControllers::speed_inputs(int i) const {
  const int r = system_.subsystems[static_cast<std::size_t>(i)].rotor;
  if (is_hub_prescribed(system_, std::max(r, 0))) return {};
  if (r < 0) return {data_.parts.hub_coordinates};
  const SupportedRotor& rotor = system_.rotors[static_cast<std::size_t>(r)];
  return {data_.subsystems[static_cast<std::size_t>(rotor.subsystem)]
              .parts.bodies[static_cast<std::size_t>(rotor.body)]
              .coordinates};
}

/// Returns the speed of the hub about its axle at the end of a step, at time t [s], before the
/// nodes of the next step: against what carries the axle [rad/s].
double PitchControllers::hub_speed(std::size_t i, double t) const {
  const int r = system_.subsystems[i].rotor;
  if (is_hub_prescribed(system_, std::max(r, 0)))
    return calc_motion(drive_of(system_, std::max(r, 0)), t).speed;
  if (r < 0) return data_.hub_coordinates.v[Space::kAxial];
  const SupportedRotor& rotor = system_.rotors[static_cast<std::size_t>(r)];
  return data_.subsystems[static_cast<std::size_t>(rotor.subsystem)]
      .bodies[static_cast<std::size_t>(rotor.body)]
      .joint.coordinates.v[0];
}

/// Lets the controllers of a subsystem take their samples, if it is time for any, in steps of h
/// [s].
void PitchControllers::take_samples(std::size_t i, double h) const noexcept {
  SubsystemData<Space>& own = data_.subsystems[i];
  const StepProgress& progress = *own.progress;
  if (progress.control.is_between_steps() || progress.passes > 0) return;
  const std::int64_t before = progress.step - 1;
  const double t = static_cast<double>(before) * h;
  for (std::size_t k = 0; k < own.controls.size(); ++k) {
    if (own.controls[k].held != 0.0) continue;
    const PitchControl& control = *system_.subsystems[i].controls[k].law;
    const std::int64_t steps = count_sample_steps(control.period, h);
    if (before % steps == 0)
      take_sample(control, hub_speed(i, t), t, static_cast<double>(steps) * h, before == 0,
                  own.controls[k]);
  }
}

void PitchControllers::add_nodes(const PassNodes& pass, PassPlace place, int i) const {
  const auto index = static_cast<std::size_t>(i);
  const graph::PartId part = parts_[index];
  if (place != PassPlace::before_motion || !has_law(system_.subsystems[index])) return;
  const SubsystemData<Space>& own = data_.subsystems[index];
  pass.builder.add_node(pass.label(stage(), i), graph::reads(own.parts.progress, speed_inputs(i)),
                        graph::updates(part),
                        unless_halted(*own.progress, [this, index, h = pass.step]() noexcept {
                          take_samples(index, h);
                        }));
}

}  // namespace spoke
