// Couplings of joints, by the rows of their keys.

#include "models/reader/spatial/coupling_reader.h"

#include "models/reader/keys/tree_keys.h"
#include "models/reader/loop_reader.h"
#include "models/reader/row_reader.h"
#include "models/reader/spatial/body_reader.h"

namespace spoke::spatial {
namespace {

constexpr int kMostCoordinates = 6;  // of any joint

CoupledJoint read_coupled_joint(const TomlSection& table) {
  CoupledJoint at;
  at.joint = read_name(table, "joint");
  read_elsewhere(table, at.blade, at.subsystem);
  if (table.has("coordinate")) at.coordinate = table.integer("coordinate", {1, kMostCoordinates});
  keys::read(table, keys::kCoupledJointRows, &at);
  return at;
}

}  // namespace

std::vector<Coupling> read_couplings(const TomlSection& parent) {
  std::vector<Coupling> couplings;
  for (const TomlSection& table : parent.sections("coupling", keys::keys_of(keys::kCouplingRows))) {
    Coupling& coupling = couplings.emplace_back();
    coupling.name = read_name(table, "name");
    for (const TomlSection& joint :
         table.sections("joints", keys::keys_of(keys::kCoupledJointRows)))
      coupling.joints.push_back(read_coupled_joint(joint));
    keys::read(table, keys::kCouplingRows, &coupling);
  }
  return couplings;
}

void add_couplings(const std::vector<Coupling>& couplings, Json& json) {
  for (const Coupling& coupling : couplings) {
    Json table = {{"name", coupling.name}};
    for (const CoupledJoint& at : coupling.joints) {
      Json joint = {{"joint", at.joint}, {"coordinate", at.coordinate}};
      if (at.blade > 0) joint.set("blade", at.blade);
      if (!at.subsystem.empty()) joint.set("subsystem", at.subsystem);
      keys::write(keys::kCoupledJointRows, &at, joint);
      table.append("joints", joint);
    }
    keys::write(keys::kCouplingRows, &coupling, table);
    json.append("coupling", table);
  }
}

}  // namespace spoke::spatial
