// Names and shapes of the strongest harmonics.

#include "engine/small_motions/vibration/floquet_modes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/floquet.h"
#include "engine/small_motions/vibration/periodic_orbit.h"
#include "engine/small_motions/vibration/support_names.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

/// A rotor's periodic system, and what it was made from.
struct Periodically {
  const Linearised& all;
  const PeriodicSystem& system;

  VectorXcd part_of(std::size_t i, const VectorXcd& x) const {
    return x.segment(system.starts[i], all.linear.subsystem(i).M.rows());
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
};

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
  mode.kind = kinds[made.rotors + mode.of].name(list_independent(most, all.linear, all.model),
                                                rotor.part_of(most, x),
                                                all.linear.subsystem(most).M, largest);
  if (hub.size() > 0) mode.name = find_pattern(most, x, rotor);
  return made;
}

/// Takes a rotor to standing axes at the hub. What springs do that its hub turns against, which
/// meet the axes of the hub twice, is of second degree, beside turning the hub's own coordinates
/// and equations.
PeriodicSystem make_periodic_of(const Linearised& all, const StandingAxes& axes) {
  constexpr int kParts = 9;
  PeriodicSystem system = make_periodic(all.linear, axes);
  if (!steady::depends_on_azimuth(all.model)) return system;
  std::vector<Eigen::MatrixXd> M, C, K;
  for (int k = 0; k < kParts; ++k) {
    const double psi = 2.0 * std::numbers::pi * k / kParts;
    const PeriodicSystem there =
        make_periodic(steady::linearize_at(psi, all.equilibrium, all.model), axes);
    M.push_back(there.M.at(psi));
    C.push_back(there.C.at(psi));
    K.push_back(there.K.at(psi));
  }
  system.M = interpolate(M);
  system.C = interpolate(C);
  system.K = interpolate(K);
  return system;
}

/// Returns the standing axes of all hubs, by the azimuth of the first one that turns: the others
/// are as fast as it, or turn against it, or stand.
StandingAxes make_axes(const steady::SteadyModel& model) {
  const std::vector<int>& components = model.free_components();
  const steady::SupportedModel* machine = model.on_support();
  if (!machine || machine->rotors() == 1)
    return make_standing_axes(components, model.is_spatial(), model.speed());
  const Index count = 6 * static_cast<Index>(machine->rotors());
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, count);
  StandingAxes all{{zero, zero, zero}, zero};
  for (std::size_t r = 0; r < machine->rotors(); ++r) {
    const Index at = 6 * static_cast<Index>(r);
    const double speed = machine->parts(r).speed;
    const StandingAxes own = make_standing_axes(components, true, speed);
    if (all.speed == 0.0) all.speed = speed;
    const double sense = (speed > 0.0) == (all.speed > 0.0) ? 1.0 : -1.0;
    all.W.block<6, 6>(at, at) = own.W;
    all.T.mean.block<6, 6>(at, at) = speed == 0.0 ? own.T.at(0.0) : own.T.mean;
    if (speed == 0.0) continue;
    all.T.cosine.block<6, 6>(at, at) = own.T.cosine;
    all.T.sine.block<6, 6>(at, at) = sense * own.T.sine;
  }
  return all;
}

}  // namespace

void add_floquet_modes(const ModeCount& count, const Linearised& all, steady::SteadyModel* whole,
                       ModesResult& result) {
  const StandingAxes axes = make_axes(all.model);
  PeriodicSystem system = make_periodic_of(all, axes);
  if (const auto& support = all.linear.support)
    system = stand_on(system, support->J, {support->M, support->C, support->K});
  if (system.size() == 0)
    throw InputError("nothing of the model moves, expected a body or a joint that does");
  if (const steady::SupportedModel* machine = all.model.on_support();
      !machine || machine->rotors() == 1) {
    system.alike = all.linear.alike;
    system.azimuths = all.model.azimuths();
  }
  const Index wanted = find_count(count, system.size(), "the model", result);
  require_periodic(system);
  if (whole && can_have_orbit(all))
    if (const auto orbit = find_periodic_orbit(all, system, *whole))
      system = linearise_along(*orbit, all, system, *whole);
  const Periodically rotor{all, system};
  std::map<std::string, int> numbers;
  std::map<std::string, KindNames> kinds;
  int standing = 0;
  for (const PeriodicMode& periodic : find_periodic_modes(system, wanted + system.hub)) {
    // Two multipliers of one belong to each motion that goes on.
    if (is_rigid(periodic, system.speed) && ++standing % 2 == 0) continue;
    if (std::ssize(result.modes) == wanted) break;
    auto [mode, rotors] = make_periodic_mode(periodic, rotor, kinds);
    const std::string pattern = mode.kind == "hub" || mode.name.empty() ? "" : ' ' + mode.name;
    mode.kind = kind_with_damping(mode.kind, mode.eigenvalue, mode.frequency);
    const std::string kind = mode.eigenvalue == 0.0 ? "rigid motion" : mode.kind;
    const std::string after = mode.eigenvalue == 0.0 ? "" : pattern;
    const int number = ++numbers[mode.of + rotors + kind + after];
    const bool is_alone = number == 1 && all.linear.support && is_of_support(mode.energy);
    mode.name = rotors + kind + (is_alone ? "" : ' ' + std::to_string(number)) + after;
    result.modes.push_back(std::move(mode));
  }
}

}  // namespace spoke::vibration
