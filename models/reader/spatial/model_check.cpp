// Visits every structure of a model in space.

#include "models/reader/spatial/model_check.h"

#include <set>
#include <vector>

#include "models/air/wind_kept.h"
#include "models/reader/damping.h"
#include "models/reader/loop_faults.h"
#include "models/reader/spatial/coupling_faults.h"
#include "models/reader/spatial/event_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/loop_ends.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/solid/kept_geometry.h"
#include "models/tree/axle_carrier.h"
#include "spoke/error.h"

namespace spoke::spatial {
namespace {

void require(const Fault& fault) {
  if (fault)
    throw InputError(fault.path + (fault.path.empty() ? "" : ": ") + fault.text,
                     {.key = fault.path});
}

template <class Items, class Find>
void check_each(const std::string& key, const Items& items, const Find& find) {
  std::size_t number = 0;
  for (const auto& item : items) require(find(item).within(key + '.' + std::to_string(++number)));
}

/// Checks that the support and its tree are given together.
void check_support(const Model& model) {
  for (std::size_t i = 0; i < model.subsystems.size(); ++i) {
    const bool is_last = i + 1 == model.subsystems.size();
    if (model.subsystems[i].name != kSupportName || (model.support && is_last)) continue;
    require({"subsystem." + std::to_string(i + 1) + ".name",
             "is \"support\", which is the name of the support's tree, the last of the subsystems; "
             "expected another one"});
  }
  if (!model.support) return;
  if (model.subsystems.empty() || model.subsystems.back().name != kSupportName)
    require({"support",
             "has no tree, expected one by the name \"support\" as the last of the subsystems"});
  require(find_carried_fault(model));
  require(find_fault(*model.support, model.subsystems.back()).within("support"));
}

/// Checks the rotors besides the first, and the numbers of rotors that carry something. The support
/// is checked.
void check_rotors(const Model& model) {
  const Count numbers{0, count_rotors(model) - 1};
  const auto check_numbers = [&](const std::string& key, const auto& items) {
    check_each(key, items, [&](const auto& item) {
      const FirstFault first;
      first("rotor", item.rotor, numbers, Presence::required);
      return first.found();
    });
  };
  check_numbers("blades", model.blades);
  check_numbers("subsystem", model.subsystems);
  check_numbers("hub_load", model.hub_loads);
  check_numbers("anchor", model.anchors);
  require(find_rotors_fault(model));
}

/// Checks a subsystem, whose name is to be unlike those before it, and its loops.
Fault find_tree_fault(const Subsystem& subsystem, const Model& model,
                      std::set<std::string>& names) {
  if (!names.insert(subsystem.name).second)
    return {"name", "is \"" + subsystem.name + "\" as another subsystem's, expected its own"};
  if (Fault fault = find_fault(subsystem, base_of(subsystem, model))) return fault;
  if (Fault fault = find_fault(subsystem.loops, surroundings_of(subsystem, model))) return fault;
  return find_fault(subsystem.couplings, ends_of(subsystem, model));
}

void read_wind_file(Wind& wind) {
  try {
    air::keep_wind(wind);
  } catch (const InputError& error) {
    if (air::is_of_wind_file(error)) throw;
    require(Fault{error.place().key, error.what()}.within("wind"));
  }
}

}  // namespace

void read_model_files(Model& model) {
  if (model.air) read_wind_file(model.air->wind);
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    for (std::size_t j = 0; j < model.subsystems[i].bodies.size(); ++j) {
      auto* solid = std::get_if<SolidBody>(&model.subsystems[i].bodies[j].shape);
      if (!solid) continue;
      const std::string key = key_of_subsystem(model, i) + ".body." + std::to_string(j + 1);
      require(find_description_fault(*solid).within(key));
      try {
        solid::keep_geometry(*solid);
      } catch (const InputError& error) {
        if (solid::is_of_mesh(error)) throw;
        require(Fault{error.place().key, error.what()}.within(key));
      }
    }
}

void check_model(const Model& model) {
  require(find_fault(model.hub).within("hub"));
  check_support(model);
  check_rotors(model);
  std::vector<Anchor> anchors;
  check_each("anchor", model.anchors, [&](const Anchor& anchor) {
    Fault fault = find_fault(anchor, anchors, find_mount_fault(model), false);
    anchors.push_back(anchor);
    return fault;
  });
  require(find_axle_frame_fault(model));
  check_each("blades", model.blades, [&](const Blade& blade) {
    if (Fault fault = find_fault(blade)) return fault;
    if (Fault fault = find_fault(blade.loops, surroundings_of(blade, model))) return fault;
    return find_fault(blade.couplings, ends_of(blade, find_rotors_on(model, blade), model));
  });
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    require(find_tree_fault(model.subsystems[i], model, names).within(key_of_subsystem(model, i)));
  require(find_loop_end_fault(model));
  require(find_coupling_across_fault(model));
  if (model.blades.empty() && model.subsystems.empty() && !moves_alone(model.hub))
    require({"blades", "there are none, and no subsystem; expected one or more"});
  require({"blades", find_size_fault(model)});
  const FirstFault first;
  first("gravity.acceleration", model.gravity, kGravity, Presence::optional);
  first("gravity.ramp", model.gravity_ramp, kRamp);
  find_range_faults("damping.", keys::kDampingRows, model.damping, first);
  require(first.found());
  const DampingFault damping = find_damping_fault(model.damping, DampedBeams(model));
  if (!damping.text.empty()) require({"damping." + damping.key, damping.text});
  require({"damping.mass_factor", find_mass_factor_fault(model)});
  const auto of_load = [&](const auto& load) { return find_fault(load, model); };
  check_each("load", model.loads, of_load);
  check_each("distributed_load", model.distributed_loads, of_load);
  check_each("hub_load", model.hub_loads, of_load);
  if (model.air) require(find_fault(*model.air, model));
  if (model.pitch_control) require(find_fault(*model.pitch_control, model).within("control.pitch"));
  if (model.outer_control) {
    const std::string table(model.outer_control->table());
    require(find_fault(*model.outer_control, model).within(table));
    if (model.pitch_control)
      require({table, "given along with control.pitch, expected only one of them"});
  }
  require(find_events_fault(model));
}

}  // namespace spoke::spatial
