// Takes a scenario to its modes: equilibrium, linearisation, roots, names.

#include "engine/vibration/solve_modes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/modes.h"
#include "engine/steady/describe_equilibrium.h"
#include "engine/steady/linear_model.h"
#include "engine/steady/steady_speed.h"
#include "engine/steady/steady_warnings.h"
#include "engine/vibration/coupled_roots.h"
#include "engine/vibration/equal_roots.h"
#include "engine/vibration/mode_shapes.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

using steady::Equilibrium;
using steady::LinearModel;
using steady::SteadyModel;
using vibration::Features;
using vibration::ModeCount;
using vibration::Pencil;
using vibration::Root;
using vibration::SubsystemShape;

/// All data that modes are made from.
struct Linearised {
  SteadyModel& model;
  const Equilibrium& equilibrium;
  const LinearModel& linear;
};

/// Returns the names of subsystems as "blade 1", "blades 1 to 3" or "blade 1, blade 3".
std::string name_subsystems(const std::vector<std::size_t>& subsystems, const SteadyModel& model) {
  const bool is_row =
      subsystems.size() > 1 && subsystems.back() - subsystems.front() + 1 == subsystems.size();
  const std::string& first = model.name_of(subsystems.front());
  const std::string& last = model.name_of(subsystems.back());
  const std::string word = "blade ";
  if (is_row && first.starts_with(word) && last.starts_with(word))
    return "blades " + first.substr(word.size()) + " to " + last.substr(word.size());
  std::string list;
  for (const std::size_t i : subsystems) list += (list.empty() ? "" : ", ") + model.name_of(i);
  return list;
}

/// Returns the subsystems that subsystem `i` stands for.
std::vector<std::size_t> find_like(std::size_t i, const std::vector<std::size_t>& alike) {
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < alike.size(); ++k)
    if (alike[k] == i) list.push_back(k);
  return list;
}

Mode make_mode(const Root& root) {
  Mode mode;
  mode.eigenvalue = root.s;
  mode.frequency = std::abs(root.s.imag());
  const double size = std::abs(root.s);
  mode.damping_ratio = size > 0.0 ? 0.0 - root.s.real() / size : 0.0;
  return mode;
}

/// Scales a mode to a largest displacement of 1.
void normalise(Mode& mode) {
  std::complex<double> largest = 0.0;
  for (const auto& nodes : mode.shape)
    for (const Eigen::Vector3cd& p : nodes)
      for (int c = 0; c < 3; ++c)
        if (std::abs(p[c]) > std::abs(largest)) largest = p[c];
  if (largest == 0.0) return;
  for (auto* field : {&mode.shape, &mode.rotations})
    for (auto& nodes : *field)
      for (Eigen::Vector3cd& v : nodes) v /= largest;
  for (auto& solids : mode.solids)
    for (Eigen::VectorXcd& q : solids) q /= largest;
  mode.hub_displacement /= largest;
  mode.hub_rotation /= largest;
}

/// Numbers modes of one name in their order; a name that is alone is numbered, too.
class Numbering {
 public:
  void name(const std::string& what, Mode& mode) {
    mode.name = what + ' ' + std::to_string(++counts_[what]);
  }

 private:
  std::map<std::string, int> counts_;
};

/// Returns how many of `size` modes to find. Throws InputError if they are too few.
Eigen::Index find_count(const ModeCount& count, Eigen::Index size, const std::string& why = "") {
  if (count.least > size)
    throw InputError(std::to_string(count.least) + " modes, expected at most " +
                     std::to_string(size) + why);
  return std::min<Eigen::Index>(count.most, size);
}

bool is_rigid(const Mode& mode) { return mode.eigenvalue == 0.0; }

/// Returns flap, lag, torsion and axial motion of a shape, by which modes of equal roots are told
/// apart.
Features list_features(const SubsystemShape& shape) {
  return {shape.motions[2], shape.motions[1], shape.motions[3], shape.motions[0]};
}

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
  const Eigen::Index wanted = find_count(count, pencil.size(), ": there are no more of " + of);
  const auto shape_of = [&](const Eigen::VectorXcd& x) {
    return vibration::calc_subsystem_shape(
        i, all.equilibrium.q[i], all.linear.motion_of(i, x, Eigen::VectorXcd()), all.model);
  };
  const auto independent = vibration::list_independent(i, all.linear, all.model);
  std::vector<Root> roots = vibration::find_roots(pencil, count_with_partners(wanted, pencil));
  separate_equal_roots(
      pencil, [&](const Eigen::VectorXcd& x) { return list_features(shape_of(x)); }, roots);
  if (std::ssize(roots) > wanted) roots.resize(static_cast<std::size_t>(wanted));
  Numbering numbering;
  vibration::KindNames kinds;
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
    mode.kind = kinds.name(independent, root.x, all.linear.subsystem(i).M, shape);
    numbering.name(is_rigid(mode) ? "rigid " + mode.kind : mode.kind, mode);
    result.modes.push_back(std::move(mode));
  }
}

/// Sets the motion of the hub's frame by its free coordinates.
void set_hub_motion(const Eigen::VectorXcd& x, const SteadyModel& model, Mode& mode) {
  const std::vector<int>& free = model.free_components();
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::complex<double> value = x[static_cast<Eigen::Index>(k)];
    if (free[k] < model.first_rotation())
      mode.hub_displacement[free[k]] = value;
    else
      mode.hub_rotation[model.is_spatial() ? free[k] - 3 : 2] = value;
  }
}

