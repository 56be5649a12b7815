// Reads the tables of a model in space that are not its bodies.

#include "models/reader/spatial/model_reader.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "models/reader/blade_choice_reader.h"
#include "models/reader/damping.h"
#include "models/reader/loop_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/scenario_loads.h"
#include "models/reader/scenario_rotor.h"
#include "models/reader/spatial/air_reader.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/control_reader.h"
#include "models/reader/spatial/coupling_faults.h"
#include "models/reader/spatial/event_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/loop_ends.h"
#include "models/reader/spatial/solid_reader.h"
#include "models/reader/spatial/support_reader.h"
#include "models/reader/spatial/vector_reader.h"
#include "models/scenario.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

/// Returns the table of a hub: of the root's, or of a rotor's.
TomlSection hub_section(const TomlSection& owner) {
  return owner.section("hub", keys::keys_of(keys::kSpaceHubRows));
}

/// Returns the tables [[rotor]]; none where there is the short form of one rotor.
std::vector<TomlSection> rotor_sections(const TomlSection& root) {
  std::vector<TomlSection> rotors = root.sections("rotor", keys::keys_of(keys::kRotorRows));
  if (rotors.empty()) return rotors;
  for (const char* key : {"hub", "blade", "blades"})
    if (root.has(key)) root.fail(key, "given along with [[rotor]], expected only one of them");
  if (!root.has(kSupportName))
    root.fail("rotor", "is given without [support], which carries the axles");
  if (const TomlSection support = support_section(root); support.has("axle"))
    support.fail("axle", "given along with [[rotor]], expected [rotor.axle]");
  return rotors;
}

Hub read_hub(const TomlSection& section) {
  Hub hub;
  keys::read(section, keys::kSpaceHubRows, &hub);
  const bool is_free = hub.support == HubSupport::free;
  if (is_free || section.has("inertia"))
    hub.inertia = read_inertia(section, "inertia", MayBeZero::no);
  if (!is_free || section.has("drive")) hub.drive = read_drive(section);
  if (section.has("mount")) {
    const TomlSection mount = section.section("mount", keys::keys_of(keys::kMountRows));
    if (!mount.has("translation") && !mount.has("rotation"))
      mount.fail("", "has neither translation nor rotation, expected at least one of them");
    hub.mount =
        MountMotion{read_course(mount, "translation", "m"), read_course(mount, "rotation", "rad")};
  }
  if (const Fault fault = find_fault(hub)) section.fail_at(fault.path, fault.text);
  return hub;
}

/// Reads the names of the rotors, and the hubs of all but the first.
void read_other_rotors(const std::vector<TomlSection>& rotors, Model& model) {
  for (std::size_t r = 0; r < rotors.size(); ++r) {
    Hub& hub = r == 0 ? model.hub : model.rotors.emplace_back().hub;
    if (r > 0) {
      const TomlSection section = hub_section(rotors[r]);
      if (section.has("suspension"))
        section.fail("suspension", "given along with [support], expected only one of them");
      hub = read_hub(section);
      // Before the subsystems, whose couplings may be on axles.
      std::string& carrier = model.rotors.back().axle.subsystem;
      if (rotors[r].has("axle")) carrier = read_axle_carrier(rotors[r]);
      // Such a hub may be but a place, to which the default of others would add.
      if (!carrier.empty() && !section.has("inertia"))
        section.fail("inertia",
                     "is missing, expected that of a hub on a subsystem (kg m^2); of one that is "
                     "but a place next to none, as 1e-6");
    }
    hub.name = read_name(rotors[r], "name");
    for (int before = 0; std::cmp_less(before, r); ++before)
      if (hub_of(model, before).name == hub.name)
        rotors[r].fail("name",
                       "is \"" + hub.name + "\" as another rotor's, expected a name of its own");
  }
}

/// Reads what carries the hub's axle, but for the tree of [support].
void read_support_base(const TomlSection& root, const TomlSection& hub, Model& model) {
  const bool is_suspended = hub.has("suspension");
  if (is_suspended && root.has(kSupportName))
    hub.fail("suspension", "given along with [support], expected only one of them");
  if (is_suspended)
    suspend(read_suspension(hub.section("suspension", suspension_keys())), model);
  else if (root.has(kSupportName))
    model.support = read_base(support_section(root));
}

