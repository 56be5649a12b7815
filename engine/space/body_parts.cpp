// Declares the parts of spatial bodies.

#include "engine/formulation/body_parts.h"

#include <string>

#include "engine/space/nodal_memory.h"
#include "engine/space/nodal_terms.h"
#include "engine/space/solid_block.h"
#include "engine/table/body_parts.h"

namespace spoke {
namespace {

using graph::bytes_of;

std::span<std::byte> bytes(std::span<double> values) { return std::as_writable_bytes(values); }
Memory bytes(const std::vector<std::span<double>>& ranges) {
  Memory memory;
  for (const std::span<double> values : ranges) memory.push_back(bytes(values));
  return memory;
}

std::size_t handles_of(const BodyData<Space>& body) {
  return static_cast<std::size_t>(body.work.port.handles);
}

/// Returns the rows of a body's terms, but for those of tiles, which are theirs.
std::span<std::byte> rows_of(const BodyData<Space>& body) {
  const space::Body& shape = *body.model->body;
  std::size_t count = 0;
  if (const space::FlexibleBody* flexible = shape.flexible())
    count = static_cast<std::size_t>(space::kNodeRows * flexible->node_count());
  else if (const space::Solid* solid = shape.solid(); solid && !solid->constants->nodal())
    count = static_cast<std::size_t>(space::kSolidRow * solid->coordinates());
  return memory_of(body.work.rows, count);
}

/// Returns the workspace of a body's kernels, but for that of tiles.
std::span<std::byte> scratch_of(const BodyData<Space>& body) {
  const space::Body& shape = *body.model->body;
  std::size_t count = 0;
  if (const space::FlexibleBody* flexible = shape.flexible(); flexible && body.work.scratch)
    count = count_scratch(*flexible);
  else if (const space::Solid* solid = shape.solid(); solid && !solid->constants->nodal())
    count = count_scratch(*solid);
  return memory_of(body.work.scratch, count);
}

/// Lists what is factorised anew.
Memory memory_of_block(space::ElasticBlock& block) {
  Memory memory{bytes_of(block.C_W)};
  for (std::vector<double>* values : {&block.inverse, &block.below, &block.W_t})
    memory.push_back(bytes_of(*values));
  for (std::vector<double>& Z : block.Z) memory.push_back(bytes_of(Z));
  for (std::span<std::byte> range :
       {bytes_of(block.Z_W), bytes_of(block.Z_diagonal), bytes_of(block.Z_pairs)})
    memory.push_back(range);
  return memory;
}

Memory memory_of_matrix(space::BlockTridiagonal& matrix) {
  return {bytes_of(matrix.diagonal), bytes_of(matrix.below)};
}

/// Returns the factor of a solid in nodal coordinates, by whose structure its memory is laid out:
/// it is that of both blocks.
const space::SparseFactor& factor_of(const BodyData<Space>& body) {
  return *body.blocks[0]->solid->factor;
}

}  // namespace

void declare_motions(SubsystemData<Space>& data) {
  const PartMaker& maker = data.part_maker;
  SubsystemParts& parts = data.parts;
  parts.rotations = maker.cover("rotations", Mark::none, data.joints);
  parts.twists = maker.cover("twists", Mark::none, data.twists);
  parts.wrenches = maker.cover("wrenches", Mark::none, data.wrenches);
  for (BodyData<Space>& body : data.bodies) {
    const auto driven = static_cast<std::size_t>(body.model->joint.joint.driven);
    maker.add(parts.rotations, memory_of(body.work.handles, handles_of(body)), body.alpha,
              memory_of(body.joint.driven, driven));
    maker.add(parts.wrenches, memory_of(body.work.wrenches, handles_of(body)));
    const CoordinateBlock& joint = body.joint.coordinates;
    if (body.joint.a_found != joint.a)
      maker.add(parts.wrenches,
                memory_of(body.joint.a_found, static_cast<std::size_t>(joint.size)));
  }
}

void add_joint_coordinates(std::size_t j, SubsystemData<Space>& data) {
  const PartMaker& maker = data.part_maker;
  BodyData<Space>& body = data.bodies[j];
  const BodyParts& parts = data.parts.bodies[j];
  const CoordinateBlock& block = body.joint.coordinates;
  if (block.size == 0) return;
  const auto n = static_cast<std::size_t>(block.size);
  maker.add(parts.coordinates, memory_of(block.q, n), memory_of(block.v, n),
            body.joint.rotation->reference);
  maker.add(parts.accelerations, memory_of(block.a, n));
  for (double* h : block.history)
    if (h) maker.add(parts.history, memory_of(h, n));
  maker.add(parts.history, body.joint.rotation->sum);
}

void declare_terms(std::size_t j, SubsystemData<Space>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  space::BodyTerms& terms = body.terms;
  parts.terms = maker.cover("terms", Mark::none, terms.S, terms.S_rate, terms.Theta, terms.Q,
                            terms.stiffening, terms.tension, rows_of(body));
  parts.power = maker.cover("power", Mark::reported, terms.load_power, terms.dissipation);
  if (body.joint.coordinates.size > 0) maker.add(parts.terms, *body.joint.forces);
  parts.scratch = maker.cover("scratch", Mark::none, scratch_of(body));
  BodyReport& report = body.report;
  parts.report = maker.cover("report", Mark::reported, report.change, report.step_change,
                             report.deflection, report.error, report.failed, report.drive_power);
}

void declare_tension(std::size_t j, SubsystemData<Space>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  if (body.strain) {
    space::ImplicitStrain& strain = *body.strain;
    maker.add(parts.coordinates, strain.wrenches, strain.nodal);  // those at which a step begins
    parts.tension =
        maker.cover("tension", Mark::none, strain.turn, strain.shift.nodes,
                    memory_of_matrix(strain.added), strain.lean, memory_of_block(strain.block));
  } else if (body.tension) {
    space::ImplicitTension& tension = *body.tension;
    parts.tension = maker.cover("tension", Mark::none, tension.w, tension.turn, tension.elements,
                                memory_of_matrix(tension.stiffness), tension.lean,
                                memory_of_block(tension.block));
  }
}

void declare_tiles(std::size_t j, SubsystemData<Space>& data) {
  if (!data.bodies[j].tiles) return;
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  const space::NodalTiles& tiles = *body.tiles;
  maker.add(parts.terms, bytes(rows_between(tiles, body.work.rows)),
            bytes(memory_of_total_forms(tiles, body.work.tiles)));
  maker.add(parts.scratch, bytes(memory_of_observed(*body.model->body->solid(), tiles, body.work)));
  for (int p = 0; p < tiles.count(); ++p)
    parts.tiles.push_back(maker.of("slice " + std::to_string(p + 1))
                              .cover("terms", Mark::none,
                                     bytes(rows_of_tile(tiles, p, body.work.rows)),
                                     bytes(memory_of_tile(tiles, p, body.work.tiles))));
}

namespace {

/// Declares the half solutions of the slices of a solid, and accelerations, of which the last part
/// is what is between slices.
void declare_slices(const PartMaker& maker, BodyData<Space>& body, BodyParts& parts) {
  const space::Solid& solid = *body.model->body->solid();
  const space::SparseFactor& factor = factor_of(body);
  for (std::size_t p = 0; p <= factor.slices.size(); ++p) {
    const PartMaker of_slice = maker.of("slice " + std::to_string(p + 1));
    const bool is_between = p == factor.slices.size();
    const space::FactorSlice& slice = is_between ? factor.between : factor.slices[p];
    if (!is_between)
      parts.halves.push_back(of_slice.cover("half solutions", Mark::none,
                                            bytes(memory_of_slice(solid, factor, p, body.work))));
    parts.solution.push_back(
        of_slice.cover("accelerations", Mark::none,
                       memory_of(body.work.solution + slice.first,
                                 static_cast<std::size_t>(slice.end - slice.first))));
  }
}

void declare_port(const PartMaker& maker, bool by_mass, BodyData<Space>& body, BodyParts& parts) {
  const tree::MultiPort<Space>& port = body.work.port;
  const std::size_t n = handles_of(body);
  parts.port = maker.cover("port", Mark::none, memory_of(port.diagonal, by_mass ? 1 : n),
                           memory_of(port.free, n));
  if (by_mass) return;
  const int pairs = tree::MultiPort<Space>::count_pairs(port.handles);
  maker.add(parts.port, memory_of(port.pairs, static_cast<std::size_t>(pairs)));
}

/// Returns the half solutions of a body, but for those of slices, which are theirs.
Memory half_of(BodyData<Space>& body) {
  const space::Body& shape = *body.model->body;
  if (const space::Solid* solid = shape.solid()) {
    if (body.tiles) return bytes(memory_of_between(*solid, factor_of(body), body.work));
    const auto count = static_cast<std::size_t>(space::kSolidRow * solid->coordinates());
    return {memory_of(body.work.half, count)};
  }
  const space::FlexibleBody& flexible = *shape.flexible();
  const int first = flexible.first_node();
  const int count = space::kNodeRows * (flexible.node_count() - first);
  return {memory_of(body.work.half + space::kNodeRows * first, static_cast<std::size_t>(count))};
}

}  // namespace

void declare_inverse(std::size_t j, structured::BodyWork<Space>& work, SubsystemData<Space>& data) {
  const PartMaker maker = maker_of_body(j, data);
  BodyData<Space>& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  parts.inverse = maker.cover("inverse", Mark::none, Memory{});
  if (!body.model->body->rigid()) {
    space::Condensed& condensed = body.work.condensed;
    maker.add(parts.inverse, condensed.S_inverse, condensed.p, half_of(body),
              memory_of(condensed.X, handles_of(body)));
  }
  declare_port(maker, work.by_mass, body, parts);
  if (body.tiles) declare_slices(maker, body, parts);
}

}  // namespace spoke
