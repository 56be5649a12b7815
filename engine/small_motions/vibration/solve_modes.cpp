// Takes a scenario to its modes: equilibrium, linearisation, roots, names.

#include "engine/small_motions/vibration/solve_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/modes.h"
#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/steady/describe_equilibrium.h"
#include "engine/small_motions/steady/friction_at_rest.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/steady_speed.h"
#include "engine/small_motions/steady/steady_warnings.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/small_motions/vibration/choose_frame.h"
#include "engine/small_motions/vibration/coupled_roots.h"
#include "engine/small_motions/vibration/equal_roots.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/floquet_modes.h"
#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/mode_shapes.h"
#include "engine/small_motions/vibration/require_period.h"
#include "engine/small_motions/vibration/support_names.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

using steady::Equilibrium;
using steady::LinearModel;
using steady::SteadyModel;
using vibration::add_shape;
using vibration::EnergySum;
using vibration::Features;
using vibration::find_count;
using vibration::find_like;
using vibration::is_rigid;
using vibration::Linearised;
using vibration::list_features;
using vibration::make_mode;
using vibration::ModeCount;
using vibration::name_subsystems;
using vibration::normalise;
using vibration::Numbering;
using vibration::Pencil;
using vibration::Root;
using vibration::set_hub_motion;
using vibration::SubsystemShape;

/// Returns a larger count than asked for: to tell equal roots apart, all of a pair or of all
/// subsystems are needed.
Eigen::Index count_with_partners(Eigen::Index count, const Pencil& pencil) {
  constexpr Eigen::Index kMost = 8;
  return std::min(count + std::min(kMost, std::ssize(pencil.subsystems())), pencil.size());
}

void add_modes_of_subsystem(std::size_t i, const ModeCount& count, const Linearised& all,
                            ModesResult& result) {
  const Pencil pencil(all.linear, {i});
  const std::string of = name_subsystems(find_like(i, all.linear.alike), all.model);
  const Eigen::Index wanted = find_count(count, pencil.size(), of, result);
  const auto shape_of = [&](const Eigen::VectorXcd& x) {
    return vibration::calc_subsystem_shape(
        i, all.equilibrium.q[i], all.linear.motion_of(i, x, Eigen::VectorXcd()), all.model);
  };
  const auto independent = steady::list_independent(i, all.linear, all.model);
  std::vector<Root> roots = vibration::find_roots(pencil, count_with_partners(wanted, pencil));
  separate_equal_roots(
      pencil, [&](const Eigen::VectorXcd& x) { return list_features(shape_of(x)); }, roots);
  if (std::ssize(roots) > wanted) roots.resize(static_cast<std::size_t>(wanted));
  Numbering numbering;
  vibration::KindNames kinds;
  const std::size_t first = result.modes.size();
  for (const Root& root : roots) {
    Mode mode = make_mode(root);
    mode.coordinates = all.linear.motion_of(i, root.x, Eigen::VectorXcd());
    mode.of = of;
    const SubsystemShape shape = shape_of(root.x);
    mode.shape.resize(all.model.subsystems());
    mode.rotations.resize(all.model.subsystems());
    mode.shape[i] = shape.nodes;
    mode.rotations[i] = shape.rotations;
    mode.solids.resize(all.model.subsystems());
    mode.solids[i] = shape.solids;
    normalise(mode);
    EnergySum energies(all);
    energies.add(i, shape);
    mode.energy = energies.share_out(0.0);
    mode.weighed = energies.weigh({}, {});
    const std::string kind = kinds.name(independent, root.x, all.linear.subsystem(i).M, shape);
    mode.kind = vibration::kind_with_damping(kind, root.s, mode.frequency);
    if (mode.kind != kind) numbering.count_root(kind);
    result.modes.push_back(std::move(mode));
  }
  for (std::size_t k = first; k < result.modes.size(); ++k) {
    Mode& mode = result.modes[k];
    numbering.name(is_rigid(mode) ? "rigid " + mode.kind : mode.kind, mode);
  }
}

/// Returns the motion of a subsystem's independent coordinates.
Eigen::VectorXcd part_of(std::size_t i, const Pencil& pencil, const Eigen::VectorXcd& x,
                         const Linearised& all) {
  return x.segment(pencil.start(i), all.linear.subsystem(i).M.rows());
}

