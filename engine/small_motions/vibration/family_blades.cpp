// Finds the blades of rings among the members of their subsystem.

#include "engine/small_motions/vibration/family_blades.h"

#include <algorithm>
#include <iterator>

namespace spoke::vibration {

using Eigen::Index;

std::vector<FamilyBlade> list_blades(const BladeFamily& family, const Linearised& all) {
  std::vector<FamilyBlade> blades;
  for (const std::size_t i : family.blades) {
    Index output = 0;
    for (const steady::SubsystemPart& part : all.model.members(i)) {
      const Index outputs = std::ssize(part.model->outputs(part.subsystem));
      blades.push_back({part.model,
                        part.subsystem,
                        i,
                        {part.first, part.count},
                        {0, all.linear.subsystem(i).M.rows()},
                        {output, outputs}});
      output += outputs;
    }
  }
  if (!family.ring.is_tied) return blades;
  std::sort(blades.begin(), blades.end(),
            [](const FamilyBlade& a, const FamilyBlade& b) { return a.azimuth() < b.azimuth(); });
  for (std::size_t k = 0; k < blades.size(); ++k)
    blades[k].independent = {family.ring.starts[k], family.ring.size};
  return blades;
}

std::vector<steady::SubsystemCoordinate> list_independent(const FamilyBlade& blade,
                                                          const steady::LinearModel& linear) {
  const std::vector<Index>& all = linear.subsystem(blade.subsystem).independent;
  const std::vector<Index>& forces = linear.subsystem(blade.subsystem).forces;
  std::vector<steady::SubsystemCoordinate> list;
  for (Index k = 0; k < blade.independent.count; ++k) {
    const Index at = all[static_cast<std::size_t>(blade.independent.first + k)];
    list.push_back(blade.model->coordinates(
        blade.own)[static_cast<std::size_t>(at - blade.coordinates.first)]);
    if (std::binary_search(forces.begin(), forces.end(), blade.independent.first + k))
      list.back() = steady::force_on(list.back());
  }
  return list;
}

}  // namespace spoke::vibration
