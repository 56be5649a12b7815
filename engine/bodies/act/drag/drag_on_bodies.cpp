// Places drag, and resolves its forces in the frames of the bodies.

#include "engine/bodies/act/drag/drag_on_bodies.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/act/marker_parts.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/marker_motion.h"
#include "engine/bodies/kernels/wind_at.h"
#include "engine/bodies/table/body_kind.h"

namespace spoke {

DragOnBodies::DragOnBodies(const System<Space>& system, StepData<Space>& data)
    : system_(system), data_(data), subsystems_(system.subsystems.size()) {
  assert(system.wind || !acts(system));
  for (std::size_t i = 0; i < subsystems_.size(); ++i)
    if (system.subsystems[i].drag) place_on(i, data.subsystems[i]);
}

bool DragOnBodies::acts(const System<Space>& system) {
  return std::any_of(system.subsystems.begin(), system.subsystems.end(),
                     [](const Subsystem<Space>& subsystem) { return subsystem.drag != nullptr; });
}

void DragOnBodies::place_on(std::size_t i, SubsystemData<Space>& own) {
  const DragModel& model = *system_.subsystems[i].drag;
  subsystems_[i] = std::make_unique<Drag>();
  Drag& made = *subsystems_[i];
  const auto body_of = [&own](int j) -> const space::Body& {
    return *own.bodies[static_cast<std::size_t>(j)].model->body;
  };
  const int subsystem = static_cast<int>(i);
  for (const DragModel::Stretch& stretch : model.stretches) {
    const space::Body& body = body_of(stretch.body);
    made.markers.push_back(
        {subsystem, stretch.body, kind_of(body).section_at(body, stretch.station)});
    made.areas.emplace_back(0.0, stretch.across, stretch.across);
    made.is_beam.push_back(true);
  }
  for (const DragModel::Block& block : model.blocks) {
    made.markers.push_back({subsystem, block.body, space::make_rigid_section(block.point)});
    made.areas.push_back(block.area);
    made.is_beam.push_back(false);
  }
  made.wrenches = ArenaVector<SectionWrench<Space>>(made.markers.size(), *own.arena);
  made.part = own.part_maker.cover("drag", Mark::none, made.wrenches);
  made.motions.resize(made.markers.size());
  made.sections.resize(made.markers.size());
  for (std::size_t k = 0; k < made.markers.size(); ++k)
    own.bodies[static_cast<std::size_t>(made.markers[k].body)].applied.push_back(
        {&made.markers[k].section, &made.wrenches[k], &made.sections[k]});
}

void DragOnBodies::add_nodes(const PassNodes& pass, PassPlace place, int i) const {
  const auto index = static_cast<std::size_t>(i);
  if (place != PassPlace::on_motion || !subsystems_[index]) return;
  const Drag& own = *subsystems_[index];
  const StepProgress& progress = *data_.subsystems[index].progress;
  pass.builder.add_node(
      pass.label(stage(), i), graph::reads(marker_inputs(data_, {i}, own.markers)),
      graph::writes(own.part), unless_halted(progress, [this, &progress, index]() noexcept {
        evaluate(index, progress.control.time);
      }));
}

void DragOnBodies::list_parts_on(int i, int j, PartList& parts) const {
  const Drag* const own = subsystems_[static_cast<std::size_t>(i)].get();
  if (own && std::any_of(own->markers.begin(), own->markers.end(),
                         [j](const PlacedMarker<Space>& marker) { return marker.body == j; }))
    parts.push_back(own->part);
}

void DragOnBodies::evaluate(std::size_t i, double t) const noexcept {
  Drag& own = *subsystems_[i];
  const Subsystem<Space>& subsystem = system_.subsystems[i];
  const SubsystemData<Space>& data = data_.subsystems[i];
  calc_load_motions(subsystem, data, own.markers, own.motions, own.sections);
  const double half_density = 0.5 * subsystem.drag->density;
  space::Rotation to_body;
  for (std::size_t k = 0; k < own.markers.size(); ++k) {
    const MarkerMotion& motion = own.motions[k];
    const int body = own.markers[k].body;
    if (k == 0 || body != own.markers[k - 1].body)
      to_body = (data.hub->R * calc_rotation_to_hub(subsystem, data, body)).inverse();
    const Eigen::Vector3d wind = find_wind(*system_.wind, motion.position, t);
    Eigen::Vector3d v = motion.rotation.transpose() * (wind - motion.velocity);
    if (own.is_beam[k]) v.x() = 0.0;
    const Eigen::Vector3d force = half_density * v.norm() * own.areas[k].cwiseProduct(v);
    own.wrenches[k] = {to_body * space::Position(motion.rotation * force),
                       space::Angular(space::Angular::Zero())};
  }
}

}  // namespace spoke