/// Returns the motion of all coordinates of a subsystem.
Eigen::VectorXcd motion_of(std::size_t i, const Pencil& pencil, const Eigen::VectorXcd& x,
                           const Linearised& all) {
  return all.linear.motion_of(i, part_of(i, pencil, x, all), x.head(all.linear.M.rows()));
}

/// Returns the motion of the hub's free coordinates and of all coordinates of subsystems.
Eigen::VectorXcd list_motions(const Pencil& pencil, const Eigen::VectorXcd& x,
                              const Linearised& all) {
  Eigen::VectorXcd list = x.head(all.linear.M.rows());
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    const Eigen::VectorXcd own = motion_of(i, pencil, x, all);
    list.conservativeResize(list.size() + own.size());
    list.tail(own.size()) = own;
  }
  return list;
}

/// Names the pattern in which the subsystems that are like subsystem `i` move.
std::string find_pattern(std::size_t i, const Pencil& pencil, const Eigen::VectorXcd& x,
                         const Linearised& all) {
  std::vector<Eigen::VectorXcd> subsystems;
  std::vector<double> azimuths;
  for (const std::size_t k : find_like(all.equilibrium.alike[i], all.equilibrium.alike)) {
    subsystems.push_back(part_of(k, pencil, x, all));
    azimuths.push_back(all.model.azimuth(k));
  }
  return vibration::name_pattern(subsystems, azimuths);
}

/// Returns kinds of motion of all subsystems together, then cosine and sine parts of multiples of
/// the azimuth of those that are alike.
Features list_coupled_features(const Eigen::VectorXcd& x, const Pencil& pencil,
                               const Linearised& all) {
  const std::size_t subsystems = all.model.subsystems();
  std::vector<Features> shapes;
  std::vector<Eigen::Index> starts;
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < subsystems; ++i) {
    const Eigen::VectorXcd own = motion_of(i, pencil, x, all);
    shapes.push_back(
        list_features(vibration::calc_subsystem_shape(i, all.equilibrium.q[i], own, all.model)));
    starts.push_back(size);
    size += shapes[i][0].size();
  }
  Features features(4, Eigen::VectorXcd(size));
  for (std::size_t kind = 0; kind < 4; ++kind)
    for (std::size_t i = 0; i < subsystems; ++i)
      features[kind].segment(starts[i], shapes[i][kind].size()) = shapes[i][kind];
  for (std::size_t n = 0; 2 * n <= subsystems; ++n)
    for (const double phase : {0.0, 0.5 * std::numbers::pi}) {
      Eigen::VectorXcd& sum = features.emplace_back(Eigen::VectorXcd::Zero(4 * size));
      for (std::size_t i = 0; i < subsystems; ++i) {
        const std::size_t first = all.equilibrium.alike[i];
        const double share = std::cos(static_cast<double>(n) * all.model.azimuth(i) - phase);
        const Eigen::Index own = shapes[i][0].size(), at = 4 * starts[first];
        for (std::size_t kind = 0; kind < 4; ++kind)
          sum.segment(at + static_cast<Eigen::Index>(kind) * own, own) += share * shapes[i][kind];
      }
    }
  return features;
}

/// A mode, whose name is that of its pattern.
struct CoupledMode {
  Mode mode;
  std::string rotors{};  ///< before its name, see name_rotors()
};

