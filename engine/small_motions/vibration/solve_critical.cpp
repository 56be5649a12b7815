// Scans a range, and narrows the first loss of stability down.

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "engine/critical.h"
#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/small_motions/vibration/choose_frame.h"
#include "engine/small_motions/vibration/equilibrium_path.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/follow_modes.h"
#include "engine/small_motions/vibration/solve_modes.h"
#include "engine/small_motions/vibration/stability.h"
#include "engine/small_motions/vibration/varied_load.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

using vibration::EquilibriumPath;
using vibration::PathPlace;
using vibration::RootStability;

constexpr int kModes = 10;  ///< modes, unless the options say how many
constexpr int kSpareModes =
    4;  ///< modes beyond those that are followed, one of which may come down
constexpr double kResolution = 1e-10;  ///< of the critical value, by its size
constexpr double kBeyond = 1e-6;       ///< distance of the modes that are shown, likewise
/// Real part by magnitude from which a root grows, as Mode::grows() has it, and a larger one.
constexpr double kGrows = 1e-6, kGrowsMore = 1e-5;
/// Speed in place of zero: what turns against a turning hub does not act at the first speed alone.
constexpr double kAlmostRest = 1e-100;

/// What is varied.
struct Parameter {
  std::string load;            ///< empty: the speed
  std::vector<double> speeds;  ///< of rotors, unless it is varied [rad/s]

  bool is_speed() const { return load.empty(); }
  std::string describe(double value) const {
    std::ostringstream text;
    if (is_speed())
      text << value << " rad/s";
    else
      text << value << " times the load \"" << load << '"';
    return text.str();
  }
};

Parameter read_parameter(const Scenario& scenario, const CriticalOptions& options) {
  const std::string load = "load=";
  if (options.of == "speed") {
    if (options.state.speed || !options.state.speeds.empty())
      throw InputError("a speed is given, expected none: it is the speed that is varied");
    return {};
  }
  if (!options.of.starts_with(load) || options.of == load)
    throw InputError("what is varied is \"" + options.of +
                     "\", expected \"speed\" or \"load=NAME\"");
  const std::string name = options.of.substr(load.size());
  vibration::require_load(scenario, name);
  return {name, steady::find_steady_speeds(scenario, options.state)};
}

void check(const CriticalOptions& options) {
  for (const double value : {options.from, options.to})
    if (const std::string expected = kFactor.expectation_instead_of(value); !expected.empty())
      throw InputError("an end of the range is " + spoke::describe(value) + ", expected " +
                       expected);
  if (!(options.to > options.from))
    throw InputError("the range goes from " + spoke::describe(options.from) + " to " +
                     spoke::describe(options.to) + ", expected it to ascend");
  if (options.points < 2)
    throw InputError(std::to_string(options.points) + " points, expected 2 or more");
  if (options.count && *options.count < 1)
    throw InputError(std::to_string(*options.count) + " modes, expected 1 or more");
}

/// Returns the step below which a path ends: far below the resolution of the critical value, but
/// one that values still have.
double find_resolution(const CriticalOptions& options) {
  const double largest = std::max(std::abs(options.from), std::abs(options.to));
  return std::max(0.1 * kResolution * (options.to - options.from),
                  8.0 * std::numeric_limits<double>::epsilon() * largest);
}

/// A place with what is known of small motions there.
struct Sample {
  PathPlace place;
  steady::LinearModel linear;
  RootStability stability;

  double value() const { return place->value; }
};

/// Returns the frame in which stability is judged: a rotor that turns on a support has no constant
/// matrices but as seen from outside.
ModeFrame choose_frame(const Scenario& scenario, const Parameter& parameter,
                       std::optional<ModeFrame> asked) {
  const auto is_fast = [](double speed) { return speed != 0.0; };
  const bool turns = parameter.is_speed() ||
                     std::any_of(parameter.speeds.begin(), parameter.speeds.end(), is_fast);
  if (asked == ModeFrame::floquet)
    throw InputError(
        "the frame is \"floquet\", expected \"turning\" or \"fixed\": a critical value is one of "
        "constant matrices");
  if (asked == ModeFrame::turning && turns && scenario.space && scenario.space->support)
    throw InputError(
        "the frame \"turning\" expects a hub whose support does not move, or a load that is varied "
        "at a speed of 0: on a support that turns the frame \"fixed\" has constant matrices");
  if (asked) return *asked;
  return turns ? vibration::choose_frame(scenario, std::nullopt) : ModeFrame::turning;
}

