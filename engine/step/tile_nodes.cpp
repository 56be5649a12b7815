// Adds the nodes of slices: each reads and writes its own.

#include "engine/step/tile_nodes.h"

#include <string>

#include "engine/bodies/kernels/space/table_terms.h"
#include "engine/step/recovery_end.h"

namespace spoke {
namespace {

using graph::reads;
using graph::writes;

template <class World>
graph::NodeLabel label_of(const Assembly<World>& g, const char* stage, int i, int j,
                          std::size_t slice) {
  graph::NodeLabel label = g.label(stage, i, j);
  label.item = "slice " + std::to_string(slice + 1);
  return label;
}

/// The parts of a body, and its data.
struct TiledBody {
  const BodyParts& parts;
  SubsystemData<Space>& data;
  BodyData<Space>& body;
  const BodySlices* slices;  ///< null if it has none

  TiledBody(const Assembly<Space>& g, int i, int j)
      : parts(g.subsystem(i).bodies[j]),
        data(g.c.data.subsystems[i]),
        body(data.bodies[j]),
        slices(slices_of(body)) {}
  std::size_t count() const { return slices ? parts.tiles.size() : 0; }
};

bool is_solved_by_slices(const Assembly<Space>& g, int i, int j) {
  return g.c.formulation == Formulation::structured && slices_of(g.c.data.subsystems[i].bodies[j]);
}

void add_completion(const Assembly<Space>& g, int i, int j) {
  const TiledBody own(g, i, j);
  const auto [inputs, outputs] = completion_access(g, i, j);
  const Method& method = g.c.integrator.method;
  g.builder.add_node(g.label(stages::kCompletion, i, j), reads(inputs, own.parts.solution),
                     writes(outputs),
                     unless_halted(*own.data.progress,
                                   [&data = own.data, slices = own.slices, &method, j]() noexcept {
                                     BodyData<Space>& body = data.bodies[j];
                                     slices->take(body, body.a_found);
                                     complete_recovery(method, j, data);
                                   }));
}

}  // namespace

template <>
void add_mass_tiles(const Assembly<Plane>&, int, int) {}
template <>
void add_forward(const Assembly<Plane>&, int, int) {}
template <>
void add_backward(const Assembly<Plane>&, int, int) {}

template <>
void add_mass_tiles(const Assembly<Space>& g, int i, int j) {
  const TiledBody own(g, i, j);
  const System<Space>& system = g.c.system;
  const bool has_implicit = std::holds_alternative<GeneralizedAlpha>(g.c.integrator.method);
  const graph::Reads inputs = reads(
      own.data.parts.progress, parts_of_terms(system, static_cast<std::size_t>(i),
                                              static_cast<std::size_t>(j), has_implicit, g.c.data));
  for (std::size_t p = 0; p < own.count(); ++p)
    g.builder.add_node(
        label_of(g, stages::kMassTile, i, j, p), inputs, writes(own.parts.tiles[p]),
        unless_halted(
            *own.data.progress, [&system, &data = own.data, slices = own.slices, j, p]() noexcept {
              slices->calc_terms(system, data.progress->control.time, j, static_cast<int>(p), data);
            }));
}

template <>
void add_forward(const Assembly<Space>& g, int i, int j) {
  if (!is_solved_by_slices(g, i, j)) return;
  const TiledBody own(g, i, j);
  for (std::size_t p = 0; p < own.count(); ++p)
    g.builder.add_node(
        label_of(g, stages::kForward, i, j, p), reads(g.subsystem(i).progress, own.parts.tiles[p]),
        writes(own.parts.halves[p]),
        unless_halted(*own.data.progress, [&data = own.data, &body = own.body, slices = own.slices,
                                           p]() noexcept {
          slices->condense(static_cast<int>(p), data.progress->control.is_implicit, body);
        }));
}

template <>
void add_backward(const Assembly<Space>& g, int i, int j) {
  if (!is_solved_by_slices(g, i, j)) return;
  const TiledBody own(g, i, j);
  const SubsystemParts& subsystem = g.subsystem(i);
  for (std::size_t p = 0; p < own.count(); ++p)
    g.builder.add_node(
        label_of(g, stages::kBackward, i, j, p),
        reads(subsystem.progress, subsystem.wrenches, subsystem.rotations, own.parts.accelerations,
              own.parts.halves[p], own.parts.solution.back()),
        writes(own.parts.solution[p]),
        unless_halted(*own.data.progress, [&data = own.data, &body = own.body, slices = own.slices,
                                           p]() noexcept {
          slices->recover(static_cast<int>(p), data.progress->control.is_implicit, body);
        }));
  add_completion(g, i, j);
}

}  // namespace spoke
