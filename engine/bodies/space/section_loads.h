#pragma once

// Loads of the scenario on a flexible body: the motion of sections that bear one load, and the
// load's effects, at four sections of an element side by side. At one section the same is done by
// add_section_wrench() and AppliedTension::add_at() at calc_section_motion().

#include <array>
#include <span>
#include <vector>

#include "engine/bodies/space/applied_tension.h"
#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/section.h"

namespace spoke::space {

/// Up to four sections of an element on which a load acts, along the axes of the element. Places
/// without a section have no weight.
struct alignas(32) LoadedSections {
  // Shape functions as in Section, by their factors where they are not zero.
  Lanes along{};                   ///< the section's place, 0 at the inner node, 1 at the outer
  Lanes stretch{};                 ///< shape of the outer node's displacement along the axis
  Lanes rise{};                    ///< shape of that across it
  std::array<Lanes, 2> tangent{};  ///< shapes of the slopes at the nodes, in displacements [m]
  Lanes rise_slope{};              ///< shape of the rise between the nodes, in slopes [1/m]
  std::array<Lanes, 2> slope{};    ///< shapes of the slopes at the nodes, in slopes
  std::array<Lanes, 2> offset{};   ///< from the chord to the section, along e2 and e3 [m]
  std::array<Lanes, 3> place{};    ///< s0 of the section [m]
  std::array<Lanes, 6> tension{};  ///< Section::slopes
  std::array<Lanes, 9> axes{};     ///< axes of the undeformed sections, column by column
  Lanes weight{};                  ///< weight of the load
  int element = 0;
};

/// Makes the sections of a load, with their weights.
std::vector<LoadedSections> make_loaded_sections(const FlexibleBody& body,
                                                 std::span<const Section> sections,
                                                 std::span<const double> weights);

/// A load at an instant.
struct LoadInstant {
  bool follows = false;          ///< whether it is resolved in the axes of its sections, else in B
  Twist wrench = Twist::Zero();  ///< wrench of a weight of one
};

/// Returns the sum of a load's forces on a body at the flex vector q, in B.
Position sum_load_forces(const FlexibleBody& body, std::span<const LoadedSections> sections,
                         const LoadInstant& load, const double* q) noexcept;

/// Adds a load on a body at a state whose frame moves with `twist` to its terms, rows and power. If
/// there is a tension, adds the forces to that, too, along the axes into which `turn` takes those
/// of B.
void add_load(const FlexibleBody& body, std::span<const LoadedSections> sections,
              const LoadInstant& load, const BodyState& state, const Twist& twist,
              AppliedTension* tension, const Rotation& turn, BodyTerms& terms,
              const BodyWork& work) noexcept;

}  // namespace spoke::space
