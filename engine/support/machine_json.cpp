// Sets the fields of "machine".

#include "engine/support/machine_json.h"

namespace spoke {

Json describe_machine(const Machine& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"memory_bytes", machine.memory},
          {"os", machine.os},
          {"compiler", machine.compiler}};
}

Json describe(const Capacity& capacity) {
  if (!capacity.is_known()) return nullptr;
  return {{"threads", capacity.threads}, {"before", capacity.before}, {"after", capacity.after}};
}

Json load_or_null(double load) { return load < 0.0 ? Json() : Json(load); }

}  // namespace spoke
