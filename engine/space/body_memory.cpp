// Lists the memory of spatial bodies.

#include "engine/formulation/body_memory.h"

#include "engine/space/nodal_memory.h"
#include "engine/space/nodal_terms.h"
#include "engine/space/solid_block.h"

namespace spoke {

using graph::bytes_of;

namespace {

void append(const std::vector<std::span<double>>& values, Memory& memory) {
  for (const std::span<double> part : values)
    if (!part.empty()) memory.push_back(bytes_of(part[0], part.size()));
}

/// Returns the factor of a solid in nodal coordinates, by whose structure its memory is laid out:
/// it is that of both blocks.
const space::SparseFactor& factor_of(const BodyData<Space>& body) {
  return *body.blocks[0]->solid->factor;
}

}  // namespace

void add_joint_coordinates(BodyData<Space>& body, Memory& coordinates, Memory& history,
                           Memory& accelerations) {
  const CoordinateBlock& block = body.joint.coordinates;
  if (block.size == 0) return;
  const auto n = static_cast<std::size_t>(block.size);
  coordinates.push_back(memory_of(block.q, n));
  coordinates.push_back(memory_of(block.v, n));
  coordinates.push_back(bytes_of(body.joint.rotation->reference));
  accelerations.push_back(memory_of(block.a, n));
  for (double* h : block.history)
    if (h) history.push_back(memory_of(h, n));
  history.push_back(bytes_of(body.joint.rotation->sum));
}

Memory memory_of_motions(SubsystemData<Space>& data) {
  Memory memory{bytes_of(data.joints[0], data.joints.size())};
  for (BodyData<Space>& body : data.bodies) {
    memory.push_back(
        memory_of(body.work.handles, static_cast<std::size_t>(body.work.port.handles)));
    memory.push_back(bytes_of(body.alpha));
    const int driven = body.model->joint.joint.driven;
    if (driven > 0)
      memory.push_back(memory_of(body.joint.driven, static_cast<std::size_t>(driven)));
  }
  return memory;
}

Memory memory_of_slides(SubsystemData<Space>& data) {
  Memory memory;
  for (BodyData<Space>& body : data.bodies)
    if (body.model->joint.slide) memory.push_back(bytes_of(body.slide));
  return memory;
}

Memory memory_of_wrenches(SubsystemData<Space>& data) {
  Memory memory{bytes_of(data.wrenches[0], data.wrenches.size())};
  for (BodyData<Space>& body : data.bodies) {
    memory.push_back(
        memory_of(body.work.wrenches, static_cast<std::size_t>(body.work.port.handles)));
    const CoordinateBlock& joint = body.joint.coordinates;
    if (joint.size > 0 && body.joint.a_found != joint.a)
      memory.push_back(memory_of(body.joint.a_found, static_cast<std::size_t>(joint.size)));
  }
  return memory;
}

Memory memory_of_terms(BodyData<Space>& body) {
  Memory memory{bytes_of(body.terms)};
  if (body.joint.coordinates.size > 0) memory.push_back(bytes_of(*body.joint.forces));
  if (const space::FlexibleBody* flexible = body.model->body->flexible())
    memory.push_back(memory_of(
        body.work.rows, static_cast<std::size_t>(space::kNodeRows * flexible->node_count())));
  if (body.tiles) {
    append({rows_between(*body.tiles, body.work.rows),
            memory_of_total_forms(*body.tiles, body.work.tiles)},
           memory);
    return memory;
  }
  if (const space::Solid* solid = body.model->body->solid())
    memory.push_back(memory_of(body.work.rows,
                               static_cast<std::size_t>(space::kSolidRow * solid->coordinates())));
  return memory;
}

Memory memory_of_scratch(BodyData<Space>& body) {
  if (const space::Solid* solid = body.model->body->solid()) {
    if (!body.tiles) return {memory_of(body.work.scratch, count_scratch(*solid))};
    Memory memory;
    append(memory_of_observed(*solid, *body.tiles, body.work), memory);
    return memory;
  }
  const space::FlexibleBody* flexible = body.model->body->flexible();
  if (!flexible || !body.work.scratch) return {};
  return {memory_of(body.work.scratch, count_scratch(*flexible))};
}

namespace {

void append(std::vector<space::NodeMomentum>& values, Memory& memory) {
  memory.push_back(bytes_of(values[0], values.size()));
}

/// Lists what is factorised anew.
void append(space::ElasticBlock& block, Memory& memory) {
  memory.push_back(bytes_of(block.C_W));
  const auto add = [&memory](auto& values) {
    if (!values.empty()) memory.push_back(bytes_of(values[0], values.size()));
  };
  for (std::vector<double>* values : {&block.inverse, &block.below, &block.W_t}) add(*values);
  for (std::vector<double>& Z : block.Z) add(Z);
  add(block.Z_W);
  add(block.Z_diagonal);
  add(block.Z_pairs);
}

void append(space::BlockTridiagonal& matrix, Memory& memory) {
  memory.push_back(bytes_of(matrix.diagonal[0], matrix.diagonal.size()));
  memory.push_back(bytes_of(matrix.below[0], matrix.below.size()));
}

Memory memory_of_strain(space::ImplicitStrain& strain) {
  Memory memory{bytes_of(strain.turn), bytes_of(strain.shift.nodes[0], strain.shift.nodes.size())};
  append(strain.added, memory);
  append(strain.lean, memory);
  append(strain.block, memory);
  return memory;
}

}  // namespace

Memory memory_of_wrenches_at_start(BodyData<Space>& body) {
  if (!body.strain) return {};
  space::ImplicitStrain& strain = *body.strain;
  return {bytes_of(strain.wrenches[0], strain.wrenches.size()),
          bytes_of(strain.nodal[0], strain.nodal.size())};
}

Memory memory_of_tension(BodyData<Space>& body) {
  if (body.strain) return memory_of_strain(*body.strain);
  if (!body.tension) return {};
  space::ImplicitTension& tension = *body.tension;
  Memory memory{bytes_of(tension.w), bytes_of(tension.turn),
                bytes_of(tension.elements[0], tension.elements.size())};
  append(tension.stiffness, memory);
  append(tension.lean, memory);
  append(tension.block, memory);
  return memory;
}

Memory memory_of_inverse(BodyData<Space>& body, BodyTypes<Space>::Condensed&) {
  const space::FlexibleBody* flexible = body.model->body->flexible();
  const space::Solid* solid = body.model->body->solid();
  if (!flexible && !solid) return {};
  Memory memory{bytes_of(body.work.condensed.S_inverse), bytes_of(body.work.condensed.p)};
  if (solid && body.tiles) {
    append(memory_of_between(*solid, factor_of(body), body.work), memory);
    memory.push_back(memory_of(body.work.condensed.X, solid->handles.size()));
    return memory;
  }
  if (solid) {
    memory.push_back(memory_of(body.work.half,
                               static_cast<std::size_t>(space::kSolidRow * solid->coordinates())));
    memory.push_back(memory_of(body.work.condensed.X, solid->handles.size()));
    return memory;
  }
  const int first = flexible->first_node();
  memory.push_back(
      memory_of(body.work.half + space::kNodeRows * first,
                static_cast<std::size_t>(space::kNodeRows * (flexible->node_count() - first))));
  memory.push_back(memory_of(body.work.condensed.X, flexible->handles.size()));
  return memory;
}

SliceMemory memory_of_slices(BodyData<Space>& body) {
  SliceMemory memory;
  if (!body.tiles) return memory;
  const space::Solid& solid = *body.model->body->solid();
  const space::SparseFactor& factor = factor_of(body);
  const auto take_solution = [&](const space::FactorSlice& slice) {
    Memory& solution = memory.solution.emplace_back();
    append({{body.work.solution + slice.first, body.work.solution + slice.end}}, solution);
  };
  for (int p = 0; p < body.tiles->count(); ++p) {
    Memory& tile = memory.tiles.emplace_back();
    append(rows_of_tile(*body.tiles, p, body.work.rows), tile);
    append(memory_of_tile(*body.tiles, p, body.work.tiles), tile);
    const auto slice = static_cast<std::size_t>(p);
    append(memory_of_slice(solid, factor, slice, body.work), memory.halves.emplace_back());
    take_solution(factor.slices[slice]);
  }
  take_solution(factor.between);
  return memory;
}

Memory memory_of_port(BodyData<Space>& body, bool by_mass) {
  const tree::MultiPort<Space>& port = body.work.port;
  const auto n = static_cast<std::size_t>(port.handles);
  if (by_mass) return {memory_of(port.diagonal, 1), memory_of(port.free, n)};
  Memory memory{memory_of(port.diagonal, n), memory_of(port.free, n)};
  const int pairs = tree::MultiPort<Space>::count_pairs(port.handles);
  if (pairs > 0) memory.push_back(memory_of(port.pairs, static_cast<std::size_t>(pairs)));
  return memory;
}

}  // namespace spoke
