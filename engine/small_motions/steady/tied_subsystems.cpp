// Evaluates subsystems together that loops tie to one another.

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/small_motions/steady/steady_loops.h"
#include "engine/small_motions/steady/steady_system.h"
#include "engine/step/formulation/loops/shared_loops.h"
#include "engine/step/stages.h"

namespace spoke::steady {

template <class World>
std::vector<std::vector<std::size_t>> group_subsystems(const System<World>& system) {
  std::vector<std::size_t> first(system.subsystems.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto tie = [&first](int one, int other) {
    const std::size_t a = first[static_cast<std::size_t>(one)];
    const std::size_t b = first[static_cast<std::size_t>(other)];
    std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
  };
  for (const SharedLoop& loop : system.shared_loops)
    for (const LoopAt& end : loop.ends) tie(loop.own.subsystem, end.subsystem);
  for (int i = 0; std::cmp_less(i, first.size()); ++i)
    if (const int rotor = system.subsystems[static_cast<std::size_t>(i)].rotor; rotor >= 0)
      tie(i, system.rotors[static_cast<std::size_t>(rotor)].subsystem);
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) continue;
    std::vector<std::size_t>& group = groups.emplace_back();
    for (std::size_t k = i; k < first.size(); ++k)
      if (first[k] == i) group.push_back(k);
  }
  return groups;
}

namespace {

/// Returns members of a group, by their places in it, so that each is behind what carries it.
template <class World>
std::vector<std::size_t> order_outward(const std::vector<std::size_t>& group,
                                       const System<World>& system) {
  const auto level_of = [&system](std::size_t i) {
    int level = 0;
    for (int rotor = system.subsystems[i].rotor; rotor >= 0; ++level)
      rotor = system
                  .subsystems[static_cast<std::size_t>(
                      system.rotors[static_cast<std::size_t>(rotor)].subsystem)]
                  .rotor;
    return level;
  };
  std::vector<std::size_t> order(group.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return level_of(group[a]) < level_of(group[b]);
  });
  return order;
}

void place_rotors_on(const System<Plane>&, std::size_t, StepData<Plane>&) {}
void place_rotors_on(const System<Space>& system, std::size_t carrier, StepData<Space>& data) {
  for (const int rotor : find_rotors_on(system, static_cast<int>(carrier)))
    place_rotor(system, static_cast<std::size_t>(rotor), 0.0, false, data);
}

/// Hands the forces of shared loops from their own subsystems to the others that they visit.
template <class World>
void hand_out(const std::vector<std::size_t>& group, const System<World>& system,
              const StepData<World>& data, std::vector<SubsystemResponse>& responses) {
  const auto path_of = [&data](const LoopAt& at) {
    return data.subsystems[static_cast<std::size_t>(at.subsystem)]
        .loops.paths[static_cast<std::size_t>(at.loop)];
  };
  const auto forces_of = [&](const LoopAt& at) {
    const auto place =
        std::find(group.begin(), group.end(), static_cast<std::size_t>(at.subsystem));
    assert(place != group.end());
    return responses[static_cast<std::size_t>(place - group.begin())].multipliers.data() +
           path_of(at).first_row;
  };
  for (const SharedLoop& loop : system.shared_loops) {
    const auto own = static_cast<std::size_t>(loop.own.subsystem);
    if (std::find(group.begin(), group.end(), own) == group.end()) continue;
    for (const LoopAt& end : loop.ends)
      std::copy_n(forces_of(loop.own), path_of(loop.own).rows, forces_of(end));
  }
}

}  // namespace