/// A search over the range.
class Search {
 public:
  Search(const Scenario& scenario, const CriticalOptions& options)
      : scenario_(scenario),
        options_(options),
        parameter_(read_parameter(scenario, options)),
        frame_(choose_frame(scenario, parameter_, options.frame)),
        path_([this](double value) { return make_model(value); }, find_resolution(options)) {}

  CriticalResult run() {
    Sample last = look(path_.begin(options_.from));
    require_stable(last);
    add(last);
    tell(1);
    for (int k = 1; k < options_.points; ++k) {
      const auto [place, is_lost] = path_.go(last.place, point(k));
      Sample next = look(place);
      if (!result_.critical) {
        narrow(last, next);
        if (!result_.critical && is_lost) add_end(last, next);
      }
      if (is_lost) break;
      add(next);
      last = std::move(next);
      tell(k + 1);
    }
    follow();
    return std::move(result_);
  }

 private:
  std::unique_ptr<steady::SteadyModel> make_model(double value) const {
    if (parameter_.is_speed())
      return steady::make_steady_model(
          scenario_, steady::at_speeds(
                         steady::scale_steady_speeds(scenario_, value == 0.0 ? kAlmostRest : value),
                         {.is_axial = is_outside()}));
    Scenario loaded = scenario_;
    vibration::multiply_load(parameter_.load, value, loaded);
    return steady::make_steady_model(
        loaded, steady::at_speeds(parameter_.speeds, {.is_axial = is_outside()}));
  }

  bool is_outside() const { return frame_ == ModeFrame::fixed; }

  double point(int k) const {
    if (k + 1 == options_.points) return options_.to;
    return options_.from + k * (options_.to - options_.from) / (options_.points - 1);
  }

  /// Returns a distance at a value, by its size, or by a small part of the range if that is more.
  double distance_at(double value, double share) const {
    return share * std::max(std::abs(value), 1e-3 * (options_.to - options_.from));
  }

  int count() const { return options_.count.value_or(kModes) + kSpareModes; }

  Sample look(PathPlace place) const {
    steady::LinearModel linear = steady::linearize_machine(place->equilibrium, *place->model);
    if (is_outside()) {
      const RootStability stability = vibration::assess_stability(
          vibration::see_from_outside({*place->model, place->equilibrium, linear}), count());
      return {std::move(place), std::move(linear), stability};
    }
    steady::require_constant(linear, place->equilibrium, *place->model);
    if (linear.support) steady::stand_on(*linear.support, linear);
    const RootStability stability =
        vibration::assess_stability(linear, place->model->azimuths(), count());
    return {std::move(place), std::move(linear), stability};
  }

  ModesResult describe(const Sample& sample) const {
    ModesResult modes =
        vibration::make_modes(sample.linear, sample.place->equilibrium, frame_,
                              {options_.count.value_or(0), count()}, *sample.place->model);
    if (parameter_.is_speed()) modes.equilibrium.speed = sample.value();
    steady::add_warnings(scenario_, modes.equilibrium);
    return modes;
  }

  void add(const Sample& sample) {
    result_.values.push_back(sample.value());
    result_.states.push_back(describe(sample));
    softest_ = std::max(softest_, sample.stability.softest);
  }

  void tell(int done) const {
    if (options_.progress) options_.progress(static_cast<std::size_t>(done));
  }

  void require_stable(const Sample& first) const {
    if (first.stability.growth <= kGrows) return;
    const ModesResult found = describe(first);
    const Mode& mode = found.modes[find_nearest(found, first.stability.growing)];
    std::ostringstream text;
    text << "at " << parameter_.describe(first.value())
         << " the equilibrium is unstable already: " << mode.name << " of " << mode.of
         << " grows by " << mode.eigenvalue.real()
         << " per s, expected a range that begins where it is stable";
    throw InputError(text.str());
  }

  /// Two places next to each other, between which something is lost.
  struct Pair {
    Sample good, bad;
  };
  using IsBad = std::function<bool(const RootStability&)>;

