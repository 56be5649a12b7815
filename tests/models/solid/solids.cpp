#include "tests/models/solid/solids.h"

#include <algorithm>
#include <stdexcept>

namespace spoke::test {

solid::ChosenNodes choose_equally(const spatial::SolidMesh& mesh, const std::string& set) {
  for (const spatial::SolidNodeSet& candidate : mesh.sets) {
    if (candidate.name != set) continue;
    solid::ChosenNodes chosen;
    chosen.nodes = candidate.nodes;
    chosen.weights.assign(chosen.nodes.size(), 1.0 / static_cast<double>(chosen.nodes.size()));
    for (const int node : chosen.nodes)
      chosen.point += chosen.weights[0] * mesh.nodes[static_cast<std::size_t>(node)];
    return chosen;
  }
  throw std::logic_error("no set " + set);
}

solid::SolidProblem make_problem(const spatial::SolidMesh& mesh,
                                 const spatial::SolidMaterial& material,
                                 const spatial::Vector& origin) {
  solid::SolidProblem problem;
  auto shifted = std::make_shared<spatial::SolidMesh>(mesh);
  for (spatial::Vector& node : shifted->nodes) node -= origin;
  problem.nodes.assign(shifted->nodes.begin(), shifted->nodes.end());
  problem.matrices = solid::assemble(*shifted, material);
  problem.mesh = shifted;
  problem.material = material;
  return problem;
}

void add_interface(solid::SolidProblem& problem, const std::string& set,
                   spatial::InterfaceKind kind) {
  problem.interfaces.push_back({set, kind, choose_equally(*problem.mesh, set)});
}

spatial::SolidMesh make_bar(std::array<int, 3> cells, std::array<double, 3> lengths,
                            spatial::ElementKind kind, bool is_centred) {
  GridMesh grid;
  grid.cells = cells;
  grid.lengths = lengths;
  grid.kind = kind;
  if (is_centred) grid.shift = {0.0, -0.5 * lengths[1], -0.5 * lengths[2]};
  return make_grid_mesh(grid);
}

spatial::SolidMesh make_bracket() {
  GridMesh grid;
  grid.cells = {4, 1, 4};
  grid.lengths = {0.4, 0.1, 0.4};
  grid.keeps = [](int i, int, int k) { return i == 0 || k == 0; };
  return make_grid_mesh(grid);
}

spatial::SolidMaterial aluminium() { return {7e10, 0.33, 2700.0}; }

}  // namespace spoke::test
