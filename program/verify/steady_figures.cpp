// Reads displacements, joints and loads by their names.

#include "program/verify/steady_figures.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "models/error.h"
#include "models/support/nearest_name.h"

namespace spoke::verify {
namespace {

/// A vector of an equilibrium, by the word that quantities begin with: "tip x".
struct NamedVector {
  std::string_view name;
  Eigen::Vector3d value;
};

/// Returns the part of a list whose name a figure asks for.
template <class Part>
const Part& find_part(const std::vector<Part>& parts, const Figure& figure) {
  for (const Part& part : parts)
    if (part.name == figure.of) return part;
  throw InputError("figure \"" + figure.name + "\": there is no \"" + figure.of +
                   "\", expected one of " + std::to_string(parts.size()) + " others");
}

std::vector<NamedVector> list_vectors(const EquilibriumResult& result,
                                      const BladeEquilibrium& blade, const Figure& figure) {
  std::vector<NamedVector> vectors = {
      {"tip", blade.tip_displacement},
      {"tip rotation", blade.tip_rotation},
      {"hub force", result.hub_force},
      {"hub moment", result.hub_moment},
  };
  if (!blade.loads.empty()) {
    vectors.push_back({"root force", blade.loads.front().force});
    vectors.push_back({"root moment", blade.loads.front().moment});
  }
  if (figure.quantity.starts_with("loop ")) {
    const LoopLoad& loop = find_part(blade.loops, figure);
    vectors.push_back({"loop force", loop.force});
    vectors.push_back({"loop moment", loop.moment});
  }
  return vectors;
}

/// Returns the largest displacement of a node along an axis, its sign kept.
double find_largest(const BladeEquilibrium& blade, Eigen::Index axis) {
  double largest = 0.0;
  for (std::size_t k = 0; k < blade.nodes.size(); ++k) {
    const double moved = (blade.nodes[k] - blade.undeformed[k])[axis];
    if (std::abs(moved) > std::abs(largest)) largest = moved;
  }
  return largest;
}

}  // namespace

double read_steady(const EquilibriumResult& result, const Figure& figure) {
  const auto number = static_cast<std::size_t>(figure.number);
  if (number > result.blades.size())
    throw InputError("figure \"" + figure.name + "\": there are only " +
                     std::to_string(result.blades.size()) + " blades and subsystems");
  const BladeEquilibrium& blade = result.blades[number - 1];
  if (figure.quantity == "joint") return find_part(blade.joints, figure).value;
  if (figure.quantity == "loop tension")
    return find_part(blade.loops, figure).tension.value_or(0.0);
  if (figure.quantity == "thrust" && result.air) return result.air->thrust;
  if (figure.quantity == "torque" && result.air) return result.air->torque;
  constexpr std::string_view kAxes = "xyz";
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto index = static_cast<Eigen::Index>(axis);
    for (const NamedVector& vector : list_vectors(result, blade, figure))
      if (figure.quantity == std::string(vector.name) + ' ' + kAxes[axis])
        return vector.value[index];
    if (figure.quantity == std::string("largest ") + kAxes[axis]) return find_largest(blade, index);
  }
  if (figure.quantity == "tip") return blade.tip_displacement.norm();
  throw InputError("figure \"" + figure.name + "\": quantity \"" + figure.quantity +
                   "\" is none of an equilibrium, expected such as \"tip x\", \"tip rotation z\", "
                   "\"root moment y\", \"hub force z\", \"loop force x\", \"joint\"");
}

}  // namespace spoke::verify