  /// Narrows a pair down to a distance, or as far as equilibria are found: where the stiffness is
  /// nearly singular, round-off moves them.
  Pair bisect(Sample good, Sample bad, const IsBad& is_bad, double share) const {
    while (bad.value() - good.value() > distance_at(bad.value(), share)) {
      const double middle = 0.5 * (good.value() + bad.value());
      if (middle == good.value() || middle == bad.value()) break;
      EquilibriumPath::Reached reached = path_.go(good.place, middle);
      if (reached.is_lost) reached = path_.go(bad.place, middle);
      if (reached.is_lost) break;
      Sample between = look(std::move(reached.place));
      (is_bad(between.stability) ? bad : good) = std::move(between);
    }
    return {std::move(good), std::move(bad)};
  }

  /// Whether a motion is no longer held between two places next to each other, where its stiffness
  /// is near zero. Otherwise it only came into the number of those that are looked at.
  static bool loses_stiffness(const RootStability& good, const RootStability& bad) {
    constexpr double kNearZero = 1e-6;
    return bad.rigid > good.rigid || bad.softest <= kNearZero * bad.stiffest;
  }

  /// Narrows the first loss between two places down, if there is one.
  void narrow(const Sample& last, const Sample& next) {
    std::optional<Pair> stiffness;
    if (next.stability.unheld > last.stability.unheld) {
      const std::size_t held = last.stability.unheld;
      stiffness = bisect(
          last, next, [held](const RootStability& at) { return at.unheld > held; }, kResolution);
      if (!loses_stiffness(stiffness->good.stability, stiffness->bad.stability)) stiffness.reset();
    }
    const Sample& end = stiffness ? stiffness->good : next;
    if (end.stability.growth > kGrows) {
      const Pair growth = bisect(
          last, end, [](const RootStability& at) { return at.growth > kGrows; }, kResolution);
      const double distance = end.value() - growth.bad.value();
      if (!stiffness || distance > distance_at(end.value(), kBeyond))
        return add_growth(last, growth, end);
    }
    if (stiffness) add_softening(last, *stiffness, next);
  }

  /// Adds that a motion is no longer held. `start`, `end`: places before and behind.
  void add_softening(const Sample& start, const Pair& pair, const Sample& end) {
    CriticalPoint critical;
    critical.value = 0.5 * (pair.good.value() + pair.bad.value());
    critical.resolution = 0.5 * (pair.bad.value() - pair.good.value());
    const double target = critical.value + distance_at(critical.value, kBeyond);
    EquilibriumPath::Reached reached = path_.go(pair.bad.place, target);
    if (reached.is_lost && end.value() > target) reached = path_.go(end.place, target);
    if (reached.is_lost) return add_end(start, pair.good);
    const Sample beyond = look(std::move(reached.place));
    const ModesResult found = describe(beyond);
    const bool grows = beyond.stability.growth > kGrows;
    if (found.equilibrium.speed == 0.0)
      critical.kind = CriticalKind::buckling;
    else if (grows && beyond.stability.growing.imag() == 0.0)
      critical.kind = CriticalKind::divergence;
    else
      critical.kind = CriticalKind::critical_speed;
    put(critical, grows ? find_nearest(found, beyond.stability.growing) : find_softest(found),
        found);
  }

  /// Adds that a root grows. Its real part is known where it is kGrows by magnitude; where that
  /// comes slowly, in proportion, it is zero before, which a second place tells.
  void add_growth(const Sample& start, const Pair& pair, const Sample& end) {
    const Pair more =
        end.stability.growth > kGrowsMore
            ? bisect(
                  pair.bad, end, [](const RootStability& at) { return at.growth > kGrowsMore; },
                  1e-8)
            : Pair{pair.bad, end};
    const double from = 0.5 * (pair.good.value() + pair.bad.value());
    const double slope = (more.bad.stability.growth - kGrows) / (more.bad.value() - from);
    CriticalPoint critical;
    critical.value = std::max(start.value(), from - kGrows / slope);
    critical.resolution = 0.5 * (pair.bad.value() - pair.good.value());
    critical.frequency = pair.bad.stability.growing.imag();
    critical.kind = critical.frequency > 0.0 ? CriticalKind::flutter : CriticalKind::divergence;
    const auto [place, is_lost] = path_.go(pair.bad.place, from + distance_at(from, kBeyond));
    const ModesResult found = describe(is_lost ? pair.bad : look(place));
    put(critical, find_nearest(found, pair.bad.stability.growing), found);
  }

