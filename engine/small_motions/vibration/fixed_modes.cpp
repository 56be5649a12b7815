// Names and shapes of modes in multi-blade coordinates.

#include "engine/small_motions/vibration/fixed_modes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/eigenvalues.h"
#include "engine/small_motions/vibration/multi_blade.h"
#include "engine/small_motions/vibration/pattern_motion.h"
#include "engine/small_motions/vibration/support_names.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using steady::LinearModel;
using Complex = std::complex<double>;

constexpr Complex kI(0.0, 1.0);

/// Returns flap, lag, torsion and axial motion of all patterns, by which modes of equal roots are
/// told apart; then motion that is alike, and the senses of patterns that go round.
Features list_features(const VectorXcd& x, const SeenFromOutside& fixed) {
  Features kinds(4), patterns;
  const auto append = [](const VectorXcd& more, VectorXcd& list) {
    list.conservativeResize(list.size() + more.size());
    list.tail(more.size()) = more;
  };
  for (std::size_t k = 0; k < fixed.frame.patterns.size(); ++k) {
    const BladePattern& pattern = fixed.frame.patterns[k];
    const Index at = fixed.frame.start(k), n = pattern.size;
    std::vector<VectorXcd> parts = {x.segment(at, n)};
    if (pattern.is_pair) {
      const VectorXcd cosine = parts[0], sine = x.segment(at + n, n);
      parts = {(cosine + kI * sine) / std::sqrt(2.0), (cosine - kI * sine) / std::sqrt(2.0)};
    }
    for (const VectorXcd& part : parts) {
      const Features own = vibration::list_features(fixed.shape_of(k, part));
      VectorXcd& pattern_motion = patterns.emplace_back();
      for (std::size_t kind = 0; kind < 4; ++kind) {
        append(own[kind], kinds[kind]);
        append(own[kind], pattern_motion);
      }
    }
  }
  kinds.insert(kinds.end(), patterns.begin(), patterns.end());
  return kinds;
}

/// A mode whose name has no number yet.
struct Unnumbered {
  std::size_t pattern = 0;  ///< that moves most
  PatternMotion motion;
  double of_hub = 0.0;
  double magnitude = 0.0;  ///< of the root in the blades' frame [rad/s]
  std::string kind;        ///< of its motion
  std::string own_kind;    ///< the same, or "overdamped ..."
  bool is_of_support = false;
  bool is_of_hub = false;
  std::string rotors;  ///< that move, of several: "tail: ", "front + rear: "
};

Unnumbered describe(const Root& root, const SeenFromOutside& fixed,
                    std::map<std::string, KindNames>& kinds) {
  constexpr double kAlike = 1e-6;
  Unnumbered found;
  const VectorXcd hub = root.x.head(fixed.frame.model.M.rows());
  if (hub.size() > 0) found.of_hub = calc_mass(hub, calc_carried_mass(fixed.frame.model));
  std::vector<double> masses;  // by rotor, of the pattern that moves most
  for (std::size_t k = 0; k < fixed.frame.patterns.size(); ++k) {
    PatternMotion motion = describe_pattern(k, root, fixed);
    const std::size_t rotor = fixed.family_of(k).rotor;
    masses.resize(std::max(masses.size(), rotor + 1));
    masses[rotor] = std::max(masses[rotor], motion.mass);
    if (k > 0 && motion.mass <= found.motion.mass * (1.0 + kAlike)) continue;
    found.motion = std::move(motion);
    found.pattern = k;
  }
  found.magnitude = std::hypot(root.s.real(), found.motion.rate);
  if (fixed.all.linear.support && calc_mass(hub, fixed.frame.model.M) > found.motion.mass) {
    found.is_of_support = true;
    found.kind = name_support_motion(hub, fixed.all);
    return found;
  }
  const bool is_of_hub =
      fixed.frame.patterns.empty() || (found.of_hub > 0.5 && found.motion.mass < 0.25);
  if (is_of_hub) {
    found.is_of_hub = true;
    found.kind = "hub";
    return found;
  }
  if (const steady::SupportedModel* machine = fixed.all.model.on_support())
    found.rotors = machine->name_rotors(masses);
  found.kind =
      name_kind(found.pattern, found.motion, fixed, kinds[found.rotors + found.motion.name]);
  return found;
}

/// Returns the pattern of overdamped vibrations in which those of a pattern are: what creeps in the
/// blades' frame goes round with them, and has one of two senses.
std::string creeping_pattern(const std::string& name) {
  const std::string progressive = "progressive", regressive = "regressive";
  return name.starts_with(progressive) ? regressive + name.substr(progressive.size()) : name;
}

