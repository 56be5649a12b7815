// Distributes speeds over threads.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "engine/campbell.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/vibration/choose_frame.h"
#include "engine/small_motions/vibration/follow_modes.h"
#include "engine/small_motions/vibration/solve_modes.h"
#include "graph/executor.h"
#include "models/error.h"
#include "models/reader/scenario_fields.h"

namespace spoke {
namespace {

/// Number of modes beyond those that are followed, which compete with them and may come down.
constexpr int kSpare = 4;

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
      scenario, steady::scale_steady_state(scenario, speed), options.frame,
      {options.count.value_or(0), options.count.value_or(options.most) + kSpare});
}

/// The failure of a speed that has no modes.
struct Failure {
  std::exception_ptr exception;
  std::string gap;  ///< reason why there is no equilibrium; empty: the speed is no gap
};

/// Makes gaps of speeds without equilibrium, and throws their first failure if fewer than two other
/// speeds are left. Of other failures that at the lowest speed is thrown.
void settle_failures(const std::vector<Failure>& failures, const Scenario& scenario,
                     const CampbellOptions& options, CampbellResult& result) {
  std::exception_ptr first;
  for (std::size_t k = 0; k < failures.size(); ++k) {
    if (!failures[k].exception) continue;
    if (failures[k].gap.empty()) std::rethrow_exception(failures[k].exception);
    if (!first) first = failures[k].exception;
    result.states[k].equilibrium.speed = options.speeds[k];
    result.states[k].frame = vibration::choose_frame(scenario, options.frame);
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
  settle_failures(failures, scenario, options, result);
}

/// Follows the modes, and notes where a branch ends.
void follow_branches(const Scenario& scenario, const CampbellOptions& options,
                     CampbellResult& result) {
  const auto solve = [&](double speed) -> std::optional<ModesResult> {
    if (options.progress) options.progress(options.speeds.size());
    try {
      return solve_with_spares(scenario, speed, options);
    } catch (const DivergenceError&) {
      return std::nullopt;
    }
  };
  // Modes by Floquet's theory take too long for speeds that nobody has asked for.
  const bool is_dear =
      std::any_of(result.states.begin(), result.states.end(),
                  [](const ModesResult& state) { return state.frame == ModeFrame::floquet; });
  const vibration::BetweenStates between{options.speeds, solve};
  result.branches =
      vibration::follow_modes(result.states, options.count.value_or(options.most),
                              vibration::ThroughZero::yes, is_dear ? nullptr : &between);
  for (std::size_t b = 0; b < result.branches.size(); ++b) {
    const auto& modes = result.branches[b].modes;
    std::optional<std::size_t> last;
    for (std::size_t k = 0; k < modes.size(); ++k) {
      if (modes[k]) last = k;
      if (modes[k] || !last || result.states[k].modes.empty()) continue;
      result.losses.push_back({b, *last, k});
      break;
    }
  }
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
    return steady::find_steady_speed(scenario, 0, std::nullopt);
  } catch (const InputError&) {
    return std::nullopt;  // a torque
  }
}

}  // namespace

CampbellResult solve_campbell(const Scenario& scenario, const CampbellOptions& options) {
  check(options);
  CampbellResult result;
  solve_all(scenario, options, result);
  follow_branches(scenario, options, result);
  find_crossings(options, find_operating_speed(scenario), result);
  return result;
}

}  // namespace spoke