  /// Adds that no equilibrium is found beyond a place. `start`: one before it.
  void add_end(const Sample& start, const Sample& end) {
    CriticalPoint critical;
    critical.value = end.value();
    critical.resolution = path_.resolution();
    const double before = critical.value - distance_at(critical.value, kBeyond);
    const Sample near = before > start.value() ? look(path_.go(start.place, before).place) : end;
    const bool is_soft =
        end.stability.unheld > start.stability.unheld || end.stability.softest <= 0.05 * softest_;
    critical.kind = is_soft ? CriticalKind::limit_point : CriticalKind::no_equilibrium;
    const ModesResult found = describe(near);
    const std::optional<ModesResult> other = find_other_state(critical.value);
    if (other) {
      critical.kind = CriticalKind::jump;
      critical.beyond = result_.states.size() + 1;
    }
    put(critical, find_softest(found), found);
    if (!other) return;
    result_.values.push_back(other->equilibrium.speed);
    result_.states.push_back(*other);
  }

  /// Returns the steady state to which a rotating model jumps where the one that was followed ends;
  /// none if there is none, or at rest, where a snap through has its own name.
  std::optional<ModesResult> find_other_state(double end) const {
    if (!parameter_.is_speed() || end == 0.0) return std::nullopt;
    try {
      return describe(look(path_.begin(end + distance_at(end, kBeyond))));
    } catch (const DivergenceError&) {
      return std::nullopt;
    }
  }

  void put(CriticalPoint critical, std::size_t mode, const ModesResult& found) {
    critical.state = result_.states.size();
    if (mode < found.modes.size()) critical.mode = mode;
    result_.values.push_back(critical.value);
    result_.states.push_back(found);
    result_.critical = critical;
  }

  /// Returns the mode whose root is nearest; the number of modes if there are none.
  static std::size_t find_nearest(const ModesResult& found, std::complex<double> root) {
    const auto nearest = std::min_element(
        found.modes.begin(), found.modes.end(), [root](const Mode& a, const Mode& b) {
          return std::abs(a.eigenvalue - root) < std::abs(b.eigenvalue - root);
        });
    return static_cast<std::size_t>(nearest - found.modes.begin());
  }

  /// Returns the mode of least frequency that is not rigid; the number of modes if all are.
  static std::size_t find_softest(const ModesResult& found) {
    std::size_t least = found.modes.size();
    for (std::size_t m = 0; m < found.modes.size(); ++m) {
      const double size = std::abs(found.modes[m].eigenvalue);
      if (size == 0.0) continue;
      if (least == found.modes.size() || size < std::abs(found.modes[least].eigenvalue)) least = m;
    }
    return least;
  }

  /// Follows the modes over all values; the critical one is in a branch, and is called as it is at
  /// the value before.
  void follow() {
    auto& branches = result_.branches;
    branches = vibration::follow_modes(result_.states, options_.count.value_or(kModes),
                                       vibration::ThroughZero::yes);
    if (!result_.critical || !result_.critical->mode) return;
    CriticalPoint& critical = *result_.critical;
    auto branch = std::find_if(branches.begin(), branches.end(), [&](const CampbellBranch& one) {
      return one.modes[critical.state] == critical.mode;
    });
    if (branch == branches.end()) {
      const Mode& mode = result_.states[critical.state].modes[*critical.mode];
      branches.push_back(
          {mode.name, mode.of, std::vector<std::optional<std::size_t>>(result_.states.size())});
      branch = std::prev(branches.end());
      branch->modes[critical.state] = critical.mode;
    }
    // Beyond, modes have other names: where a pair of roots is real, there is one mode more.
    const std::optional<std::size_t> before = branch->modes[critical.state - 1];
    critical.name = before ? result_.states[critical.state - 1].modes[*before].name : branch->name;
    critical.of = branch->of;
  }

  const Scenario& scenario_;
  const CriticalOptions& options_;
  Parameter parameter_;
  ModeFrame frame_;
  EquilibriumPath path_;
  CriticalResult result_;
  double softest_ = 0.0;  ///< largest least stiffness so far, as RootStability::softest
};

}  // namespace

CriticalResult solve_critical(const Scenario& scenario, const CriticalOptions& options) {
  check_scenario(scenario);
  check(options);
  return Search(scenario, options).run();
}

std::string_view name_of(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::buckling:
      return "buckling";
    case CriticalKind::divergence:
      return "divergence";
    case CriticalKind::flutter:
      return "flutter";
    case CriticalKind::critical_speed:
      return "critical speed";
    case CriticalKind::limit_point:
      return "limit point";
    case CriticalKind::jump:
      return "jump";
    case CriticalKind::no_equilibrium:
      break;
  }
  return "no equilibrium";
}

}  // namespace spoke
