// Puts the state-space matrices together.

#include <utility>

#include "engine/linearize.h"
#include "engine/steady/describe_equilibrium.h"
#include "engine/steady/linear_model.h"
#include "engine/steady/linear_support.h"
#include "engine/steady/load_effects.h"
#include "engine/steady/output_derivatives.h"
#include "engine/steady/steady_speed.h"
#include "engine/steady/steady_warnings.h"
#include "engine/steady/supported_model.h"
#include "engine/support/dense.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"

namespace spoke {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using steady::SteadyModel;

/// Largest number of coordinates of a coupled model for which matrices are made: these are full
/// then, 800 MB.
constexpr Index kMostCoupled = 5000;

/// A sparse matrix in the making.
class Entries {
 public:
  void add(Index row, Index column, const MatrixXd& block) {
    for (Index c = 0; c < block.cols(); ++c)
      for (Index r = 0; r < block.rows(); ++r)
        if (block(r, c) != 0.0) list_.emplace_back(row + r, column + c, block(r, c));
  }
  Eigen::SparseMatrix<double> matrix(Index rows, Index columns) const {
    Eigen::SparseMatrix<double> made(rows, columns);
    made.setFromTriplets(list_.begin(), list_.end());
    return made;
  }

 private:
  std::vector<Eigen::Triplet<double, Index>> list_;
};

/// Coordinates that move together, and their inputs: M x'' + C x' + K x = F u. They belong to one
/// subsystem, or to the hub and all subsystems.
struct Part {
  MatrixXd M, C, K, F;
};

/// Names of a component of the hub's motion and of its force.
struct HubNames {
  const char *coordinate, *effort;
};
HubNames name_component(int c, const SteadyModel& model) {
  static constexpr HubNames kMoves[] = {{"x", "force x"}, {"y", "force y"}, {"z", "force z"}};
  static constexpr HubNames kTurns[] = {{"rotation x", "moment x"}, {"rotation y", "moment y"}};
  if (c == model.twist_size() - 1) return {"angle", "torque"};
  return c < model.first_rotation() ? kMoves[c] : kTurns[c - model.first_rotation()];
}

/// Returns a member of effects as the columns of a matrix.
MatrixXd to_columns(const std::vector<steady::LoadEffect>& effects,
                    Eigen::VectorXd steady::LoadEffect::*member, Index rows) {
  MatrixXd matrix(rows, std::ssize(effects));
  for (std::size_t k = 0; k < effects.size(); ++k)
    matrix.col(static_cast<Index>(k)) = effects[k].*member;
  return matrix;
}

/// Linearises a model; a rotor on a support, which must be at rest, on it.
steady::LinearModel linearize_standing(const steady::Equilibrium& equilibrium, SteadyModel& model) {
  steady::LinearModel linear = linearize_machine(equilibrium, model);
  if (!linear.support) return linear;
  if (model.speed() != 0.0)
    throw InputError(
        "support: the matrices of a rotor that turns on a support are not constant in the frame of "
        "its hub, expected a speed of 0 (--speed 0); spoke modes sees it from outside");
  steady::stand_on(*linear.support, linear);
  return linear;
}

class Assembly {
 public:
  Assembly(const Scenario& scenario, const steady::Equilibrium& equilibrium, SteadyModel& model)
      : equilibrium_(equilibrium),
        model_(model),
        linear_(linearize_standing(equilibrium, model)),
        kinematics_(make_hub_kinematics(model)),
        hub_motion_(find_hub_motion()),
        effects_(calc_load_effects(scenario, equilibrium, model)) {
    count();
    if (linear_.is_coupled() && size_ > kMostCoupled)
      throw InputError("blades couple through the hub and have " + std::to_string(size_) +
                       " coordinates, expected at most " + std::to_string(kMostCoupled) +
                       ": the matrices would be full");
  }

  LinearSystem make();

 private:
  const std::vector<int>& free() const { return model_.free_components(); }
  Index hub_size() const { return linear_.M.rows(); }
  /// Number of the coordinates that the loops of a subsystem leave independent.
  Index subsystem_size(std::size_t i) const { return linear_.subsystem(i).M.rows(); }
  Index load_count(std::size_t i) const { return std::ssize(effects_.subsystems[i]); }
  MatrixXd find_hub_motion() const;
  /// Returns how the hub's coordinates move what carries a subsystem: the hub, or a support's base.
  const MatrixXd& carrier_motion(std::size_t i) const {
    return model_.stands(i) ? linear_.support->base : hub_motion_;
  }
  bool has_axle() const { return linear_.support && linear_.support->of.back() == "axle"; }
  /// Number of the forces on the hub.
  Index effort_count() const { return std::ssize(free()) + (has_axle() ? 1 : 0); }
  bool turns(int c) const { return c >= model_.first_rotation(); }

