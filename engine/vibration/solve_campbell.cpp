// Distributes speeds over threads, and follows modes through them.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "engine/campbell.h"
#include "engine/steady/steady_speed.h"
#include "engine/vibration/solve_modes.h"
#include "graph/executor.h"
#include "models/error.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

/// Number of modes beyond those that are followed, one of which may come down.
constexpr int kSpare = 4;
/// Smallest modal assurance criterion at which a mode continues the one before.
constexpr double kLeastLikeness = 0.3;

void check(const CampbellOptions& options) {
  if (options.speeds.size() < 2)
    throw InputError(std::to_string(options.speeds.size()) + " speeds, expected 2 or more");
  for (std::size_t k = 0; k < options.speeds.size(); ++k) {
    const double speed = options.speeds[k];
    if (const std::string expected = kSpeed.expectation_instead_of(speed); !expected.empty())
      throw InputError("a speed is " + spoke::describe(speed) + ", expected " + expected);
    if (k > 0 && !(speed > options.speeds[k - 1])) throw InputError("speeds must ascend");
  }
  if (options.harmonics < 0)
    throw InputError(std::to_string(options.harmonics) + " harmonics, expected 0 or more");
  const int count = options.count.value_or(options.most);
  if (count < 1) throw InputError(std::to_string(count) + " modes, expected 1 or more");
}

/// Finds the modes at one speed, with up to kSpare more.
ModesResult solve_with_spares(const Scenario& scenario, double speed,
                              const CampbellOptions& options) {
  return vibration::solve_modes(
      scenario, {.speed = speed},
      {options.count.value_or(0), options.count.value_or(options.most) + kSpare});
}

/// The failure of a speed that has no modes.
struct Failure {
  std::exception_ptr exception;
  std::string gap;  ///< reason why there is no equilibrium; empty: the speed is no gap
};

/// Makes gaps of speeds without equilibrium, and throws their first failure if fewer than two other
/// speeds are left. Of other failures that at the lowest speed is thrown.
void settle_failures(const std::vector<Failure>& failures, const CampbellOptions& options,
                     CampbellResult& result) {
  std::exception_ptr first;
  for (std::size_t k = 0; k < failures.size(); ++k) {
    if (!failures[k].exception) continue;
    if (failures[k].gap.empty()) std::rethrow_exception(failures[k].exception);
    if (!first) first = failures[k].exception;
    result.states[k].equilibrium.speed = options.speeds[k];
    result.gaps.push_back({k, failures[k].gap});
  }
  if (result.gaps.size() + 2 > failures.size() && first) std::rethrow_exception(first);
}

/// Solves all speeds; each free thread takes the next one.
void solve_all(const Scenario& scenario, const CampbellOptions& options, CampbellResult& result) {
  const std::size_t count = options.speeds.size();
  std::vector<ModesResult>& states = result.states;
  states.resize(count);
  std::vector<Failure> failures(count);
  std::atomic<std::size_t> next{0}, done{0};
  const auto tell = [&](std::size_t now) {
    try {
      options.progress(now);
    } catch (...) {
      next = count;  // the other threads begin no more
      throw;
    }
  };
  const auto work = [&](bool tells) {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        states[k] = solve_with_spares(scenario, options.speeds[k], options);
      } catch (const DivergenceError& error) {
        failures[k] = {std::current_exception(), error.what()};
      } catch (...) {
        failures[k] = {std::current_exception(), {}};
      }
      const std::size_t now = ++done;
      if (tells && options.progress) tell(now);
    }
  };
  const int asked = options.threads > 0 ? options.threads : graph::available_threads();
  const std::size_t threads = std::min<std::size_t>(static_cast<std::size_t>(asked), count);
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads; ++t) others.emplace_back(work, false);
    work(true);
  }
  settle_failures(failures, options, result);
}

/// Returns the first subsystem that moves in a mode.
std::size_t first_subsystem(const Mode& mode) {
  return static_cast<std::size_t>(std::find_if(mode.shape.begin(), mode.shape.end(),
                                               [](const auto& nodes) { return !nodes.empty(); }) -
                                  mode.shape.begin());
}

/// Returns the modal assurance criterion of two modes, from 0 to 1.
double likeness(const Mode& a, const Mode& b) {
  if (a.coordinates.size() != b.coordinates.size() || first_subsystem(a) != first_subsystem(b))
    return 0.0;
  return std::norm(a.coordinates.dot(b.coordinates)) /
         (a.coordinates.squaredNorm() * b.coordinates.squaredNorm());
}

