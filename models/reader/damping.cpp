// Reads directions by their names or in BeamDyn's order, and ratios by mode.

#include "models/reader/damping.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "models/reader/row_reader.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

constexpr std::size_t kBeamDynFactors = 6;

/// Calls visit(key, factor, whether the plane has it); shear factors are optional.
template <PerhapsConst<DirectionDamping> D, class Visit>
void visit_directions(D& damping, const Visit& visit) {
  const auto visit_key = [&](std::string_view key, auto& factor) {
    visit(key, factor, key == "lag" || key == "axial");
  };
  keys::visit_numbers<void>(
      keys::kBeamDampingRows, damping,
      [&](std::string_view key, auto& factor, const auto&, Presence) { visit_key(key, factor); });
  keys::visit_options(
      keys::kBeamDampingRows, damping,
      [&](std::string_view key, auto& factor, const auto&) { visit_key(key, factor); });
}

bool is_given(double factor) { return factor != 0.0; }
bool is_given(const std::optional<double>& factor) { return factor.has_value(); }
double value_of(double factor) { return factor; }
double value_of(const std::optional<double>& factor) { return factor.value_or(0.0); }

std::string range_fault(double value, const Quantity& range) {
  const std::string expected = range.expectation_instead_of(value);
  return expected.empty() ? "" : "is " + describe(value) + ", expected " + expected;
}

constexpr const char* kOnlyInSpace =
    "belongs to models in space, expected lag (bending) or axial of one in the plane";
constexpr const char* kNoBeams =
    "damps beams, of which there are none; expected stiffness_factor, or damping of a solid";

/// mu1..mu6 are in the order of BeamDyn's sections, whose x is along flap, y along the edge, z
/// along the blade: shears x and y, stretch, bending about x and y, twist.
DirectionDamping from_beamdyn(const std::vector<double>& mu) {
  DirectionDamping damping;
  damping.flap_shear = mu[0];
  damping.lag_shear = mu[1];
  damping.axial = mu[2];
  damping.lag = mu[3];
  damping.flap = mu[4];
  damping.torsion = mu[5];
  return damping;
}

DirectionDamping read_directions(const TomlSection& section, const DampedBeams& beams) {
  DirectionDamping damping;
  if (section.has("mu")) {
    if (beams.in_plane) section.fail("mu", kOnlyInSpace);
    visit_directions(damping, [&](std::string_view key, auto&, bool) {
      if (section.has(key)) section.fail(key, "given along with mu, expected only one of them");
    });
    return from_beamdyn(section.numbers("mu", kFactorOfStiffness, kBeamDynFactors));
  }
  visit_directions(damping, [&](std::string_view key, auto& factor, bool is_in_plane) {
    if (!section.has(key)) return;
    if (beams.in_plane && !is_in_plane) section.fail(key, kOnlyInSpace);
    factor = section.number(key, kFactorOfStiffness);
  });
  return damping;
}

ModeDamping read_modes(const TomlSection& section) {
  ModeDamping damping;
  if (section.has("ratios")) damping.ratios = section.numbers("ratios", kDampingRatioOfBeams);
  if (section.has("above")) damping.above = section.number("above", kDampingRatioOfBeams);
  return damping;
}

DampingFault find_fault(const DirectionDamping& damping, const DampedBeams& beams) {
  DampingFault fault;
  visit_directions(damping, [&](std::string_view key, const auto& factor, bool is_in_plane) {
    if (!fault.text.empty() || !is_given(factor)) return;
    if (beams.in_plane && !is_in_plane)
      fault = {std::string(key), kOnlyInSpace};
    else if (std::string text = range_fault(value_of(factor), kFactorOfStiffness); !text.empty())
      fault = {std::string(key), text};
    else if (!beams.is_any && value_of(factor) != 0.0)
      fault = {std::string(key), kNoBeams};
  });
  return fault;
}

DampingFault find_fault(const ModeDamping& damping, const DampedBeams& beams) {
  for (std::size_t k = 0; k < damping.ratios.size(); ++k)
    if (std::string text = range_fault(damping.ratios[k], kDampingRatioOfBeams); !text.empty())
      return {"ratios." + std::to_string(k + 1), text};
  if (damping.above) {
    if (damping.ratios.empty())
      return {"above", "would be ignored, expected only along with ratios"};
    if (std::string text = range_fault(*damping.above, kDampingRatioOfBeams); !text.empty())
      return {"above", text};
  }
  if (damping.ratios.empty()) return {};
  if (!beams.is_any) return {"ratios", kNoBeams};
  if (damping.ratios.size() <= beams.least_coordinates) return {};
  return {"ratios", "has " + std::to_string(damping.ratios.size()) + " values, expected at most " +
                        std::to_string(beams.least_coordinates) +
                        ", one for each coordinate of the beam that has fewest"};
}

/// Counts a beam of so many coordinates a node.
void add_beam(int bodies, int elements, int per_node, DampedBeams& beams) {
  const auto count = static_cast<std::size_t>(bodies) * static_cast<std::size_t>(elements) *
                     static_cast<std::size_t>(per_node);
  beams.least_coordinates = beams.is_any ? std::min(beams.least_coordinates, count) : count;
  beams.is_any = true;
}

}  // namespace

DampedBeams::DampedBeams(const std::vector<Blade>& blades) : in_plane(true) {
  for (const Blade& blade : blades) add_beam(blade.bodies, blade.elements, kTwist, *this);
}

DampedBeams::DampedBeams(const spatial::Model& model) {
  constexpr int kPerNode = 6;
  for (const spatial::Blade& blade : model.blades)
    add_beam(blade.beam.bodies, blade.beam.elements, kPerNode, *this);
  for (const spatial::Subsystem& subsystem : model.subsystems)
    for (const spatial::Body& body : subsystem.bodies)
      if (const auto* beam = std::get_if<spatial::Beam>(&body.shape))
        add_beam(beam->bodies, beam->elements, kPerNode, *this);
}

DampingFault find_damping_fault(const Damping& damping, const DampedBeams& beams) {
  DampingFault fault = find_fault(damping.directions, beams);
  return fault.text.empty() ? find_fault(damping.modes, beams) : fault;
}

Damping read_damping(const TomlSection& root, const DampedBeams& beams) {
  const TomlSection section =
      root.section("damping", keys::keys_of(keys::kDampingRows, keys::kBeamDampingRows));
  Damping damping;
  keys::read(section, keys::kDampingRows, &damping);
  damping.directions = read_directions(section, beams);
  damping.modes = read_modes(section);
  if (const DampingFault fault = find_damping_fault(damping, beams); !fault.text.empty())
    section.fail(section.has("mu") && !section.has(fault.key) ? "mu" : fault.key, fault.text);
  return damping;
}

Json damping_to_json(const Damping& damping) {
  Json json = {{"mass_factor", damping.mass_factor},
               {"stiffness_factor", damping.stiffness_factor}};
  visit_directions(damping.directions, [&](std::string_view key, const auto& factor, bool) {
    if (is_given(factor)) json.set(key, value_of(factor));
  });
  if (!damping.modes.ratios.empty()) json.set("ratios", damping.modes.ratios);
  if (damping.modes.above) json.set("above", *damping.modes.above);
  return json;
}

}  // namespace spoke
