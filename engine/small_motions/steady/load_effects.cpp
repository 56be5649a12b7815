// Lists the inputs of a scenario, and raises them one by one.

#include "engine/small_motions/steady/load_effects.h"

#include <functional>
#include <optional>
#include <utility>

#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/steady/subsystem_names.h"
#include "engine/small_motions/steady/supported_model.h"

namespace spoke::steady {
namespace {

using Eigen::VectorXd;

/// An input, and a function that raises it by one in a scenario.
struct Input {
  std::string name;
  std::string unit;
  std::function<void(Scenario&)> raise;
};

void raise(Curve& curve) {
  std::vector<double> values = curve.values();
  for (double& value : values) value += 1.0;
  curve = Curve(curve.times(), values);
}

/// Adds the inputs of a list of loads, which `find` takes from a scenario. `splits`: whether a load
/// on all blades is an input of each.
template <class Find>
void add_loads(const char* list, const Scenario& scenario, bool splits, const Find& find,
               std::vector<Input>& inputs) {
  const auto& loads = find(scenario);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const std::string name = list + ('.' + std::to_string(k + 1));
    if constexpr (requires { loads[k].place.blade; })
      if (splits && loads[k].place.subsystem.empty() && loads[k].place.blade.is_all()) {
        for (std::size_t b = 0; b < scenario.space->blades.size(); ++b)
          inputs.push_back({name, "1", [k, b, find](Scenario& other) {
                              auto own = find(other)[k];
                              own.place.blade = BladeChoice::number(static_cast<int>(b) + 1);
                              own.factor = Curve(1.0);
                              find(other).push_back(own);
                            }});
        continue;
      }
    inputs.push_back({name, "1", [k, find](Scenario& other) { raise(find(other)[k].factor); }});
  }
}

/// Adds the inputs of the lists of a rotor in the plane or of a model in space.
template <class Find>
void add_all_loads(const Scenario& scenario, bool splits, const Find& find,
                   std::vector<Input>& inputs) {
  add_loads(
      "load", scenario, splits, [find](auto& s) -> auto& { return find(s).loads; }, inputs);
  add_loads(
      "distributed_load", scenario,
      splits, [find](auto& s) -> auto& { return find(s).distributed_loads; }, inputs);
  add_loads(
      "hub_load", scenario, splits, [find](auto& s) -> auto& { return find(s).hub_loads; }, inputs);
}

/// Adds the motors of the free coordinates of a joint, which `find` takes from a scenario.
template <class Find>
void add_motors(const Scenario& scenario, const std::string& fallback, const Find& find,
                std::vector<Input>& inputs) {
  const spatial::Joint& joint = find(scenario);
  const int count = count_coordinates(joint.kind);
  const std::string name = joint.name.empty() ? fallback : joint.name;
  for (int c = 0; c < count; ++c) {
    const auto k = static_cast<std::size_t>(c);
    if (joint.coordinates[k].motion) continue;
    inputs.push_back({name + " motor" + (count > 1 ? ' ' + std::to_string(c + 1) : ""),
                      slides(joint.kind, c) ? "N" : "N m",
                      [k, find](Scenario& other) { raise(find(other).coordinates[k].effort); }});
  }
}

void add_all_motors(const Scenario& scenario, std::vector<Input>& inputs) {
  const spatial::Model& model = *scenario.space;
  for (std::size_t b = 0; b < model.blades.size(); ++b)
    for (std::size_t j = 0; j < model.blades[b].joints.size(); ++j)
      add_motors(
          scenario, "joint " + std::to_string(j + 1),
          [ b, j ](auto& s) -> auto& { return s.space->blades[b].joints[j].joint; }, inputs);
  for (std::size_t b = 0; b < model.subsystems.size(); ++b)
    for (std::size_t j = 0; j < model.subsystems[b].joints.size(); ++j)
      add_motors(
          scenario, "joint of " + model.subsystems[b].joints[j].child,
          [ b, j ](auto& s) -> auto& { return s.space->subsystems[b].joints[j].joint; }, inputs);
}

/// `splits`: see add_loads().
std::vector<Input> list_inputs(const Scenario& scenario, bool splits) {
  std::vector<Input> inputs;
  if (scenario.space) {
    add_all_loads(
        scenario, splits, [](auto& s) -> auto& { return *s.space; }, inputs);
    add_all_motors(scenario, inputs);
  } else {
    add_all_loads(
        scenario, false, [](auto& s) -> auto& { return s.rotor; }, inputs);
  }
  return inputs;
}

/// Whether a subsystem is several of the scenario.
bool ties_any(SteadyModel& model) {
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    if (model.members(i).size() > 1) return true;
  return false;
}

/// Returns forces and outputs of a subsystem at its equilibrium.
LoadEffect answer(std::size_t subsystem, const SubsystemState& state, SteadyModel& model) {
  SubsystemResponse response;
  model.evaluate(subsystem, state, model.no_offset(), response);
  return {
      {}, response.force, response.hub_force, measure(subsystem, state, model.no_offset(), model)};
}

bool does_nothing(const LoadEffect& effect) {
  return effect.force.isZero(0.0) && effect.hub_force.isZero(0.0) && effect.outputs.isZero(0.0);
}

/// Returns the options of a model whose hubs turn as those of `model`.
SteadyOptions turn_like(const SteadyModel& model) {
  SteadyOptions options{.speed = model.speed(), .has_outputs = true};
  for (std::size_t h = 1; h < model.hubs(); ++h)
    options.further_speeds.push_back(model.rotor(h).speed());
  return options;
}

/// Makes the model of a scenario that stands like `model`; with an azimuth as it is there, with all
/// parts of its loads.
std::unique_ptr<SteadyModel> make_like(const SteadyModel& model, const Scenario& scenario,
                                       std::optional<double> azimuth) {
  SteadyOptions options = turn_like(model);
  options.is_whole = azimuth.has_value();
  std::unique_ptr<SteadyModel> made = make_steady_model(scenario, options);
  if (SupportedModel* machine = made->on_support()) {
    machine->stand_like(*model.on_support());
    if (azimuth) machine->turn_rotors(*azimuth);
  } else if (azimuth) {
    made->move_hub(*azimuth, 0.0, 0.0);
  }
  return made;
}

/// What a model exerts and shows at an equilibrium.
struct Answers {
  std::vector<LoadEffect> subsystems;
  std::vector<VectorXd> hubs;
};
Answers answer_all(const Equilibrium& equilibrium, const SteadyModel& settled, SteadyModel& model) {
  Answers answers;
  for (std::size_t i = 0; i < model.subsystems(); ++i) {
    if (&model != &settled) model.settle_at(i, settled.absolute(i, equilibrium.q[i]));
    answers.subsystems.push_back(answer(i, make_state(equilibrium.q[i]), model));
  }
  for (std::size_t h = 0; h < model.hubs(); ++h)
    answers.hubs.push_back(model.rotor(h).hub_force(model.no_offset()));
  return answers;
}

/// Returns what each input changes of the answers of `base`.
std::vector<InputEffect> calc_effects(const Scenario& scenario, const Equilibrium& equilibrium,
                                      const SteadyModel& settled, SteadyModel& base,
                                      std::optional<double> azimuth) {
  const Answers steady = answer_all(equilibrium, settled, base);
  std::vector<InputEffect> effects;
  for (const Input& input : list_inputs(scenario, ties_any(base))) {
    Scenario raised = scenario;
    input.raise(raised);
    const std::unique_ptr<SteadyModel> more = make_like(settled, raised, azimuth);
    Answers changed = answer_all(equilibrium, settled, *more);
    for (std::size_t i = 0; i < changed.subsystems.size(); ++i) {
      LoadEffect& effect = changed.subsystems[i];
      effect.force -= steady.subsystems[i].force;
      effect.hub_force -= steady.subsystems[i].hub_force;
      effect.outputs -= steady.subsystems[i].outputs;
    }
    for (std::size_t h = 0; h < changed.hubs.size(); ++h) changed.hubs[h] -= steady.hubs[h];
    effects.push_back(
        {{input.name, input.unit}, std::move(changed.subsystems), std::move(changed.hubs)});
  }
  return effects;
}

/// Returns the name of a subsystem; of one that is several of the scenario those on which an effect
/// has forces.
std::string name_loaded(std::size_t subsystem, const LoadEffect& effect, SteadyModel& model) {
  constexpr double kRoundOff = 1e-9;  // of what ties hand over
  std::vector<std::string> names;
  if (effect.force.size() > 0)
    for (const SubsystemPart& part : model.members(subsystem))
      if (part.part_of(effect.force).norm() > kRoundOff * effect.force.norm())
        names.push_back(part.model->name_of(part.subsystem));
  return names.empty() ? model.name_of(subsystem) : join_names(names);
}

}  // namespace