/// Returns for each mode its number among those of its kind and pattern, by magnitude in
/// the blades' frame. Those that are overdamped have numbers of their own, and count besides.
std::vector<int> number(const std::vector<Unnumbered>& modes) {
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> alike;
  std::map<std::pair<std::string, std::string>, int> creeping;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const std::string& rotors = modes[k].rotors;
    alike[{rotors + modes[k].own_kind, modes[k].motion.name}].push_back(k);
    if (modes[k].own_kind != modes[k].kind)
      ++creeping[{rotors + modes[k].kind, creeping_pattern(modes[k].motion.name)}];
  }
  std::vector<int> numbers(modes.size());
  for (auto& [name, list] : alike) {
    std::stable_sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
      return modes[a].magnitude < modes[b].magnitude;
    });
    const auto roots = creeping.find({name.first, creeping_pattern(name.second)});
    const int before = roots == creeping.end() ? 0 : count_overdamped(roots->second);
    for (std::size_t place = 0; place < list.size(); ++place)
      numbers[list[place]] = before + static_cast<int>(place) + 1;
  }
  return numbers;
}

/// Returns the roots that are wanted and those that count for their numbers: the blades' own
/// frequencies are up to n times the speed from those of the modes.
std::vector<Root> find_enough(Index wanted, Index size, const FixedFrame& frame) {
  constexpr Index kPartners = 8, kMost = 400;
  double shift = 0.0;
  for (const BladePattern& pattern : frame.patterns)
    if (pattern.is_pair)
      shift =
          std::max(shift, 2.0 * pattern.multiple * std::abs(frame.families[pattern.family].speed));
  for (Index count = std::min(wanted + kPartners, size);; count = std::min(2 * count, size)) {
    std::vector<Root> roots = find_fixed_roots(frame, count);
    if (roots.empty() || count == size || count > kMost) return roots;
    const Root& last = roots[static_cast<std::size_t>(std::min(wanted, std::ssize(roots))) - 1];
    const double reach = std::abs(last.s) + shift;
    if (std::abs(roots.back().s) > reach) return roots;
  }
}

/// Returns the mode with its shape, as blades move where they stand at t = 0.
Mode make_fixed_mode(const Root& root, const Unnumbered& found, const SeenFromOutside& fixed) {
  Mode mode = make_mode(root);
  mode.coordinates = found.motion.is_conjugate ? VectorXcd(root.x.conjugate()) : root.x;
  mode.kind = found.own_kind;
  const Linearised& all = fixed.all;
  mode.of =
      all.linear.is_coupled()
          ? "all"
          : name_subsystems(find_like(fixed.first_of(found.pattern), all.linear.alike), all.model);
  const VectorXcd hub = root.x.head(fixed.frame.model.M.rows());
  set_hub_motion(hub, all, mode);
  EnergySum energies(all);
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    const VectorXcd y = fixed.frame.motion_of(i, root.x);
    const SubsystemShape shape =
        calc_subsystem_shape(i, all.equilibrium.q[i], all.linear.motion_of(i, y, hub), all.model);
    energies.add(i, shape);
    add_shape(i, shape, all.model, mode);
  }
  vibration::normalise(mode);
  mode.energy = energies.share_out(found.of_hub);
  mode.weighed = energies.weigh(hub, calc_carried_mass(fixed.frame.model));
  if (found.motion.is_conjugate) mode.weighed = mode.weighed.conjugate().eval();
  return mode;
}

/// Returns what the name of a pattern adds to that of a mode.
std::string of_pattern(const std::string& name) { return name.empty() ? name : ' ' + name; }

/// Whether a mode at zero goes on as it was set off: one that gyroscopic forces hold has a sense.
bool goes_on(const Root& root) {
  return root.s == 0.0 && root.x.imag().squaredNorm() < 1e-6 * root.x.squaredNorm();
}

}  // namespace

void add_fixed_modes(const ModeCount& count, const Linearised& all, ModesResult& result) {
  const FixedFrame frame = see_from_outside(all);
  const SeenFromOutside fixed{all, frame};
  const Index size = frame.start(frame.patterns.size());
  if (size == 0)
    throw InputError("nothing of the model moves, expected a body or a joint that does");
  const Index wanted = find_count(count, size, "the model", result);
  std::vector<Root> roots = find_enough(wanted, size, frame);
  separate_equal_roots(
      Pencil(frame.model), [&](const VectorXcd& x) { return list_features(x, fixed); }, roots);
  std::map<std::string, KindNames> kinds;
  std::vector<Unnumbered> modes;
  for (const Root& root : roots) {
    Unnumbered& mode = modes.emplace_back(describe(root, fixed, kinds));
    const bool is_of_blades = !mode.is_of_support && !mode.is_of_hub;
    mode.own_kind = kind_with_damping(mode.kind, root.s,
                                      is_of_blades ? mode.motion.rate : std::abs(root.s.imag()));
  }
  const std::vector<int> numbers = number(modes);
  Numbering rigid, hub, support;
  for (std::size_t k = 0; k < roots.size() && std::cmp_less(k, wanted); ++k) {
    Mode mode = make_fixed_mode(roots[k], modes[k], fixed);
    if (goes_on(roots[k]))
      rigid.name("rigid motion", mode);
    else if (modes[k].is_of_support)
      support.name_further(mode.kind, mode);
    else if (modes[k].is_of_hub)
      hub.name(mode.kind, mode);
    else
      mode.name = modes[k].rotors + mode.kind + ' ' + std::to_string(numbers[k]) +
                  of_pattern(modes[k].motion.name);
    result.modes.push_back(std::move(mode));
  }
}

}  // namespace spoke::vibration
