// Names and shapes of the strongest harmonics.

#include "engine/small_motions/vibration/floquet_modes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "engine/small_motions/vibration/floquet.h"
#include "engine/small_motions/vibration/periodic_frame.h"
#include "engine/small_motions/vibration/periodic_orbit.h"
#include "engine/small_motions/vibration/support_names.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

/// A model's periodic system, and what it was made from.
struct Periodically {
  const Linearised& all;
  const PeriodicFrame& frame;
  const PeriodicSystem& system;

  VectorXcd part_of(std::size_t i, const VectorXcd& x) const {
    return frame.motion_of(i, x, system);
  }
};

/// Whether a motion goes on as it was set off: its multiplier is one, known to half of the digits
/// where two are equal.
bool is_rigid(const PeriodicMode& mode, double speed) {
  constexpr double kHalf = 1e-4;
  return std::abs(mode.s) < kHalf * std::abs(speed) && std::abs(mode.multiplier - 1.0) < kHalf;
}

const VectorXcd& strongest(const PeriodicMode& mode) {
  return std::find_if(mode.harmonics.begin(), mode.harmonics.end(),
                      [](const Harmonic& harmonic) { return harmonic.multiple == 0; })
      ->amplitude;
}

std::vector<ModeHarmonic> list_harmonics(const PeriodicMode& mode, const PeriodicSystem& system) {
  constexpr double kLeast = 1e-6;
  const Index h = system.hub;
  const Eigen::MatrixXd& M = system.M.parts[0];
  std::vector<ModeHarmonic> list;
  for (const Harmonic& harmonic : mode.harmonics) {
    if (harmonic.share < kLeast) continue;
    const double hub = calc_mass(harmonic.amplitude.head(h), M.topLeftCorner(h, h));
    list.push_back({harmonic.multiple,
                    std::abs(mode.s.imag() + harmonic.multiple * std::abs(system.speed)),
                    harmonic.share, harmonic.share * hub / calc_mass(harmonic.amplitude, M)});
  }
  return list;
}

/// Names the pattern in which the subsystems that are like subsystem `i` move.
std::string find_pattern(std::size_t i, const VectorXcd& x, const Periodically& rotor) {
  std::vector<VectorXcd> subsystems;
  std::vector<double> azimuths;
  for (const std::size_t k : find_like(rotor.all.linear.alike[i], rotor.all.linear.alike)) {
    subsystems.push_back(rotor.part_of(k, x));
    azimuths.push_back(rotor.all.model.azimuth(k));
  }
  return name_pattern(subsystems, azimuths);
}

/// A mode without a number in its name, which is that of its pattern.
struct UnnumberedMode {
  Mode mode;
  std::string rotors{};  ///< before its name
  double rate = 0.0;  ///< at which what moves most vibrates where its forces are constant [rad/s]
};

/// Names kind and pattern of a mode `x` in which subsystem `most` moves most, as seen from its hub.
void name_turning(std::size_t most, const VectorXcd& x, const SubsystemShape& shape,
                  const Periodically& rotor, KindNames& kinds, UnnumberedMode& made) {
  const Linearised& all = rotor.all;
  made.mode.kind = kinds.name(list_independent(most, all.linear, all.model), rotor.part_of(most, x),
                              all.linear.subsystem(most).M, shape);
  if (rotor.system.hub > 0) made.mode.name = find_pattern(most, x, rotor);
}

/// The same of a rotor that is seen from outside.
void name_outside(std::size_t most, const VectorXcd& x, const Periodically& rotor, KindNames& kinds,
                  UnnumberedMode& made) {
  const SeenFromOutside outside = rotor.frame.outside();
  const Root root{made.mode.eigenvalue, rotor.frame.motion_outside(x, rotor.system)};
  std::size_t largest = 0;
  PatternMotion motion;
  for (const std::size_t pattern : rotor.frame.patterns_of(most)) {
    PatternMotion own = describe_pattern(pattern, root, outside);
    if (own.mass <= motion.mass) continue;
    motion = std::move(own);
    largest = pattern;
  }
  made.mode.kind = name_kind(largest, motion, outside, kinds);
  made.mode.name = motion.name;
  made.rate = motion.rate;
}