/// Reads the trees of bodies that are no blades; that of the support is the last.
void read_trees(const TomlSection& root, const std::vector<TomlSection>& rotors,
                const std::string& folder, Model& model) {
  std::vector<Subsystem> suspension = std::move(model.subsystems);
  model.subsystems = read_subsystems(root, model, folder);
  std::move(suspension.begin(), suspension.end(), std::back_inserter(model.subsystems));
  if (root.has(kSupportName)) {
    const TomlSection support = support_section(root);
    read_support_tree(support, rotors.empty() ? support : rotors.front(), folder, model);
  }
  if (!model.support) return;
  for (std::size_t r = 1; r < rotors.size(); ++r) {
    Axle& axle = model.rotors[r - 1].axle;
    const Subsystem* tree = &model.subsystems.back();
    for (const Subsystem& subsystem : model.subsystems)
      if (subsystem.name == axle.subsystem) tree = &subsystem;
    axle = read_axle(rotors[r], *tree, model.support->from);
  }
  if (const Fault fault = find_carried_fault(model))
    (rotors.empty() || fault.path.starts_with(kSupportName) ? root : rotors.front())
        .fail_at(fault.path, fault.text);
  if (const Fault fault = find_rotors_fault(model)) root.fail_at(fault.path, fault.text);
}

LoadPlace read_place(const TomlSection& section, const Model& model) {
  LoadPlace place;
  place.subsystem = section.text("subsystem", "");
  place.body = section.text("body", "");
  if (section.has("subsystem") && section.has("blade"))
    section.fail("blade", "given along with subsystem, expected only one of them");
  if (!section.has("subsystem") && !model.blades.empty())
    place.blade = read_blade(section, model.blades.size());
  return place;
}

void require_one(const TomlSection& section, std::string_view first, std::string_view second) {
  if (section.has(first) || section.has(second)) return;
  section.fail("", "has neither " + std::string(first) + " nor " + std::string(second) +
                       ", expected one of them as [x, y, z]");
}

template <class Load>
void finish_load(const TomlSection& section, const Model& model, Load& load) {
  keys::read(section, rows_of(load), &load);
  keys::read(section, keys::kLoadCourseRows<Load>, &load);
  load.factor = read_factor(section);
  load.name = read_load_name(section);
  if (const Fault fault = find_fault(load, model)) section.fail_at(fault.path, fault.text);
}

/// Adds a load to all subsystems that its place stands for.
template <class Load>
void add_load(const TomlSection& root, const TomlSection& section, const Model& model, Load load,
              std::vector<Load>& loads) {
  const std::vector<std::string> names = find_copies(root, load.place.subsystem);
  load.place.subsystem = names.front();
  finish_load(section, model, load);
  for (const std::string& name : names) {
    load.place.subsystem = name;
    loads.push_back(load);
  }
}

/// Throws the error of a loop that ends elsewhere.
[[noreturn]] void fail_at_end(const TomlSection& root, const std::vector<TomlSection>& rotors,
                              const Fault& fault) {
  // Blades that one table describes have its keys; those of several rotors are numbered through.
  const bool is_of_blade = fault.path.starts_with("blades.");
  const std::size_t behind = fault.path.find('.', sizeof("blades.") - 1);
  if (is_of_blade && !rotors.empty()) rotors.front().fail("", fault.path + ' ' + fault.text);
  if (is_of_blade && root.has("blade"))
    root.fail_at("blade" + fault.path.substr(behind), fault.text);
  root.fail_at(fault.path, fault.text);
}

void read_point_loads(const TomlSection& root, Model& model) {
  for (const TomlSection& section : root.sections(
           "load", keys::keys_of(keys::kLoadPlaceRows, keys::kSpacePointLoadRows,
                                 keys::kLoadNameRows, keys::kLoadCourseRows<PointLoad>))) {
    PointLoad load;
    if (!section.has("traction")) require_one(section, "force", "moment");
    load.place = read_place(section, model);
    if (section.has("position")) load.position = section.number("position", kStation);
    if (section.has("point")) load.point = read_vector(section, "point", kLength);
    load.interface = section.text("interface", "");
    if (section.has("nodes")) load.nodes = read_choice(section, "nodes");
    if (section.has("traction")) load.traction = read_vector(section, "traction", kTraction);
    add_load(root, section, model, std::move(load), model.loads);
  }
}

