// Lays out what one body needs, by pieces that begin with a cache line.

#include "engine/bodies/space/nodal_memory.h"

#include <algorithm>
#include <cassert>

#include "engine/bodies/space/nodal_tension.h"
#include "engine/bodies/space/nodal_terms.h"

namespace spoke::space {
namespace {

std::size_t slices_of(const SolidBlock& block) { return block.factor->slices.size(); }

std::size_t count_observed(const Solid& body, const NodalTiles& tiles) {
  return std::max(count_nodal_work(tiles), count_nodal_tension(*body.constants->nodal()));
}

std::span<double> rows_of(double* rows, int first, int end) {
  return {rows + static_cast<std::ptrdiff_t>(kSolidRow) * first,
          rows + static_cast<std::ptrdiff_t>(kSolidRow) * end};
}

}  // namespace

NodalTiles make_nodal_tiles(const SolidConstants& constants, const SolidTension* tension) {
  std::vector<Eigen::VectorXd> forms;
  if (tension) {
    for (const Eigen::MatrixXd& spin : tension->spin) forms.emplace_back(spin.col(0));
    for (const Eigen::MatrixXd& gravity : tension->gravity) forms.emplace_back(gravity.col(0));
  }
  return make_nodal_tiles(constants, forms);
}

void place_nodal_work(const Solid& body, const NodalTiles& tiles, const SolidBlock& explicit_block,
                      const SolidBlock& implicit_block, NodalMemory& memory, BodyWork& work) {
  assert(slices_of(explicit_block) == slices_of(implicit_block));
  const auto take = [&memory](std::size_t count) {
    auto* const place = static_cast<double*>(memory.arena.allocate(count * sizeof(double)));
    std::fill_n(place, count, 0.0);
    return place;
  };
  const int n = body.coordinates();
  const int half = std::max(count_half_rows(explicit_block, n), count_half_rows(implicit_block, n));
  work.rows = take(static_cast<std::size_t>(kSolidRow * tiles.rows()));
  work.half = take(static_cast<std::size_t>(kSolidRow * half));
  work.products = take((slices_of(explicit_block) + 1) * count_products(body));
  work.solution = take(static_cast<std::size_t>(n));
  work.tiles = place_nodal_work(tiles, work.rows, take(count_nodal_work(tiles)));
  work.observed = place_nodal_work(tiles, nullptr, take(count_observed(body, tiles)));
}

std::vector<std::span<double>> memory_of_slice(const Solid& body, const SparseFactor& factor,
                                               std::size_t p, const BodyWork& work) {
  const FactorSlice& slice = factor.slices[p];
  const std::size_t products = count_products(body);
  std::vector<std::span<double>> memory{rows_of(work.half, slice.first, slice.end),
                                        {work.products + p * products, products}};
  const int share = factor.size + slice.share, rows = slice.end_between - slice.first_between;
  if (rows > 0) memory.push_back(rows_of(work.half, share, share + rows));
  return memory;
}

std::vector<std::span<double>> memory_of_between(const Solid& body, const SparseFactor& factor,
                                                 const BodyWork& work) {
  const std::size_t products = count_products(body);
  std::vector<std::span<double>> memory{
      {work.products + factor.slices.size() * products, products}};
  if (factor.between.end > factor.between.first)
    memory.push_back(rows_of(work.half, factor.between.first, factor.between.end));
  return memory;
}

std::vector<std::span<double>> memory_of_observed(const Solid& body, const NodalTiles& tiles,
                                                  const BodyWork& work) {
  return {{work.observed.motions, count_observed(body, tiles)}};
}

}  // namespace spoke::space
