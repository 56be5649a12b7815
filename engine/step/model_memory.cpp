// Adds up the estimates of table, formulation and graph.

#include "engine/step/model_memory.h"

#include <cstdio>
#include <string>

#include "engine/bodies/table/body_kind.h"
#include "engine/step/formulation/work.h"
#include "engine/support/memory.h"
#include "spoke/error.h"

namespace spoke {
namespace {

/// Counts three nodes for a subsystem with loops, and one for each loop.
template <class World>
double count_loop_nodes(const System<World>& system) {
  double nodes = 0.0;
  for (const Subsystem<World>& subsystem : system.subsystems)
    if (!subsystem.loops.empty()) nodes += 3.0 + static_cast<double>(subsystem.loops.size());
  return nodes;
}

/// Counts the nodes that some bodies have besides those of all.
double count_own_nodes(const System<Plane>&) { return 0.0; }
double count_own_nodes(const System<Space>& system) {
  double nodes = 0.0;
  for (const Subsystem<Space>& subsystem : system.subsystems)
    for (const TreeBody<Space>& member : subsystem.bodies)
      nodes += kind_of(*member.body).count_own_nodes(*member.body);
  return nodes;
}

/// Returns the memory of the step graph of one pass, while it is built [bytes].
template <class World>
double estimate_graph_memory(const System<World>& system) {
  const double nodes = 3.0 + 8.0 * static_cast<double>(system.subsystems.size()) +
                       3.0 * static_cast<double>(system.body_count()) + count_loop_nodes(system) +
                       count_own_nodes(system);
  return 1200.0 * nodes;
}

}  // namespace

template <class World>
double estimate_model_memory(const System<World>& system, Formulation formulation) {
  return estimate_memory(system, formulation) + estimate_graph_memory(system);
}

template <class World>
void require_memory(const System<World>& system, Formulation formulation) {
  const double needed = estimate_model_memory(system, formulation);
  const double most = 0.8 * available_memory();
  if (needed < most) return;
  const auto gigabytes = [](double bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f GB", bytes / 1e9);
    return std::string(text);
  };
  const bool is_dense = formulation != Formulation::structured;
  throw InputError("the model in the formulation " + std::string(name_of(formulation)) + " needs " +
                   gigabytes(needed) + " of memory, expected at most " + gigabytes(most) +
                   " on this machine: use fewer blades, bodies or elements" +
                   (is_dense ? ", or the formulation structured" : ""));
}

template double estimate_model_memory(const System<Plane>&, Formulation);
template void require_memory(const System<Plane>&, Formulation);
template double estimate_model_memory(const System<Space>&, Formulation);
template void require_memory(const System<Space>&, Formulation);

}  // namespace spoke
