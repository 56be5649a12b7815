// Goes through the loads of a rotor in the plane or of a model in space.

#include "engine/small_motions/vibration/varied_load.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "models/error.h"
#include "models/reader/names.h"
#include "models/support/nearest_name.h"

namespace spoke::vibration {
namespace {

/// Visits all loads of a model, each with a name and a factor.
template <class Model, class Visit>
void visit_all_loads(Model& model, const Visit& visit) {
  for (auto& load : model.loads) visit(load);
  for (auto& load : model.distributed_loads) visit(load);
  for (auto& load : model.hub_loads) visit(load);
  if constexpr (requires { model.drags; })
    for (auto& drag : model.drags) visit(drag);
}

template <class OneScenario, class Visit>
void visit_loads(OneScenario& scenario, const Visit& visit) {
  if (scenario.space)
    visit_all_loads(*scenario.space, visit);
  else
    visit_all_loads(scenario.rotor, visit);
}

void require_gravity(const Scenario& scenario) {
  const bool is_zero =
      scenario.space ? scenario.space->gravity.isZero(0.0) : scenario.rotor.gravity.isZero(0.0);
  if (is_zero)
    throw InputError("gravity.acceleration: is 0, expected gravity, which a factor varies");
  const HubSupport support =
      scenario.space ? scenario.space->hub.support : scenario.rotor.hub.support;
  if (support == HubSupport::free)
    throw InputError(
        "gravity: everything falls alike where the hub is free, expected another load");
}

}  // namespace

void require_load(const Scenario& scenario, const std::string& name) {
  if (name == kGravityName) return require_gravity(scenario);
  std::vector<std::string_view> names{kGravityName};
  bool is_known = false, acts = false;
  visit_loads(scenario, [&](const auto& load) {
    if (!load.name.empty() && std::find(names.begin(), names.end(), load.name) == names.end())
      names.push_back(load.name);
    if (load.name != name) return;
    is_known = true;
    acts = acts || load.factor.values().back() != 0.0;
  });
  if (!is_known) throw InputError("the load " + describe_unknown(name, names));
  if (!acts)
    throw InputError("the load \"" + name +
                     "\" ends with a factor of 0, expected one that ends with another");
}

void multiply_load(const std::string& name, double factor, Scenario& scenario) {
  if (name == kGravityName) {
    if (scenario.space)
      scenario.space->gravity *= factor;
    else
      scenario.rotor.gravity *= factor;
    return;
  }
  visit_loads(scenario, [&](auto& load) {
    if (load.name != name) return;
    std::vector<double> values = load.factor.values();
    for (double& value : values) value *= factor;
    load.factor = Curve(load.factor.times(), values);
  });
}

}  // namespace spoke::vibration
