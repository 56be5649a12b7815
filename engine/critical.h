#pragma once

// The least speed or load at which an equilibrium is lost or a mode stops decaying: buckling,
// flutter, ground resonance, critical speeds.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/campbell.h"
#include "engine/modes.h"
#include "models/scenario.h"
#include "spoke/export.h"

namespace spoke {

/// What is varied, and how far.
struct CriticalOptions {
  /// "speed": the speed of the hub, of several rotors on a support of the first, while the others
  /// turn by the ratios of the speeds that their drives lead to [rad/s]. "load=NAME": a factor of
  /// all loads of this name, which is 1 for the loads as the scenario has them; "load=gravity": of
  /// gravity.
  std::string of{};
  double from = 0.0;    ///< value at which the search begins, and the equilibrium is stable
  double to = 0.0;      ///< value at which it ends, greater than `from`
  SteadyState state{};  ///< steady motion while a load is varied
  /// Values at which modes are sought, both ends included, 2 or more: what comes and goes between
  /// two of them is missed.
  int points = 21;
  /// Number of modes to look at, from the lowest frequency on, as in ModeOptions; none: 10, or as
  /// many as there are.
  std::optional<int> count = std::nullopt;
  /// As in ModeOptions; not `floquet`. None: `fixed` for a rotor that turns on a support, else
  /// `turning`.
  std::optional<ModeFrame> frame = std::nullopt;
  /// Called with the number of values that are done. An exception that it throws ends the search.
  std::function<void(std::size_t)> progress{};
};

/// The way in which an equilibrium is lost.
enum class CriticalKind {
  /// Nothing holds a motion any longer, which grows beyond without vibrating: at rest ...
  buckling,
  divergence,  ///< ... and in rotation
  flutter,     ///< a vibration grows
  /// In rotation nothing holds a motion, but it does not grow beyond as divergence does: a whirl
  /// whose frequency in the turning frame is zero, and which is once per revolution from outside.
  critical_speed,
  limit_point,     ///< the equilibrium ends, as its stiffness does: snapping through
  no_equilibrium,  ///< none is found beyond, for another reason
  /// The steady state that was followed ends, and another one is far from it: deflections jump.
  jump,
};

/// The critical value.
struct CriticalPoint {
  CriticalKind kind = CriticalKind::buckling;
  double value = 0.0;       ///< of what is varied: the speed [rad/s], or the factor
  double resolution = 0.0;  ///< by which it is uncertain, of the bisection alone
  double frequency = 0.0;   ///< of the critical mode there; 0 but for flutter [rad/s]
  /// Index in CriticalResult::states of the modes a millionth beyond, or before where there is no
  /// equilibrium beyond.
  std::size_t state = 0;
  std::optional<std::size_t> mode;  ///< index of the critical one among them; none: there are none
  std::string name;                 ///< of the critical mode, as at the value before: "lag 1"
  std::string of;                   ///< whose it is: "blade 1"
  /// Of a jump: index in CriticalResult::states of the other steady state, a millionth beyond.
  std::optional<std::size_t> beyond = std::nullopt;
};

/// What solve_critical() finds.
struct CriticalResult {
  std::optional<CriticalPoint> critical;  ///< none: the equilibrium is stable in the whole range
  /// Ascending: those of the search, and the critical one. They end where the equilibrium does.
  std::vector<double> values;
  std::vector<ModesResult> states;  ///< by value
  /// Modes followed over the values, as in CampbellResult; the critical mode is in one of them.
  std::vector<CampbellBranch> branches;
};

/// Finds the least value beyond `from` at which an equilibrium of a scenario's model is lost or a
/// mode stops decaying, in the frame that turns with the hub (docs/modes.md). Goes on from each
/// equilibrium to the next, looks at roots and stiffness of small motions, and narrows the first
/// change down to 1e-10 by bisection. Throws like solve_modes() at `from`; InputError if the
/// options are not valid, if no load has the name or its factor changes nothing, or if the
/// equilibrium at `from` is unstable.
SPOKE_EXPORT CriticalResult solve_critical(const Scenario& scenario,
                                           const CriticalOptions& options);

/// Returns "buckling", "divergence", "flutter", "critical speed", "limit point", "no equilibrium",
/// "jump".
SPOKE_EXPORT std::string_view name_of(CriticalKind kind);

}  // namespace spoke
