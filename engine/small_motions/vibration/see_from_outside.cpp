// Takes rotors to multi-blade coordinates, one by one, and puts them on their support.

#include <algorithm>
#include <string>
#include <vector>

#include "engine/small_motions/steady/at_azimuth.h"
#include "engine/small_motions/steady/joined_rotors.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/blade_rings.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/shaft_turn.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using steady::LinearModel;

/// Throws InputError unless the matrices of shafts, as seen from outside, are constant; at rest
/// they are.
void require_round(const std::vector<Eigen::MatrixXd>& turns, const Linearised& all) {
  const double psi = steady::kElsewhere;
  const auto is_shaft = [](const Eigen::MatrixXd& turn) { return turn.size() > 0; };
  if (!all.model.turns() || std::none_of(turns.begin(), turns.end(), is_shaft)) return;
  LinearModel turned;
  const bool depends = steady::depends_on_azimuth(all.model);
  if (depends) turned = steady::linearize_at(psi, all.equilibrium, all.model);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double speed = all.model.speed_of(i);
    if (turns[i].size() == 0 || speed == 0.0) continue;
    const steady::LinearSubsystem& here = all.linear.subsystem(i);
    if (!are_same(with_sizes(stand_shaft(here, turns[i], speed)),
                  stand_shaft_at(psi, depends ? turned.subsystem(i) : here, turns[i], speed),
                  speed))
      throw InputError(
          "the frame \"fixed\" expects shafts whose mass and stiffness are alike in all directions "
          "across the hub's axis, as those of " +
          all.model.name_of(i) + " are not: of modes the frame \"floquet\" takes any shafts");
  }
}

/// Returns how shafts turn, by subsystem: of what is not one of three or more that are alike.
std::vector<Eigen::MatrixXd> find_turns(const Linearised& all) {
  std::vector<Eigen::MatrixXd> turns(all.model.subsystems());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (all.model.stands(i) || find_like(all.linear.alike[i], all.linear.alike).size() > 2)
      continue;
    turns[i] = find_turn(i, all);
  }
  return turns;
}

/// Takes a rotor on a support to multi-blade coordinates. `turns`, `rings`: of all subsystems.
FixedFrame see_rotor(std::size_t r, const Linearised& all,
                     const std::vector<Eigen::MatrixXd>& turns,
                     const std::vector<BladeRing>& rings) {
  const steady::SupportedModel& machine = *all.model.on_support();
  const steady::RotorParts& rotor = machine.parts(r);
  std::vector<double> azimuths;
  std::vector<std::string> names;
  std::vector<Eigen::MatrixXd> own_turns;
  std::vector<BladeRing> own_rings;
  for (const std::size_t i : rotor.subsystems) {
    azimuths.push_back(machine.azimuth(i));
    names.push_back(machine.name_of(i));
    own_turns.push_back(turns[i]);
    own_rings.push_back(rings[i]);
  }
  return make_fixed_frame(steady::take_rotor(all.linear, r, rotor.subsystems), azimuths, names,
                          make_standing_axes(machine.free_components(), true, rotor.speed),
                          own_turns, own_rings);
}

/// Takes all rotors on a support there, each in its own turning frame.
FixedFrame see_rotors(const steady::SupportedModel& machine, const Linearised& all,
                      const std::vector<Eigen::MatrixXd>& turns) {
  const std::vector<BladeRing> rings = find_rings(all);
  std::vector<FixedFrame> rotors;
  std::vector<std::vector<std::size_t>> subsystems;
  for (std::size_t r = 0; r < machine.rotors(); ++r) {
    rotors.push_back(see_rotor(r, all, turns, rings));
    subsystems.push_back(machine.parts(r).subsystems);
  }
  return join(rotors, subsystems);
}

}  // namespace

FixedFrame see_rotor_from_outside(std::size_t rotor, const Linearised& all) {
  std::vector<Eigen::MatrixXd> turns = find_turns(all);
  for (std::size_t i = 0; i < turns.size(); ++i)
    if (all.model.stands(i) || all.model.on_support()->rotor_of(i) != rotor) turns[i].resize(0, 0);
  require_round(turns, all);
  return see_rotor(rotor, all, turns, find_rings(all));
}

bool is_even(std::size_t rotor, const Linearised& all) {
  try {
    see_rotor_from_outside(rotor, all);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

FixedFrame see_from_outside(const Linearised& all) {
  const std::vector<Eigen::MatrixXd> turns = find_turns(all);
  require_round(turns, all);
  if (const steady::SupportedModel* machine = all.model.on_support()) {
    const steady::LinearSupport& support = *all.linear.support;
    return stand_on(see_rotors(*machine, all, turns), support.J, {support.M, support.C, support.K});
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) names.push_back(all.model.name_of(i));
  return make_fixed_frame(
      all.linear, all.model.azimuths(), names,
      make_standing_axes(all.model.free_components(), all.model.is_spatial(), all.model.speed()),
      turns, find_rings(all));
}

}  // namespace spoke::vibration