template <class World>
void SteadySystem<World>::evaluate_tied(const std::vector<std::size_t>& group,
                                        const std::vector<SubsystemState>& states,
                                        const HubOffset& hub,
                                        std::vector<SubsystemResponse>& responses) {
  assert(states.size() == group.size());
  const System<World>& model = context_.system;
  const std::vector<std::size_t> outward = order_outward(group, model);
  responses.resize(group.size());
  for (const std::size_t m : outward) {
    calc_terms(group[m], states[m], hub);
    calc_frame_accelerations(model.subsystems[group[m]], data(group[m]));
    place_rotors_on(model, group[m], context_.data);
  }
  calc_shared_motion(model, 0.0, {}, context_.data);
  for (std::size_t m = 0; m < group.size(); ++m)
    put_loops(model, group[m], states[m], rows_[group[m]], context_.data, responses[m]);
  hand_out(group, model, context_.data, responses);
  std::vector<std::vector<CarriedWrench<World>>> carried(subsystems());
  for (auto at = outward.rbegin(); at != outward.rend(); ++at) {
    const std::size_t i = group[*at];
    sum_response(i, carried[i], responses[*at]);
    if (data(i).rotor < 0) continue;
    const SupportedRotor& rotor = model.rotors[static_cast<std::size_t>(data(i).rotor)];
    carried[static_cast<std::size_t>(rotor.subsystem)].push_back(
        {rotor.body, responses[*at].hub_force});
    responses[*at].hub_force.setZero();
  }
}

namespace {

void carry_rotors(bool, const System<Plane>&, StepData<Plane>&) {}
/// Lets the bodies that are hubs of rotors have the inertia that these condense to, or not.
void carry_rotors(bool do_they, const System<Space>& system, StepData<Space>& data) {
  for (std::size_t r = 0; r < system.rotors.size(); ++r) {
    SubsystemData<Space>& carrier =
        data.subsystems[static_cast<std::size_t>(system.rotors[r].subsystem)];
    carrier.bodies[static_cast<std::size_t>(system.rotors[r].body)].carried =
        do_they ? &data.rotors[r].carried : nullptr;
  }
}

}  // namespace

template <class World>
void SteadySystem<World>::hold_rotors() {
  carry_rotors(false, context_.system, context_.data);
}

template <class World>
std::vector<Eigen::VectorXd> SteadySystem<World>::accelerations_tied(
    const std::vector<std::size_t>& group) {
  std::vector<Eigen::VectorXd> found;
  if (!context_.data.is_coupled) {
    for (const std::size_t i : group) found.push_back(accelerations(i));
    return found;
  }
  carry_rotors(true, context_.system, context_.data);
  for (const graph::NodeId node : pass_) {
    const std::string& stage = graph_->node(node).label.stage;
    if (stage != stages::kHubSolve.name && stage != stages::kSupportSolve.name) {
      graph_->run_node(node);
      continue;
    }
    // The hub's motion is given.
    factorise_shared_loops(context_.system, context_.data);
    calc_shared_forces(context_.system, context_.data);
  }
  for (const std::size_t i : group) found.push_back(take_accelerations(i));
  hold_rotors();
  for (const std::size_t i : group)
    for (const graph::NodeId node : terms_[i]) graph_->run_node(node);
  return found;
}

template std::vector<std::vector<std::size_t>> group_subsystems(const System<Plane>&);
template void SteadySystem<Plane>::evaluate_tied(const std::vector<std::size_t>&,
                                                 const std::vector<SubsystemState>&,
                                                 const HubOffset&, std::vector<SubsystemResponse>&);
template std::vector<Eigen::VectorXd> SteadySystem<Plane>::accelerations_tied(
    const std::vector<std::size_t>&);
template void SteadySystem<Plane>::hold_rotors();
template std::vector<std::vector<std::size_t>> group_subsystems(const System<Space>&);
template void SteadySystem<Space>::evaluate_tied(const std::vector<std::size_t>&,
                                                 const std::vector<SubsystemState>&,
                                                 const HubOffset&, std::vector<SubsystemResponse>&);
template std::vector<Eigen::VectorXd> SteadySystem<Space>::accelerations_tied(
    const std::vector<std::size_t>&);
template void SteadySystem<Space>::hold_rotors();

}  // namespace spoke::steady
