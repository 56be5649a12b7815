// Follows loops from tree to tree, and from hub to hub to the support.

#include "models/tree/loops_across.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace spoke::spatial {
namespace {

/// Adds to trees the hubs through which a loop or a coupling passes that visits `visited` trees, on
/// their way to the support, hub by hub. `end`: as its ends are.
void add_ends_on_hubs(const std::set<std::size_t>& visited, LoopEnd end, std::vector<Tree>& trees) {
  std::set<int> rotors;
  for (std::size_t tree : visited)
    while (tree + 1 < trees.size()) {
      rotors.insert(trees[tree].rotor);
      tree = find_hub(trees, trees[tree].rotor).tree;
    }
  end.is_on_hub = true;
  for (const int rotor : rotors) {
    const BodyAt at = find_hub(trees, rotor);
    end.place = {};
    end.place.body = static_cast<int>(at.body);
    trees[at.tree].ends.push_back(end);
  }
}

}  // namespace

void add_loops_on_hubs(const Model& model, std::vector<Tree>& trees) {
  for (std::size_t i = 0; i < trees.size(); ++i)
    for (std::size_t k = 0; k < trees[i].loops.size(); ++k) {
      const Loop& loop = trees[i].loops[k].loop;
      if (loop.to.carrier == LoopPlace::Carrier::elsewhere)
        add_ends_on_hubs({i, find_tree(model, loop.to)}, {i, k, {}, loop}, trees);
    }
}

void add_coupling_ends(const Model& model, std::vector<Tree>& trees) {
  for (std::size_t i = 0; i < trees.size(); ++i)
    for (std::size_t k = 0; k < trees[i].couplings.size(); ++k) {
      const Coupling coupling = trees[i].couplings[k];
      std::map<std::size_t, std::vector<CoupledJoint>> others;
      for (CoupledJoint at : coupling.joints) {
        if (!at.is_elsewhere()) continue;
        const std::size_t tree = find_tree(model, at.blade, at.subsystem);
        at.blade = 0;
        at.subsystem.clear();
        others[tree].push_back(at);
      }
      if (others.empty()) continue;
      LoopEnd end{i, trees[i].loops.size() + k};
      std::set<std::size_t> visited{i};
      for (const auto& [tree, joints] : others) {
        visited.insert(tree);
        end.coupling = coupling;
        end.coupling->joints = joints;
        trees[tree].ends.push_back(end);
      }
      if (!model.support) continue;
      end.coupling->joints.clear();
      add_ends_on_hubs(visited, end, trees);
    }
}

std::size_t find_tree(const Model& model, const LoopPlace& place) {
  assert(place.carrier == LoopPlace::Carrier::elsewhere);
  return find_tree(model, place.blade, place.subsystem);
}

std::size_t find_tree(const Model& model, int blade, const std::string& subsystem) {
  if (blade > 0) return static_cast<std::size_t>(blade) - 1;
  const auto at = std::find_if(model.subsystems.begin(), model.subsystems.end(),
                               [&](const Subsystem& own) { return own.name == subsystem; });
  assert(at != model.subsystems.end());
  return model.blades.size() + static_cast<std::size_t>(at - model.subsystems.begin());
}

std::vector<LoopFromElsewhere> find_loops_from_elsewhere(const Model& model, std::size_t tree) {
  std::vector<LoopFromElsewhere> found;
  const auto add = [&](std::size_t own, const std::vector<Loop>& loops) {
    for (std::size_t k = 0; k < loops.size(); ++k)
      if (loops[k].to.carrier == LoopPlace::Carrier::elsewhere &&
          find_tree(model, loops[k].to) == tree)
        found.push_back({own, k, &loops[k]});
  };
  for (std::size_t i = 0; i < model.blades.size(); ++i) add(i, model.blades[i].loops);
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    add(model.blades.size() + i, model.subsystems[i].loops);
  return found;
}

}  // namespace spoke::spatial