CoupledMode make_coupled_mode(const Root& root, const Pencil& pencil, const Linearised& all,
                              vibration::KindNames& kinds) {
  CoupledMode made{make_mode(root)};
  Mode& mode = made.mode;
  mode.coordinates = list_motions(pencil, root.x, all);
  mode.of = "all";
  const Eigen::Index h = all.linear.M.rows();
  const Eigen::VectorXcd hub = root.x.head(h);
  set_hub_motion(hub, all, mode);
  constexpr double kAlike = 1e-6;  // of subsystems that move equally the first one counts
  std::size_t most = 0;
  double largest = 0.0;
  std::vector<SubsystemShape> shapes;
  EnergySum energies(all);
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    const Eigen::VectorXcd x = motion_of(i, pencil, root.x, all);
    SubsystemShape& shape =
        shapes.emplace_back(vibration::calc_subsystem_shape(i, all.equilibrium.q[i], x, all.model));
    if (!all.model.stands(i) && shape.total() > largest * (1.0 + kAlike)) {
      largest = shape.total();
      most = i;
    }
    energies.add(i, shape);
    add_shape(i, shape, all.model, mode);
  }
  normalise(mode);
  const Eigen::MatrixXd carried = vibration::calc_carried_mass(all.linear);
  const double of_hub = vibration::calc_mass(hub, carried);
  mode.energy = energies.share_out(of_hub);
  mode.weighed = energies.weigh(hub, carried);
  if (all.linear.support && vibration::is_of_support(mode.energy)) {
    mode.kind = vibration::name_support_motion(hub, all);
    return made;
  }
  if (shapes.empty()) {  // a model of the hub alone
    mode.kind = "hub";
    return made;
  }
  const Eigen::VectorXcd x = part_of(most, pencil, root.x, all);
  mode.kind = of_hub > 0.5 && largest < 0.25
                  ? "hub"
                  : kinds.name(steady::list_independent(most, all.linear, all.model), x,
                               all.linear.subsystem(most).M, shapes[most]);
  mode.name = find_pattern(most, pencil, root.x, all);
  if (mode.kind == "hub") return made;
  std::vector<double> motions;
  for (const SubsystemShape& shape : shapes) motions.push_back(shape.total());
  made.rotors = vibration::name_rotors(motions, all.model);
  return made;
}

void add_coupled_modes(const ModeCount& count, const Linearised& all, ModesResult& result) {
  const Pencil pencil(all.linear);
  const Eigen::Index wanted = find_count(count, pencil.size(), "the model", result);
  std::vector<Root> roots = vibration::find_coupled_roots(all.linear, all.model.azimuths(),
                                                          count_with_partners(wanted, pencil));
  separate_equal_roots(
      pencil, [&](const Eigen::VectorXcd& x) { return list_coupled_features(x, pencil, all); },
      roots);
  if (std::ssize(roots) > wanted) roots.resize(static_cast<std::size_t>(wanted));
  Numbering numbering;
  vibration::KindNames kinds;
  for (const Root& root : roots) {
    auto [mode, rotors] = make_coupled_mode(root, pencil, all, kinds);
    const std::string pattern =
        rotors + (mode.name.empty() || mode.kind == "hub" ? "" : mode.name + ' ');
    const std::string kind = vibration::kind_with_damping(mode.kind, root.s, mode.frequency);
    if (kind != mode.kind) numbering.count_root(pattern + mode.kind);
    mode.kind = kind;
    mode.name = pattern + kind;
    result.modes.push_back(std::move(mode));
  }
  for (Mode& mode : result.modes) {
    if (is_rigid(mode))
      numbering.name("rigid motion", mode);
    else if (all.linear.support && vibration::is_of_support(mode.energy))
      numbering.name_further(mode.kind, mode);
    else
      numbering.name(std::string(mode.name), mode);
  }
}

void add_turning_modes(const ModeCount& count, const Linearised& all, ModesResult& result) {
  if (all.linear.is_coupled()) return add_coupled_modes(count, all, result);
  // Subsystems without coordinates have no modes.
  for (std::size_t i = 0; i < all.model.subsystems(); ++i)
    if (all.linear.alike[i] == i && all.linear.subsystem(i).M.rows() > 0)
      add_modes_of_subsystem(i, count, all, result);
  if (result.modes.empty())
    throw InputError("nothing of the model moves, expected a body or a joint that does");
}

}  // namespace

ModesResult vibration::make_modes(const LinearModel& linear, const Equilibrium& equilibrium,
                                  ModeFrame frame, const ModeCount& count, SteadyModel& model,
                                  SteadyModel* whole) {
  ModesResult result;
  result.equilibrium = steady::describe(equilibrium, model);
  result.are_blades_coupled = linear.is_coupled();
  const Linearised all{model, equilibrium, linear};
  result.frame = frame;
  result.bodies = vibration::list_bodies(all);
  if (frame == ModeFrame::fixed) {
    vibration::add_fixed_modes(count, all, result);
  } else if (frame == ModeFrame::floquet) {
    vibration::add_floquet_modes(count, all, whole, result);
  } else {
    steady::require_constant(linear, equilibrium, model);
    add_turning_modes(count, all, result);
  }
  vibration::split_shapes(model, result);
  return result;
}