void read_distributed_loads(const TomlSection& root, Model& model) {
  for (const TomlSection& section :
       root.sections("distributed_load",
                     keys::keys_of(keys::kLoadPlaceRows, keys::kSpaceDistributedLoadRows,
                                   keys::kLoadNameRows, keys::kLoadCourseRows<DistributedLoad>))) {
    DistributedLoad load;
    require_one(section, "force_per_length", "moment_per_length");
    load.place = read_place(section, model);
    load.from = section.number("from", kStation, 0.0);
    if (section.has("to")) load.to = section.number("to", kStation);
    add_load(root, section, model, std::move(load), model.distributed_loads);
  }
}

void read_hub_loads(const TomlSection& root, Model& model) {
  for (const TomlSection& section :
       root.sections("hub_load", keys::keys_of(keys::kSpaceHubLoadRows, keys::kLoadNameRows,
                                               keys::kLoadCourseRows<HubLoad>))) {
    HubLoad load;
    load.rotor = read_rotor_of(section, model);
    require_one(section, "force", "torque");
    if (section.has("position") && !section.has("force"))
      section.fail("position", "would be ignored, expected only with \"force\"");
    finish_load(section, model, load);
    model.hub_loads.push_back(std::move(load));
  }
}

}  // namespace

int read_rotor_of(const TomlSection& section, const Model& model) {
  if (!section.has("rotor")) return 0;
  const std::string name = section.text("rotor", "");
  if (model.hub.name.empty())
    section.fail("rotor", "is \"" + name + "\", but there is no [[rotor]]");
  std::vector<std::string_view> names;
  for (int r = 0; r < count_rotors(model); ++r) {
    if (hub_of(model, r).name == name) return r;
    names.push_back(hub_of(model, r).name);
  }
  section.fail("rotor", describe_unknown(name, names));
}

Model read_model(const TomlSection& root, const std::string& folder) {
  Model model;
  const std::vector<TomlSection> rotors = rotor_sections(root);
  const TomlSection hub = hub_section(rotors.empty() ? root : rotors.front());
  model.hub = read_hub(hub);
  read_support_base(root, hub, model);
  read_other_rotors(rotors, model);
  model.anchors = read_anchors(root, find_mount_fault(model), [&model](const TomlSection& section) {
    return read_rotor_of(section, model);
  });
  if (const Fault fault = find_axle_frame_fault(model)) root.fail_at(fault.path, fault.text);
  if (rotors.empty()) model.blades = read_blades(root, 0, model);
  for (std::size_t r = 0; r < rotors.size(); ++r)
    for (Blade& blade : read_blades(rotors[r], static_cast<int>(r), model))
      model.blades.push_back(std::move(blade));
  resolve_next_blades(model);
  read_trees(root, rotors, folder, model);
  if (const Fault fault = find_anchor_body_fault(model)) root.fail_at(fault.path, fault.text);
  if (const Fault fault = find_loop_end_fault(model)) fail_at_end(root, rotors, fault);
  if (const Fault fault = find_coupling_across_fault(model)) fail_at_end(root, rotors, fault);
  if (model.blades.empty() && model.subsystems.empty() && !moves_alone(model.hub))
    root.fail("blade", "is missing, expected [blade], [[blades]] or [[subsystem]]");
  const std::string size_fault = find_size_fault(model);
  if (!size_fault.empty()) root.fail(root.has("blade") ? "blade" : "", size_fault);
  const TomlSection gravity = root.section("gravity", keys::keys_of(keys::kSpaceGravityRows));
  keys::read(gravity, keys::kSpaceGravityRows, &model);
  model.damping = read_damping(root, DampedBeams(model));
  const std::string damping_fault = find_mass_factor_fault(model);
  if (!damping_fault.empty()) root.fail_at("damping.mass_factor", damping_fault);
  read_point_loads(root, model);
  read_distributed_loads(root, model);
  read_hub_loads(root, model);
  model.air = read_air(root, folder, model);
  read_control(root, folder, model);
  model.events = read_events(root, model);
  return model;
}

}  // namespace spoke::spatial
