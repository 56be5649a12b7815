// Reads [support] in two steps: blades know that there is one, and its tree comes after theirs.

#include "models/reader/spatial/support_reader.h"

#include <algorithm>

#include "models/reader/names.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/body_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/vector_reader.h"
#include "models/tree/axle_carrier.h"

namespace spoke::spatial {
namespace {

/// Reads six numbers, one for each direction.
void read_directions(const TomlSection& section, std::string_view key, std::string_view unit,
                     std::array<double, 6>& values) {
  const std::vector<double> read = section.numbers(key, Quantity::not_negative(unit), 6);
  std::copy(read.begin(), read.end(), values.begin());
}

}  // namespace

namespace {

TomlSection axle_section(const TomlSection& owner) {
  return owner.section("axle", keys::keys_of(keys::kAxleRows, keys::kDriveTrainRows));
}

}  // namespace

std::string read_axle_carrier(const TomlSection& owner) {
  const TomlSection section = axle_section(owner);
  if (section.has("blade")) {
    if (section.has("subsystem"))
      section.fail("blade", "given along with subsystem, expected only one of them");
    return name_of_blade(static_cast<std::size_t>(section.integer("blade", {1, kMostOfAKind})));
  }
  const std::string name = section.text("subsystem", "");
  // Blades are named by their numbers alone.
  if (!name.empty() && !is_name(name))
    section.fail("subsystem", "is \"" + name + "\", expected " + kNameExpected);
  return name;
}

Axle read_axle(const TomlSection& owner, const Subsystem& tree, SupportBase from) {
  const TomlSection section = axle_section(owner);
  Axle axle;
  axle.subsystem = read_axle_carrier(owner);
  axle.body = section.text("body", "");
  if (!section.has("body") && !tree.bodies.empty() && find_blade_of(axle) == 0)
    section.fail("body", "is missing, expected the name of the body that carries the axle");
  axle.station = read_station(section, tree, axle.body);
  axle.interface = section.text("interface", "");
  keys::read(section, keys::kAxleRows, &axle);
  const TomlSection::Keys of_train = keys::keys_of(keys::kDriveTrainRows);
  if (std::any_of(of_train.begin(), of_train.end(),
                  [&section](std::string_view key) { return section.has(key); }))
    keys::read(section, keys::kDriveTrainRows, &axle.train.emplace());
  if (from == SupportBase::free && axle.subsystem.empty() && axle.body == base_name(from))
    axle.body.clear();
  return axle;
}

TomlSection support_section(const TomlSection& root) {
  return root.section(kSupportName, keys::keys_of(keys::kSupportRows, keys::kFuselageRows,
                                                  keys::kTreeRows, keys::kSupportAxleRows));
}

Support read_base(const TomlSection& section) {
  Support support;
  keys::read(section, keys::kSupportRows, &support);
  if (support.from == SupportBase::ground) {
    for (const std::string_view key : keys::keys_of(keys::kFuselageRows))
      if (section.has(key))
        section.fail(key, "belongs to a fuselage, expected only with from = \"free\"");
    return support;
  }
  keys::read(section, keys::kFuselageRows, &support.fuselage);
  support.fuselage.inertia = read_inertia(section, "inertia", MayBeZero::no);
  return support;
}

void read_support_tree(const TomlSection& section, const TomlSection& first,
                       const std::string& folder, Model& model) {
  Subsystem tree;
  tree.name = kSupportName;
  read_tree(section, model, folder, model.subsystems, tree);
  model.support->axle = read_axle(first, tree, model.support->from);
  if (const Fault fault = find_fault(*model.support, tree)) {
    const bool is_of_axle = fault.path == "axle" || fault.path.starts_with("axle.");
    (is_of_axle ? first : section).fail_at(fault.path, fault.text);
  }
  model.subsystems.push_back(std::move(tree));
}

TomlSection::Keys suspension_keys() { return keys::keys_of(keys::kSuspensionRows); }

Suspension read_suspension(const TomlSection& section) {
  Suspension suspension;
  read_directions(section, "stiffness", kBushingUnits.stiffness, suspension.stiffness);
  if (section.has("damping"))
    read_directions(section, "damping", kBushingUnits.damping, suspension.damping);
  keys::read(section, keys::kSuspensionRows, &suspension);
  suspension.inertia = read_inertia(section, "inertia", MayBeZero::no);
  if (const Fault fault = find_fault(suspension)) section.fail_at(fault.path, fault.text);
  return suspension;
}

}  // namespace spoke::spatial