/// Returns a mode by its strongest harmonic, its name without a number: kind and pattern. `kinds`:
/// by whose modes they are.
UnnumberedMode make_periodic_mode(const PeriodicMode& periodic, const Periodically& rotor,
                                  std::map<std::string, KindNames>& kinds) {
  const Linearised& all = rotor.all;
  const VectorXcd x =
      strongest(periodic) / std::sqrt(calc_mass(strongest(periodic), rotor.system.M.parts[0]));
  const VectorXcd hub = x.head(rotor.system.hub);
  UnnumberedMode made{make_mode({is_rigid(periodic, rotor.system.speed) ? 0.0 : periodic.s, {}})};
  Mode& mode = made.mode;
  made.rate = mode.frequency;
  mode.coordinates = x;
  mode.harmonics = list_harmonics(periodic, rotor.system);
  set_hub_motion(hub, all, mode);
  EnergySum energies(all);
  constexpr double kAlike = 1e-6;  // of subsystems that move equally the first one counts
  std::size_t most = 0;
  SubsystemShape largest;
  std::vector<double> motions;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    SubsystemShape shape = calc_subsystem_shape(
        i, all.equilibrium.q[i], all.linear.motion_of(i, rotor.part_of(i, x), hub), all.model);
    energies.add(i, shape);
    add_shape(i, shape, all.model, mode);
    motions.push_back(shape.total());
    if (all.model.stands(i) || shape.total() <= largest.total() * (1.0 + kAlike)) continue;
    largest = std::move(shape);
    most = i;
  }
  vibration::normalise(mode);
  mode.of = hub.size() > 0 ? "all" : all.model.name_of(most);
  const Index h = hub.size();
  Eigen::MatrixXd carried = rotor.system.M.parts[0].topLeftCorner(h, h);
  if (all.linear.support) carried -= all.linear.support->M;
  const double of_hub = h > 0 ? calc_mass(hub, carried) : 0.0;
  mode.energy = energies.share_out(of_hub);
  mode.weighed = energies.weigh(hub, carried);
  if (all.linear.support && is_of_support(mode.energy)) {
    mode.kind = name_support_motion(hub, all);
    return made;
  }
  if (largest.total() == 0.0 || (of_hub > 0.5 && largest.total() < 0.25)) {
    mode.kind = "hub";
    return made;
  }
  made.rotors = name_rotors(motions, all.model);
  KindNames& own_kinds = kinds[made.rotors + mode.of];
  if (rotor.frame.is_outside(most))
    name_outside(most, x, rotor, own_kinds, made);
  else
    name_turning(most, x, largest, rotor, own_kinds, made);
  return made;
}

}  // namespace

void add_floquet_modes(const ModeCount& count, const Linearised& all, steady::SteadyModel* whole,
                       ModesResult& result) {
  const PeriodicFrame frame(all);
  PeriodicSystem system = frame.make_system();
  if (system.size() == 0)
    throw InputError("nothing of the model moves, expected a body or a joint that does");
  const Index wanted = find_count(count, system.size(), "the model", result);
  require_periodic(system);
  if (whole && can_have_orbit(all)) {
    if (const auto orbit = find_periodic_orbit(all, system, *whole))
      system = linearise_along(*orbit, all, system, *whole);
  } else if (whole && is_turned_against(all, *whole)) {
    result.notes.emplace_back(
        "gravity, loads and wind across the axis count by their part along it alone: the periodic "
        "motion under them is found where the hub has no motion but its turn, springs hold all "
        "closures of loops, and no joint relaxes");
  }
  const Periodically rotor{all, frame, system};
  std::map<std::string, int> numbers;
  std::map<std::string, KindNames> kinds;
  int standing = 0;
  for (const PeriodicMode& periodic : find_periodic_modes(system, wanted + system.hub)) {
    // Two multipliers of one belong to each motion that goes on.
    if (is_rigid(periodic, system.speed) && ++standing % 2 == 0) continue;
    if (std::ssize(result.modes) == wanted) break;
    auto [mode, rotors, rate] = make_periodic_mode(periodic, rotor, kinds);
    const std::string pattern = mode.kind == "hub" || mode.name.empty() ? "" : ' ' + mode.name;
    mode.kind = kind_with_damping(mode.kind, mode.eigenvalue, rate);
    const std::string kind = mode.eigenvalue == 0.0 ? "rigid motion" : mode.kind;
    const std::string after = mode.eigenvalue == 0.0 ? "" : pattern;
    const int number = ++numbers[mode.of + rotors + kind + after];
    const bool is_alone = number == 1 && all.linear.support && is_of_support(mode.energy);
    mode.name = rotors + kind + (is_alone ? "" : ' ' + std::to_string(number)) + after;
    result.modes.push_back(std::move(mode));
  }
}

}  // namespace spoke::vibration
