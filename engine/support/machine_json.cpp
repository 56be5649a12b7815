// The fields of "machine".

#include "engine/support/machine_json.h"

#include <nlohmann/json.hpp>

namespace spoke {

nlohmann::ordered_json describe_machine(const Machine& machine) {
  return {{"cpu", machine.cpu},
          {"cores", machine.cores},
          {"memory_bytes", machine.memory},
          {"os", machine.os},
          {"compiler", machine.compiler}};
}

nlohmann::ordered_json load_or_null(double load) {
  return load < 0.0 ? nlohmann::ordered_json() : nlohmann::ordered_json(load);
}

}  // namespace spoke