namespace {

/// Returns why a model has no constant matrices in the frame "turning" or "fixed"; empty: it has.
std::string find_refusal(ModeFrame frame, const Linearised& all) {
  try {
    if (frame == ModeFrame::fixed)
      vibration::see_from_outside(all);
    else
      steady::require_constant(all.linear, all.equilibrium, all.model);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Returns the frame for modes of a model that has none in the frame "fixed".
ModeFrame choose_other_frame(const Linearised& all) {
  if (!all.model.turns()) return ModeFrame::turning;
  const bool is_constant = !all.linear.support && find_refusal(ModeFrame::turning, all).empty();
  return is_constant ? ModeFrame::turning : ModeFrame::floquet;
}

/// Says that air at rest acts.
void note_still_air(ModesResult& result) {
  constexpr double kStill = 1e-6;  // [m/s]
  if (result.equilibrium.air && std::abs(result.equilibrium.air->wind) < kStill)
    result.notes.push_back("the air is at rest: the mean wind has no part along the axis");
}

/// Says what friction is.
void note_friction(const Scenario& scenario, ModesResult& result) {
  if (steady::has_friction(scenario))
    result.notes.push_back(
        "friction of joints is a damper here, by its slope at rest; no motion that goes on is "
        "followed");
}

/// Finds modes in a frame, or in the usual one: `asked` none.
ModesResult solve_in(ModeFrame frame, bool is_asked, const Scenario& scenario,
                     const std::vector<double>& speeds, const ModeCount& count) {
  const std::unique_ptr<SteadyModel> model = steady::make_steady_model(
      scenario, steady::at_speeds(speeds, {.is_axial = frame != ModeFrame::turning}));
  const Equilibrium equilibrium = steady::find_machine_equilibrium(*model);
  steady::require_steady_machine(*model, equilibrium);
  LinearModel linear = steady::linearize_machine(equilibrium, *model);
  if (model->is_standing_machine() && !is_asked) frame = ModeFrame::turning;
  if (frame == ModeFrame::fixed && !is_asked) {
    const Linearised all{*model, equilibrium, linear};
    if (const std::string why = find_refusal(frame, all); !why.empty()) {
      const ModeFrame other = choose_other_frame(all);
      const std::string reason = why.substr(0, why.find(':'));
      if (other == ModeFrame::floquet) vibration::require_period(all, reason + "; ");
      ModesResult result = solve_in(other, true, scenario, speeds, count);
      const std::string frame_used = other == ModeFrame::floquet ? "\"floquet\""
                                     : model->turns()            ? "\"turning\""
                                                      : "\"turning\", the model being at rest";
      result.notes.push_back("modes are in the frame " + frame_used + ": " + reason);
      return result;
    }
  }
  if (linear.support && frame == ModeFrame::turning) {
    if (model->turns())
      throw InputError(
          "the frame \"turning\" expects a hub whose support does not move, or a speed of 0: on a "
          "support the frames \"fixed\" and \"floquet\" have modes");
    steady::stand_on(*linear.support, linear);
  }
  std::unique_ptr<SteadyModel> whole;
  // Along a motion friction is none of the dampers that it is about rest.
  if (frame == ModeFrame::floquet && !linear.support && !steady::has_friction(scenario))
    whole = steady::make_steady_model(scenario, steady::at_speeds(speeds, {.is_whole = true}));
  return vibration::make_modes(linear, equilibrium, frame, count, *model, whole.get());
}

}  // namespace

ModesResult vibration::solve_modes(const Scenario& scenario, const SteadyState& state,
                                   std::optional<ModeFrame> asked, const ModeCount& count) {
  check_scenario(scenario);
  ModesResult result = solve_in(choose_frame(scenario, asked), asked.has_value(), scenario,
                                steady::find_steady_speeds(scenario, state), count);
  note_still_air(result);
  note_friction(scenario, result);
  steady::add_warnings(scenario, result.equilibrium);
  return result;
}

ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options) {
  if (!options.count) return vibration::solve_modes(scenario, options.state, options.frame, {});
  const int count = *options.count;
  if (count < 1) throw InputError(std::to_string(count) + " modes, expected 1 or more");
  return vibration::solve_modes(scenario, options.state, options.frame, {count, count});
}

}  // namespace spoke
