// From a scenario to its modes: equilibrium, linearisation, roots, names.

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "engine/modes.h"
#include "engine/steady/describe_equilibrium.h"
#include "engine/steady/linear_model.h"
#include "engine/steady/steady_speed.h"
#include "engine/steady/steady_warnings.h"
#include "engine/vibration/coupled_roots.h"
#include "engine/vibration/mode_shapes.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

using steady::Equilibrium;
using steady::LinearModel;
using steady::SteadyModel;
using vibration::Pencil;
using vibration::Root;
using vibration::TreeShape;

/// All that modes are made from.
struct Linearised {
  SteadyModel& model;
  const Equilibrium& equilibrium;
  const LinearModel& linear;
};

/// "blade 1", "blades 1 to 3", "blade 1, blade 3".
std::string name_trees(const std::vector<std::size_t>& trees, const SteadyModel& model) {
  const bool is_row = trees.size() > 1 && trees.back() - trees.front() + 1 == trees.size();
  const std::string& first = model.name_of(trees.front());
  const std::string& last = model.name_of(trees.back());
  const std::string word = "blade ";
  if (is_row && first.starts_with(word) && last.starts_with(word))
    return "blades " + first.substr(word.size()) + " to " + last.substr(word.size());
  std::string list;
  for (const std::size_t i : trees) list += (list.empty() ? "" : ", ") + model.name_of(i);
  return list;
}

/// The trees that tree `i` stands for.
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
  mode.coordinates = root.x;
  return mode;
}

/// Makes the largest displacement of all nodes 1.
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

bool is_rigid(const Mode& mode) { return mode.eigenvalue == 0.0; }

void add_modes_of_tree(std::size_t i, int count, const Linearised& all, ModesResult& result) {
  const Pencil pencil(all.linear, {i});
  const std::string of = name_trees(find_like(i, all.linear.alike), all.model);
  if (count > pencil.size())
    throw InputError(std::to_string(count) + " modes, expected at most " +
                     std::to_string(pencil.size()) + ": there are no more of " + of);
  Numbering numbering;
  for (const Root& root : vibration::find_roots(pencil, count)) {
    Mode mode = make_mode(root);
    mode.of = of;
    const TreeShape shape = vibration::calc_tree_shape(i, all.equilibrium.q[i], root.x, all.model);
    mode.shape.resize(all.model.trees());
    mode.rotations.resize(all.model.trees());
    mode.shape[i] = shape.nodes;
    mode.rotations[i] = shape.rotations;
    normalise(mode);
    mode.kind = vibration::name_kind(i, root.x, all.linear.tree(i).M, shape, all.model);
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

/// Adds a tree, which goes with the hub.
void add_shape(std::size_t tree, const TreeShape& shape, SteadyModel& model, Mode& mode) {
  const std::vector<steady::NodePlace> places = model.places(tree);
  auto& nodes = mode.shape.emplace_back(shape.nodes);
  auto& rotations = mode.rotations.emplace_back(shape.rotations);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::Vector3cd p = places[k].p.cast<std::complex<double>>();
    nodes[k] += mode.hub_displacement + mode.hub_rotation.cross(p);
    rotations[k] += mode.hub_rotation;
  }
}

/// How blades that are like tree `i` move together.
std::string find_pattern(std::size_t i, const Pencil& pencil, const Eigen::VectorXcd& x,
                         const Linearised& all) {
  std::vector<Eigen::VectorXcd> blades;
  std::vector<double> azimuths;
  for (const std::size_t k : find_like(all.equilibrium.alike[i], all.equilibrium.alike)) {
    blades.emplace_back(x.segment(pencil.start(k), all.linear.tree(k).M.rows()));
    azimuths.push_back(all.model.azimuth(k));
  }
  return vibration::name_pattern(blades, azimuths);
}

Mode make_coupled_mode(const Root& root, const Pencil& pencil, const Linearised& all) {
  Mode mode = make_mode(root);
  mode.of = "all";
  const Eigen::Index h = all.linear.M.rows();
  set_hub_motion(root.x.head(h), all.model, mode);
  std::size_t most = 0;
  double largest = -1.0;
  std::vector<TreeShape> shapes;
  for (std::size_t i = 0; i < all.model.trees(); ++i) {
    const Eigen::VectorXcd x = root.x.segment(pencil.start(i), all.linear.tree(i).M.rows());
    TreeShape& shape =
        shapes.emplace_back(vibration::calc_tree_shape(i, all.equilibrium.q[i], x, all.model));
    if (shape.total() > largest) {
      largest = shape.total();
      most = i;
    }
    add_shape(i, shape, all.model, mode);
  }
  normalise(mode);
  const Eigen::VectorXcd hub = root.x.head(h);
  const double of_hub =
      hub.real().dot(all.linear.M * hub.real()) + hub.imag().dot(all.linear.M * hub.imag());
  const Eigen::VectorXcd x = root.x.segment(pencil.start(most), all.linear.tree(most).M.rows());
  mode.kind = of_hub > 0.5 && largest < 0.25
                  ? "hub"
                  : vibration::name_kind(most, x, all.linear.tree(most).M, shapes[most], all.model);
  mode.name = find_pattern(most, pencil, root.x, all);
  return mode;
}

void add_coupled_modes(int count, const Linearised& all, ModesResult& result) {
  const Pencil pencil(all.linear);
  if (count > pencil.size())
    throw InputError(std::to_string(count) + " modes, expected at most " +
                     std::to_string(pencil.size()));
  Numbering numbering;
  for (const Root& root : vibration::find_coupled_roots(all.linear, all.model.azimuths(), count)) {
    Mode mode = make_coupled_mode(root, pencil, all);
    const bool has_pattern = !mode.name.empty() && mode.kind != "hub";
    if (is_rigid(mode))
      numbering.name("rigid motion", mode);
    else
      numbering.name(has_pattern ? mode.name + ' ' + mode.kind : mode.kind, mode);
    result.modes.push_back(std::move(mode));
  }
}

}  // namespace

ModesResult solve_modes(const Scenario& scenario, const ModeOptions& options) {
  check_scenario(scenario);
  if (options.count < 1)
    throw InputError(std::to_string(options.count) + " modes, expected 1 or more");
  const double speed = steady::find_steady_speed(scenario, options.state.speed);
  const std::unique_ptr<SteadyModel> model = steady::make_steady_model(scenario, {speed});
  const Equilibrium equilibrium = steady::find_equilibrium(*model);
  steady::require_steady_hub(*model, equilibrium);
  ModesResult result;
  result.equilibrium = steady::describe(equilibrium, *model);
  steady::add_warnings(scenario, result.equilibrium);
  const LinearModel linear = steady::linearize(equilibrium, *model);
  result.are_blades_coupled = linear.is_coupled();
  const Linearised all{*model, equilibrium, linear};
  if (linear.is_coupled()) {
    add_coupled_modes(options.count, all, result);
    return result;
  }
  for (std::size_t i = 0; i < model->trees(); ++i)
    if (linear.alike[i] == i) add_modes_of_tree(i, options.count, all, result);
  return result;
}

}  // namespace spoke