  void count();
  void name_states();
  void name_inputs();
  Part make_subsystem_part(std::size_t i);
  Part make_whole_part();
  LinearSignal name_hub(int c) const;
  LinearSignal name_coordinate(std::size_t i, Index k) const;
  MatrixXd on_subsystem(std::size_t i) const;
  MatrixXd on_hub(const std::vector<steady::LoadEffect>& effects, const MatrixXd& motion) const;
  void add_part(const Part& part, Index coordinate, Index input);
  void add_outputs_of(std::size_t i);
  void add_by_coordinates(std::size_t i, Index row, const MatrixXd& by, Index first);
  void add_output(const LinearSignal& signal, Index column);
  void add_hub_outputs();
  void add_supported_hub_outputs();

  const steady::Equilibrium& equilibrium_;
  SteadyModel& model_;
  steady::LinearModel linear_;
  steady::HubKinematics kinematics_;
  MatrixXd hub_motion_;  ///< the hub's twist by its coordinates' rates
  steady::LoadEffects effects_;
  std::vector<Index> coordinates_, inputs_;  ///< first index of each subsystem
  Index size_ = 0;                           ///< number of all coordinates
  Index input_count_ = 0;
  MatrixXd hub_by_state_, hub_by_input_;  ///< accelerations of the hub's free coordinates
  Entries A_, B_, C_, D_;
  LinearSystem result_;
};

void Assembly::count() {
  size_ = hub_size();
  for (std::size_t i = 0; i < model_.subsystems(); ++i) {
    coordinates_.push_back(std::exchange(size_, size_ + subsystem_size(i)));
    inputs_.push_back(std::exchange(input_count_, input_count_ + load_count(i)));
  }
  if (linear_.is_coupled()) input_count_ += std::ssize(effects_.hub) + effort_count();
}

MatrixXd Assembly::find_hub_motion() const {
  if (linear_.support) return linear_.support->J;
  const Index d = model_.twist_size();
  const MatrixXd all = MatrixXd::Identity(d, d);
  return all(Eigen::all, free());
}

void Assembly::name_states() {
  std::vector<LinearSignal>& states = result_.states;
  if (const auto& support = linear_.support)
    for (std::size_t k = 0; k < support->names.size(); ++k)
      states.push_back({support->names[k], support->turns[k] ? "rad" : "m"});
  else
    for (const int c : free()) states.push_back(name_hub(c));
  for (std::size_t i = 0; i < model_.subsystems(); ++i)
    for (const Index k : linear_.subsystem(i).independent) states.push_back(name_coordinate(i, k));
  for (std::size_t k = 0; k < static_cast<std::size_t>(size_); ++k)
    states.push_back({"rate of " + states[k].name, states[k].unit + "/s"});
}

void Assembly::name_inputs() {
  std::vector<LinearSignal>& inputs = result_.inputs;
  for (const std::vector<steady::LoadEffect>& subsystem : effects_.subsystems)
    for (const steady::LoadEffect& effect : subsystem) inputs.push_back(effect.input);
  if (!linear_.is_coupled()) return;
  for (const steady::LoadEffect& effect : effects_.hub) inputs.push_back(effect.input);
  for (const int c : free())
    inputs.push_back(
        {std::string("hub / ") + name_component(c, model_).effort, turns(c) ? "N m" : "N"});
  if (has_axle()) inputs.push_back({"axle / torque", "N m"});
}

LinearSignal Assembly::name_hub(int c) const {
  return {std::string("hub / ") + name_component(c, model_).coordinate, turns(c) ? "rad" : "m"};
}

Part Assembly::make_subsystem_part(std::size_t i) {
  const steady::LinearSubsystem& subsystem = linear_.subsystem(i);
  return {subsystem.M, subsystem.C, subsystem.K, on_subsystem(i)};
}

LinearSignal Assembly::name_coordinate(std::size_t i, Index k) const {
  const steady::SubsystemCoordinate& coordinate =
      model_.coordinates(i)[static_cast<std::size_t>(k)];
  return {model_.name_of(i) + " / " + coordinate.name, coordinate.turns ? "rad" : "m"};
}

/// Returns the forces of the inputs of a subsystem on its independent coordinates.
MatrixXd Assembly::on_subsystem(std::size_t i) const {
  const MatrixXd force = to_columns(effects_.subsystems[i], &steady::LoadEffect::force,
                                    std::ssize(model_.coordinates(i)));
  const MatrixXd& Z = linear_.subsystem(i).basis;
  return Z.rows() == 0 ? force : MatrixXd(Z.transpose() * force);
}

/// Returns the forces of these effects on the hub's coordinates, by their wrench on what `motion`
/// moves.
MatrixXd Assembly::on_hub(const std::vector<steady::LoadEffect>& effects,
                          const MatrixXd& motion) const {
  return motion.transpose() *
         to_columns(effects, &steady::LoadEffect::hub_force, model_.twist_size());
}

Part Assembly::make_whole_part() {
  const MatrixXd zero = MatrixXd::Zero(size_, size_);
  Part part{zero, zero, zero, MatrixXd::Zero(size_, input_count_)};
  const Index h = hub_size();
  part.M.topLeftCorner(h, h) = linear_.M;
  part.C.topLeftCorner(h, h) = linear_.C;
  part.K.topLeftCorner(h, h) = linear_.K;
  for (std::size_t i = 0; i < model_.subsystems(); ++i) {
    const steady::LinearSubsystem& subsystem = linear_.subsystem(i);
    const steady::HubCoupling& hub = linear_.couplings[i];
    const Index at = coordinates_[i], n = subsystem_size(i);
    const auto put = [&](const MatrixXd& own, const MatrixXd& by_hub, const MatrixXd& on_hub,
                         MatrixXd& whole) {
      whole.block(at, at, n, n) = own;
      whole.block(at, 0, n, h) = by_hub;
      whole.block(0, at, h, n) = on_hub;
    };
    put(subsystem.M, hub.M_bh, hub.M_hb, part.M);
    put(subsystem.C, hub.C_bh, hub.C_hb, part.C);
    put(subsystem.K, hub.K_bh, hub.K_hb, part.K);
    const std::vector<steady::LoadEffect>& effects = effects_.subsystems[i];
    part.F.block(at, inputs_[i], n, load_count(i)) = on_subsystem(i);
    part.F.block(0, inputs_[i], h, load_count(i)) = on_hub(effects, carrier_motion(i));
    if (hub.following.size() > 0 && load_count(i) > 0)
      part.F.block(0, inputs_[i], h, load_count(i)) +=
          hub.following.transpose() *
          to_columns(effects, &steady::LoadEffect::force, std::ssize(model_.coordinates(i)));
  }
  const Index loads = std::ssize(effects_.hub), own = input_count_ - effort_count();
  part.F.block(0, own - loads, h, loads) = on_hub(effects_.hub, hub_motion_);
  const MatrixXd by_effort = hub_motion_.transpose();
  part.F.block(0, own, h, std::ssize(free())) = by_effort(Eigen::all, free());
  if (has_axle()) part.F(h - 1, input_count_ - 1) = 1.0;
  return part;
}

/// Adds the part's rows of A and B: x'' = -M^-1 (K x + C x' - F u).
void Assembly::add_part(const Part& part, Index coordinate, Index input) {
  const Index n = part.M.rows();
  const LuFactors mass(part.M);
  const MatrixXd by_x = -mass.solve(part.K), by_rate = -mass.solve(part.C);
  MatrixXd by_input(n, part.F.cols());
  if (part.F.cols() > 0) by_input = mass.solve(part.F);  // Eigen does not solve for empty blocks
  A_.add(coordinate, size_ + coordinate, MatrixXd::Identity(n, n));
  A_.add(size_ + coordinate, coordinate, by_x);
  A_.add(size_ + coordinate, size_ + coordinate, by_rate);
  B_.add(size_ + coordinate, input, by_input);
  if (!linear_.is_coupled()) return;
  hub_by_state_.resize(hub_size(), 2 * n);
  hub_by_state_ << by_x.topRows(hub_size()), by_rate.topRows(hub_size());
  hub_by_input_ = by_input.topRows(hub_size());
}

/// Adds the outputs of tip and sensors of a subsystem, by its own motion and by the hub's.
void Assembly::add_outputs_of(std::size_t i) {
  const steady::OutputDerivatives by =
      calc_output_derivatives(i, steady::make_state(equilibrium_.q[i]), model_);
  const Index row = std::ssize(result_.outputs);
  const std::vector<LinearSignal>& signals = model_.outputs(i);
  result_.outputs.insert(result_.outputs.end(), signals.begin(), signals.end());
  add_by_coordinates(i, row, by.by_q, 0);
  add_by_coordinates(i, row, by.by_v, size_);
  D_.add(row, inputs_[i],
         to_columns(effects_.subsystems[i], &steady::LoadEffect::outputs, std::ssize(signals)));
  if (linear_.is_coupled()) {
    const auto by_hub = [&](const MatrixXd& m) { return MatrixXd(m * carrier_motion(i)); };
    const MatrixXd by_acceleration = by_hub(by.by_acceleration);
    C_.add(row, 0,
           by_hub(by.by_turn + by.by_twist * kinematics_.W + by.by_acceleration * kinematics_.P0));
    C_.add(row, size_, by_hub(by.by_twist + by.by_acceleration * kinematics_.P1));
    C_.add(row, 0, by_acceleration * hub_by_state_);
    D_.add(row, 0, by_acceleration * hub_by_input_);
  }
  const Index all = std::ssize(model_.coordinates(i));
  for (Index k = 0; k < all; ++k) {
    if (model_.coordinates(i)[static_cast<std::size_t>(k)].node >= 0) continue;
    add_by_coordinates(i, std::ssize(result_.outputs),
                       Eigen::RowVectorXd(Eigen::RowVectorXd::Unit(all, k)), 0);
    result_.outputs.push_back(name_coordinate(i, k));
  }
}

/// Adds derivatives by all coordinates of a subsystem, or by their rates, whose states begin at
/// `first`.
void Assembly::add_by_coordinates(std::size_t i, Index row, const MatrixXd& by, Index first) {
  const MatrixXd& Z = linear_.subsystem(i).basis;
  C_.add(row, first + coordinates_[i], Z.rows() > 0 ? MatrixXd(by * Z) : by);
  if (!linear_.is_coupled()) return;
  const MatrixXd& G = linear_.couplings[i].following;
  if (G.size() > 0) C_.add(row, first, by * G);
}

/// Adds an output that is a state.
void Assembly::add_output(const LinearSignal& signal, Index column) {
  C_.add(std::ssize(result_.outputs), column, MatrixXd::Ones(1, 1));
  result_.outputs.push_back(signal);
}

void Assembly::add_hub_outputs() {
  if (linear_.support) return add_supported_hub_outputs();
  for (Index k = 0; k < hub_size(); ++k)
    for (const Index column : {k, size_ + k})
      add_output(result_.states[static_cast<std::size_t>(column)], column);
}

/// Adds the motion of a hub on a support.
void Assembly::add_supported_hub_outputs() {
  for (const int c : free()) {
    const LinearSignal moved = name_hub(c);
    for (const bool is_rate : {false, true}) {
      C_.add(std::ssize(result_.outputs), is_rate ? size_ : 0, hub_motion_.row(c));
      result_.outputs.push_back(is_rate ? LinearSignal{"rate of " + moved.name, moved.unit + "/s"}
                                        : moved);
    }
  }
}

LinearSystem Assembly::make() {
  name_states();
  name_inputs();
  if (linear_.is_coupled()) {
    add_part(make_whole_part(), 0, 0);
  } else {
    for (std::size_t i = 0; i < model_.subsystems(); ++i)
      add_part(make_subsystem_part(i), coordinates_[i], inputs_[i]);
  }
  for (std::size_t i = 0; i < model_.subsystems(); ++i) add_outputs_of(i);
  add_hub_outputs();
  const Index outputs = std::ssize(result_.outputs);
  result_.A = A_.matrix(2 * size_, 2 * size_);
  result_.B = B_.matrix(2 * size_, input_count_);
  result_.C = C_.matrix(outputs, 2 * size_);
  result_.D = D_.matrix(outputs, input_count_);
  result_.left_out = model_.other_sensors();
  return std::move(result_);
}

}  // namespace

LinearSystem solve_linear_system(const Scenario& scenario, const SteadyState& state) {
  check_scenario(scenario);
  const double speed = steady::find_steady_speed(scenario, state.speed);
  const std::unique_ptr<SteadyModel> model =
      steady::make_steady_model(scenario, {.speed = speed, .has_outputs = true});
  const steady::Equilibrium equilibrium = steady::find_machine_equilibrium(*model);
  steady::require_steady_machine(*model, equilibrium);
  LinearSystem system = Assembly(scenario, equilibrium, *model).make();
  system.equilibrium = describe(equilibrium, *model);
  steady::add_warnings(scenario, system.equilibrium);
  return system;
}

}  // namespace spoke