LoadEffects calc_load_effects(const Scenario& scenario, const Equilibrium& equilibrium,
                              SteadyModel& model) {
  LoadEffects effects;
  effects.subsystems.resize(model.subsystems());
  effects.hubs.resize(model.hubs());
  for (InputEffect& by : calc_effects(scenario, equilibrium, model, model, std::nullopt)) {
    for (std::size_t i = 0; i < model.subsystems(); ++i) {
      LoadEffect& effect = by.subsystems[i];
      if (does_nothing(effect)) continue;
      effect.input = {name_loaded(i, effect, model) + " / " + by.input.name, by.input.unit};
      effects.subsystems[i].push_back(std::move(effect));
    }
    for (std::size_t h = 0; h < model.hubs(); ++h)
      if (!by.hubs[h].isZero(0.0))
        effects.hubs[h].push_back(
            {{model.prefix_of(h) + "hub / " + by.input.name, by.input.unit}, {}, by.hubs[h], {}});
  }
  return effects;
}

std::vector<InputEffect> calc_effects_at(double azimuth, const Scenario& scenario,
                                         const Equilibrium& equilibrium, SteadyModel& model) {
  const std::unique_ptr<SteadyModel> base = make_like(model, scenario, azimuth);
  return calc_effects(scenario, equilibrium, model, *base, azimuth);
}

}  // namespace spoke::steady
