#pragma once

// Rules for loops that end on another blade or subsystem, which are looked at when all are known.

#include <cstddef>
#include <string>

#include "models/reader/spatial/fault.h"
#include "models/spatial_model.h"

namespace spoke::spatial {

/// LoopPlace::blade while "next" of a file is not yet a number: the next blade of the rotor, behind
/// the last one the first.
inline constexpr int kNextBlade = -1;
/// Puts the numbers in the place of kNextBlade, in loops and couplings.
void resolve_next_blades(Model& model);

/// A blade by its number, from 1, or a subsystem by its name; of the other 0 or "".
struct TreeName {
  int blade = 0;
  std::string subsystem{};

  friend bool operator==(const TreeName&, const TreeName&) = default;
};
/// Returns the first fault that `find(owner, name)` finds of a blade or a subsystem of a model,
/// behind its key.
template <class Find>
Fault find_in_trees(const Model& model, const Find& find) {
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    if (Fault fault = find(model.blades[i], TreeName{static_cast<int>(i) + 1}))
      return fault.within("blades." + std::to_string(i + 1));
  for (std::size_t i = 0; i < model.subsystems.size(); ++i)
    if (Fault fault = find(model.subsystems[i], TreeName{0, model.subsystems[i].name}))
      return fault.within(key_of_subsystem(model, i));
  return {};
}

/// Finds a blade or a subsystem, one of the two, that is not there.
Fault find_tree_fault(const TreeName& name, const Model& model);

/// Finds the first anchor of the frame of a body that is not there: "anchor.2.frame".
Fault find_anchor_body_fault(const Model& model);

/// Finds the first fault of such an end, "blades.2.loop.1.to.blade".
Fault find_loop_end_fault(const Model& model);

}  // namespace spoke::spatial
