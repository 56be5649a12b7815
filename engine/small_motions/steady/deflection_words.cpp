#include "engine/small_motions/steady/deflection_words.h"

#include <variant>

#include "models/tree/tree.h"

namespace spoke::steady {

DeflectionWords word_deflection(const spatial::Model& model, std::size_t subsystem,
                                std::size_t body) {
  const std::vector<spatial::Tree> trees = build_trees(model);
  const spatial::TreeBody& bent = trees.at(subsystem).bodies.at(body);
  const std::string name = trees[subsystem].name + " / " + bent.name;
  if (const auto* part = std::get_if<spatial::FlexibleBody>(&bent.shape)) {
    if (trees[subsystem].beams[part->beam].strain == spatial::BeamStrain::nonlinear)
      return {name, "bends by", " of the length of an element", "take more elements or bodies"};
    return {name, "bends by", " of its length", "cut the beam into more bodies"};
  }
  return {
      name, "deforms by",
      " (the largest of: displacement of an interface or of the tip by its size, rotation of an "
      "interface in rad, 10 times the largest strain)",
      "cut the solid into several, or take a beam where it is slender"};
}

}  // namespace spoke::steady