/// Gives each branch its mode at speed k, by those at speed `before`.
void follow(std::size_t before, std::size_t k, const std::vector<ModesResult>& states,
            std::vector<CampbellBranch>& branches) {
  struct Pair {
    double likeness;
    std::size_t branch, mode;
  };
  std::vector<Pair> pairs;
  const std::vector<Mode>& modes = states[k].modes;
  for (std::size_t b = 0; b < branches.size(); ++b) {
    const std::optional<std::size_t> last = branches[b].modes[before];
    if (!last) continue;
    for (std::size_t m = 0; m < modes.size(); ++m)
      pairs.push_back({likeness(states[before].modes[*last], modes[m]), b, m});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.likeness > b.likeness; });
  std::vector<bool> is_taken(modes.size());
  for (const Pair& pair : pairs) {
    std::optional<std::size_t>& mode = branches[pair.branch].modes[k];
    if (pair.likeness < kLeastLikeness || mode || is_taken[pair.mode]) continue;
    mode = pair.mode;
    is_taken[pair.mode] = true;
  }
}

/// Names a branch as most of its modes are named.
void name(const std::vector<ModesResult>& states, CampbellBranch& branch) {
  std::map<std::pair<std::string, std::string>, int> votes;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (branch.modes[k]) {
      const Mode& mode = states[k].modes[*branch.modes[k]];
      ++votes[{mode.of, mode.name}];
    }
  const auto most = std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  branch.of = most->first.first;
  branch.name = most->first.second;
}

/// Makes the branches, which begin with the first modes of each subsystem, or of the whole model,
/// at speed k.
std::vector<CampbellBranch> begin_branches(std::size_t k, const std::vector<ModesResult>& states,
                                           int count) {
  std::vector<CampbellBranch> branches;
  std::map<std::string, int> counts;
  const std::vector<Mode>& modes = states[k].modes;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (++counts[modes[m].of] > count) continue;
    branches.push_back({{}, {}, std::vector<std::optional<std::size_t>>(states.size())});
    branches.back().modes[k] = m;
  }
  return branches;
}

/// Follows all modes through the speeds that are not gaps.
void follow_all(const std::vector<ModesResult>& states, int count,
                std::vector<CampbellBranch>& branches) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (!states[k].modes.empty()) found.push_back(k);
  if (found.size() < 2) return;  // nothing vibrates
  branches = begin_branches(found[0], states, count);
  for (std::size_t i = 1; i < found.size(); ++i) follow(found[i - 1], found[i], states, branches);
  // Subsystems that differ at rest by gravity are alike as soon as the hub turns.
  std::erase_if(branches, [&](const CampbellBranch& branch) { return !branch.modes[found[1]]; });
  for (CampbellBranch& branch : branches) name(states, branch);
}

void find_crossings(const CampbellOptions& options, std::optional<double> operating,
                    CampbellResult& result) {
  for (std::size_t b = 0; b < result.branches.size(); ++b)
    for (int harmonic = 1; harmonic <= options.harmonics; ++harmonic)
      for (std::size_t k = 1; k < options.speeds.size(); ++k) {
        const auto& modes = result.branches[b].modes;
        if (!modes[k - 1] || !modes[k]) continue;
        const double before = result.states[k - 1].modes[*modes[k - 1]].frequency;
        const double after = result.states[k].modes[*modes[k]].frequency;
        const double from = options.speeds[k - 1], to = options.speeds[k];
        const double above = before - harmonic * std::abs(from);
        const double below = after - harmonic * std::abs(to);
        if (above * below >= 0.0) continue;
        const double share = above / (above - below);
        CampbellCrossing crossing{b, harmonic, from + share * (to - from),
                                  before + share * (after - before), std::nullopt};
        if (operating && *operating != 0.0)
          crossing.margin = std::abs(crossing.speed - *operating) / std::abs(*operating);
        result.crossings.push_back(crossing);
      }
}

std::optional<double> find_operating_speed(const Scenario& scenario) {
  try {
    return steady::find_steady_speed(scenario, std::nullopt);
  } catch (const InputError&) {
    return std::nullopt;  // a torque
  }
}

}  // namespace

CampbellResult solve_campbell(const Scenario& scenario, const CampbellOptions& options) {
  check(options);
  CampbellResult result;
  solve_all(scenario, options, result);
  follow_all(result.states, options.count.value_or(options.most), result.branches);
  find_crossings(options, find_operating_speed(scenario), result);
  return result;
}

}  // namespace spoke
