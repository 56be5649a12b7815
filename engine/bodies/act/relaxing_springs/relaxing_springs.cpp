// Lists the springs of joints, and takes their states over steps.

#include "engine/bodies/act/relaxing_springs/relaxing_springs.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/bodies/kernels/space/table_terms.h"

namespace spoke {

RelaxingSprings::RelaxingSprings(const System<Space>& system, StepData<Space>& data)
    : system_(system), data_(data), subsystems_(system.subsystems.size()) {
  for (std::size_t i = 0; i < subsystems_.size(); ++i) {
    SubsystemData<Space>& own = data.subsystems[i];
    auto made = std::make_unique<Springs>();
    for (std::size_t j = 0; j < own.bodies.size(); ++j)
      for (const space::RelaxingSpring& law : own.bodies[j].model->joint.course.relaxing)
        made->springs.push_back({j, law});
    if (made->springs.empty()) continue;
    made->efforts = ArenaVector<space::JointEffort>(made->springs.size(), *own.arena);
    for (std::size_t k = 0; k < made->springs.size(); ++k)
      own.bodies[made->springs[k].body].joint.added.push_back(
          {made->springs[k].law.coordinate, &made->efforts[k]});
    made->part = own.part_maker.cover("relaxing springs", Mark::none, made->efforts);
    made->states = &add_states("relaxation", 2 * made->springs.size(), own);
    own.saved.push_back(doubles(made->efforts[0], made->efforts.size()));  // energies show them
    subsystems_[i] = std::move(made);
  }
}

bool RelaxingSprings::acts(const System<Space>& system) {
  const auto has_any = [](const TreeBody<Space>& body) {
    return !body.joint.course.relaxing.empty();
  };
  return std::any_of(
      system.subsystems.begin(), system.subsystems.end(), [&](const Subsystem<Space>& subsystem) {
        return std::any_of(subsystem.bodies.begin(), subsystem.bodies.end(), has_any);
      });
}

void RelaxingSprings::add_nodes(const PassNodes& pass, PassPlace place, int i) const {
  const auto index = static_cast<std::size_t>(i);
  if (place != PassPlace::on_motion || !subsystems_[index]) return;
  const Springs& own = *subsystems_[index];
  const SubsystemData<Space>& data = data_.subsystems[index];
  PartList motion{data.parts.progress};
  for (const Spring& spring : own.springs)
    if (data.bodies[spring.body].model->joint.slide)
      graph::add_to(motion, parts_of_slide(spring.body, data));
    else
      motion.push_back(data.parts.bodies[spring.body].coordinates);
  const StepProgress& progress = *data.progress;
  pass.builder.add_node(pass.label(stage(), i), graph::reads(motion, own.states->kept_part),
                        graph::writes(own.part, own.states->reached_part),
                        unless_halted(progress, [this, &progress, index, h = pass.step]() noexcept {
                          const bool is_between = progress.control.is_between_steps();
                          const double begin =
                              static_cast<double>(progress.step - (is_between ? 0 : 1)) * h;
                          evaluate(index, std::max(0.0, progress.control.time - begin));
                        }));
}

void RelaxingSprings::list_parts_on(int i, int j, PartList& parts) const {
  const Springs* const own = subsystems_[static_cast<std::size_t>(i)].get();
  if (own && !data_.subsystems[static_cast<std::size_t>(i)]
                  .bodies[static_cast<std::size_t>(j)]
                  .joint.added.empty())
    parts.push_back(own->part);
}

void RelaxingSprings::list_shown(int i, PartList& parts) const {
  if (const Springs* const own = subsystems_[static_cast<std::size_t>(i)].get())
    parts.push_back(own->part);
}

void RelaxingSprings::advance(std::size_t i, double elapsed) noexcept {
  if (subsystems_[i]) evaluate(i, elapsed);
}

void RelaxingSprings::list_relaxing(std::size_t i, std::vector<RelaxingState>& list) const {
  if (!subsystems_[i]) return;
  const Springs& own = *subsystems_[i];
  for (std::size_t k = 0; k < own.springs.size(); ++k) {
    const Spring& spring = own.springs[k];
    list.push_back({own.states, 2 * k, static_cast<int>(spring.body), spring.law.coordinate,
                    spring.law.stiffness, spring.law.time});
  }
}

double RelaxingSprings::coordinate_of(std::size_t i, const Spring& spring) const noexcept {
  const SubsystemData<Space>& data = data_.subsystems[i];
  const BodyData<Space>& body = data.bodies[spring.body];
  const double q = body.joint.coordinates.q[spring.law.coordinate];
  const auto& slide = body.model->joint.slide;
  if (!slide || slide->coordinate != spring.law.coordinate) return q;
  return q + calc_slide_shift(data, spring.body).shift;
}

void RelaxingSprings::evaluate(std::size_t i, double elapsed) const noexcept {
  assert(elapsed >= 0.0);
  Springs& own = *subsystems_[i];
  StatePair& states = *own.states;
  for (std::size_t k = 0; k < own.springs.size(); ++k) {
    const space::RelaxingSpring& law = own.springs[k].law;
    const double q = coordinate_of(i, own.springs[k]);
    const double x = elapsed / law.time;
    const double tangent = law.stiffness * (x > 0.0 ? -std::expm1(-x) / x : 1.0);
    const double z = states.has_begun() ? std::exp(-x) * states.kept[2 * k] +
                                              tangent * (q - states.kept[2 * k + 1])
                                        : 0.0;
    states.reached[2 * k] = z;
    states.reached[2 * k + 1] = q;
    own.efforts[k] = {-z, tangent, 0.5 * z * z / law.stiffness, z * z / (law.stiffness * law.time)};
  }
  states.reached.back() = 1.0;
}

}  // namespace spoke