/// Adds the shape of a subsystem, which moves with the hub.
void add_shape(std::size_t subsystem, const SubsystemShape& shape, SteadyModel& model, Mode& mode) {
  const std::vector<steady::NodePlace> places = model.places(subsystem);
  auto& nodes = mode.shape.emplace_back(shape.nodes);
  auto& rotations = mode.rotations.emplace_back(shape.rotations);
  mode.solids.push_back(shape.solids);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::Vector3cd p = places[k].p.cast<std::complex<double>>();
    nodes[k] += mode.hub_displacement + mode.hub_rotation.cross(p);
    rotations[k] += mode.hub_rotation;
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

Mode make_coupled_mode(const Root& root, const Pencil& pencil, const Linearised& all,
                       vibration::KindNames& kinds) {
  Mode mode = make_mode(root);
  mode.coordinates = list_motions(pencil, root.x, all);
  mode.of = "all";
  const Eigen::Index h = all.linear.M.rows();
  set_hub_motion(root.x.head(h), all.model, mode);
  constexpr double kAlike = 1e-6;  // of subsystems that move equally the first one counts
  std::size_t most = 0;
  double largest = 0.0;
  std::vector<SubsystemShape> shapes;
  for (std::size_t i = 0; i < all.model.subsystems(); ++i) {
    const Eigen::VectorXcd x = motion_of(i, pencil, root.x, all);
    SubsystemShape& shape =
        shapes.emplace_back(vibration::calc_subsystem_shape(i, all.equilibrium.q[i], x, all.model));
    if (shape.total() > largest * (1.0 + kAlike)) {
      largest = shape.total();
      most = i;
    }
    add_shape(i, shape, all.model, mode);
  }
  normalise(mode);
  if (shapes.empty()) {  // a model of the hub alone
    mode.kind = "hub";
    return mode;
  }
  const Eigen::VectorXcd hub = root.x.head(h);
  const double of_hub =
      hub.real().dot(all.linear.M * hub.real()) + hub.imag().dot(all.linear.M * hub.imag());
  const Eigen::VectorXcd x = part_of(most, pencil, root.x, all);
  mode.kind = of_hub > 0.5 && largest < 0.25
                  ? "hub"
                  : kinds.name(vibration::list_independent(most, all.linear, all.model), x,
                               all.linear.subsystem(most).M, shapes[most]);
  mode.name = find_pattern(most, pencil, root.x, all);
  return mode;
}

void add_coupled_modes(const ModeCount& count, const Linearised& all, ModesResult& result) {
  const Pencil pencil(all.linear);
  const Eigen::Index wanted = find_count(count, pencil.size());
  std::vector<Root> roots = vibration::find_coupled_roots(all.linear, all.model.azimuths(),
                                                          count_with_partners(wanted, pencil));
  separate_equal_roots(
      pencil, [&](const Eigen::VectorXcd& x) { return list_coupled_features(x, pencil, all); },
      roots);
  if (std::ssize(roots) > wanted) roots.resize(static_cast<std::size_t>(wanted));
  Numbering numbering;
  vibration::KindNames kinds;
  for (const Root& root : roots) {
    Mode mode = make_coupled_mode(root, pencil, all, kinds);
    const bool has_pattern = !mode.name.empty() && mode.kind != "hub";
    if (is_rigid(mode))
      numbering.name("rigid motion", mode);
    else
      numbering.name(has_pattern ? mode.name + ' ' + mode.kind : mode.kind, mode);
    result.modes.push_back(std::move(mode));
  }
}

}  // namespace

ModesResult vibration::make_modes(const LinearModel& linear, const Equilibrium& equilibrium,
                                  const ModeCount& count, SteadyModel& model) {
  ModesResult result;
  result.equilibrium = steady::describe(equilibrium, model);
  result.are_blades_coupled = linear.is_coupled();
  const Linearised all{model, equilibrium, linear};
  if (linear.is_coupled()) {
    add_coupled_modes(count, all, result);
    return result;
  }
  // Subsystems without coordinates have no modes.
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    if (linear.alike[i] == i && linear.subsystem(i).M.rows() > 0)
      add_modes_of_subsystem(i, count, all, result);
  if (result.modes.empty())
    throw InputError("nothing of the model moves, expected a body or a joint that does");
  return result;
}

ModesResult vibration::solve_modes(const Scenario& scenario, const SteadyState& state,
                                   const ModeCount& count) {
  check_scenario(scenario);
  const double speed = steady::find_steady_speed(scenario, state.speed);
  const std::unique_ptr<SteadyModel> model = steady::make_steady_model(scenario, {speed});
  const Equilibrium equilibrium = steady::find_equilibrium(*model);
  steady::require_steady_hub(*model, equilibrium);
  const LinearModel linear = steady::linearize(equilibrium, *model);
  ModesResult result = make_modes(linear, equilibrium, count, *model);
  steady::add_warnings(scenario, result.equilibrium);
  return result;
}

ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options) {
  if (!options.count) return vibration::solve_modes(scenario, options.state, {});
  const int count = *options.count;
  if (count < 1) throw InputError(std::to_string(count) + " modes, expected 1 or more");
  return vibration::solve_modes(scenario, options.state, {count, count});
}

}  // namespace spoke
