// Declares the parts of a solid in nodal coordinates: those of its slices, and what lies between.

#include <string>

#include "engine/bodies/kinds/condensed_parts.h"
#include "engine/bodies/kinds/nodal/nodal_kind.h"
#include "engine/bodies/kinds/solid/solid_table_terms.h"
#include "engine/bodies/space/nodal_memory.h"
#include "engine/bodies/space/nodal_terms.h"

namespace spoke {
namespace {

std::span<std::byte> bytes(std::span<double> values) { return std::as_writable_bytes(values); }
Memory bytes(const std::vector<std::span<double>>& ranges) {
  Memory memory;
  for (const std::span<double> values : ranges) memory.push_back(bytes(values));
  return memory;
}

/// Returns the factor by whose structure its memory is laid out: it is that of both blocks.
const space::SparseFactor& factor_of(const BodyData<Space>& body) {
  return *solid_block_of(body, false).factor;
}

/// Declares the half solutions of the slices, and accelerations, of which the last part is what is
/// between slices.
void declare_slices(const PartMaker& maker, BodyData<Space>& body, BodyParts& parts) {
  const space::SparseFactor& factor = factor_of(body);
  for (std::size_t p = 0; p <= factor.slices.size(); ++p) {
    const PartMaker of_slice = maker.of("slice " + std::to_string(p + 1));
    const bool is_between = p == factor.slices.size();
    const space::FactorSlice& slice = is_between ? factor.between : factor.slices[p];
    if (!is_between)
      parts.halves.push_back(
          of_slice.cover("half solutions", Mark::none,
                         bytes(memory_of_slice(solid_of(body), factor, p, body.work))));
    parts.solution.push_back(
        of_slice.cover("accelerations", Mark::none,
                       memory_of(body.work.solution + slice.first,
                                 static_cast<std::size_t>(slice.end - slice.first))));
  }
}

}  // namespace

// Declares the tiles, and what of the terms lies between them.
void NodalKind::declare_tension(std::size_t j, SubsystemData<Space>& data) const {
  const PartMaker maker = maker_of_body(j, data);
  Data& body = data.bodies[j];
  BodyParts& parts = data.parts.bodies[j];
  const space::NodalTiles& tiles = *body.tiles;
  maker.add(parts.terms, bytes(rows_between(tiles, body.work.rows)),
            bytes(memory_of_total_forms(tiles, body.work.tiles)));
  maker.add(parts.scratch, bytes(memory_of_observed(solid_of(body), tiles, body.work)));
  for (int p = 0; p < tiles.count(); ++p)
    parts.tiles.push_back(maker.of("slice " + std::to_string(p + 1))
                              .cover("terms", Mark::none,
                                     bytes(rows_of_tile(tiles, p, body.work.rows)),
                                     bytes(memory_of_tile(tiles, p, body.work.tiles))));
}

void NodalKind::declare_inverse(const PartMaker& maker, Data& body, BodyParts& parts) const {
  add_condensed(maker, bytes(memory_of_between(solid_of(body), factor_of(body), body.work)), body,
                parts);
  declare_slices(maker, body, parts);
}

}  // namespace spoke
