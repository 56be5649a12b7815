// Puts the matrices of subsystems and hub together.

#include "engine/small_motions/steady/linear_system.h"

#include <utility>

#include "engine/small_motions/steady/azimuths.h"
#include "engine/small_motions/steady/joined_rotors.h"
#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/linear_support.h"
#include "engine/small_motions/steady/load_effects.h"
#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/steady/state_space.h"
#include "engine/small_motions/steady/supported_model.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Coordinates that move together, and their inputs: M x'' + C x' + K x = F u. They belong to one
/// subsystem, or to the hub and all subsystems.
struct Part {
  MatrixXd M, C, K, F;
};

/// Returns a member of effects as the columns of a matrix.
MatrixXd to_columns(const std::vector<LoadEffect>& effects, Eigen::VectorXd LoadEffect::*member,
                    Index rows) {
  MatrixXd matrix(rows, std::ssize(effects));
  for (std::size_t k = 0; k < effects.size(); ++k)
    matrix.col(static_cast<Index>(k)) = effects[k].*member;
  return matrix;
}

/// Linearises a model; a rotor on a support, which must be at rest, on it.
LinearModel linearize_standing(const Equilibrium& equilibrium, SteadyModel& model) {
  LinearModel linear = linearize_machine(equilibrium, model);
  require_constant(linear, equilibrium, model);
  if (!linear.support) return linear;
  if (model.turns())
    throw InputError(
        "the frame \"turning\" expects a hub whose support does not move, or a speed of 0: on a "
        "support the frame \"fixed\" has constant matrices");
  stand_on(*linear.support, linear);
  return linear;
}

class Assembly {
 public:
  Assembly(const Scenario& scenario, const Equilibrium& equilibrium, SteadyModel& model)
      : equilibrium_(equilibrium),
        model_(model),
        linear_(linearize_standing(equilibrium, model)),
        kinematics_(make_hub_kinematics(model)),
        effects_(calc_load_effects(scenario, equilibrium, model)) {
    for (std::size_t h = 0; h < model.hubs(); ++h) hub_motions_.push_back(find_hub_motion(h));
    if (linear_.is_coupled()) find_hub_inputs();
    count();
    if (linear_.is_coupled()) require_few_coupled(size_);
  }

  LinearSystem make();

 private:
  const std::vector<int>& free() const { return model_.free_components(); }
  Index hub_size() const { return linear_.M.rows(); }
  /// Number of the coordinates that the loops of a subsystem leave independent.
  Index subsystem_size(std::size_t i) const { return linear_.subsystem(i).M.rows(); }
  Index load_count(std::size_t i) const { return std::ssize(effects_.subsystems[i]); }
  MatrixXd find_hub_motion(std::size_t hub) const;
  /// Returns how the hub's coordinates move what carries a subsystem: the hub, or a support's base.
  const MatrixXd& carrier_motion(std::size_t i) const {
    return model_.stands(i) ? linear_.support->base : hub_motions_[model_.hub_of(i)];
  }
  void find_hub_inputs();

  void count();
  void name_states();
  void name_inputs();
  void add_hub_input(const LinearSignal& signal, const Eigen::VectorXd& force);
  Part make_subsystem_part(std::size_t i);
  Part make_whole_part();
  LinearSignal name_coordinate(std::size_t i, Index k) const;
  MatrixXd on_subsystem(std::size_t i) const;
  MatrixXd on_hub(const std::vector<LoadEffect>& effects, const MatrixXd& motion) const;
  void add_part(const Part& part, Index coordinate, Index input);
  void add_outputs_of(std::size_t i);
  void add_by_coordinates(std::size_t i, Index row, const MatrixXd& by, Index first);
  void add_by_forces(std::size_t i, Index row, const MatrixXd& by);
  std::vector<Index> list_forces(std::size_t i) const;
  void add_output(const LinearSignal& signal, Index column);
  void add_hub_outputs();
  void add_supported_hub_outputs();

  const Equilibrium& equilibrium_;
  SteadyModel& model_;
  LinearModel linear_;
  HubKinematics kinematics_;
  std::vector<MatrixXd> hub_motions_;  ///< by hub: its twist by the hub's coordinates' rates
  LoadEffects effects_;
  std::vector<LinearSignal> hub_inputs_;     ///< behind those of subsystems
  std::vector<Eigen::VectorXd> hub_forces_;  ///< of these, on the hub's coordinates
  std::vector<Index> coordinates_, inputs_;  ///< first index of each subsystem
  Index size_ = 0;                           ///< number of all coordinates
  Index input_count_ = 0;
  MatrixXd hub_by_state_, hub_by_input_;  ///< accelerations of the hub's free coordinates
  MatrixEntries A_, B_, C_, D_;
  LinearSystem result_;
};

void Assembly::count() {
  size_ = hub_size();
  for (std::size_t i = 0; i < model_.subsystems(); ++i) {
    coordinates_.push_back(std::exchange(size_, size_ + subsystem_size(i)));
    inputs_.push_back(std::exchange(input_count_, input_count_ + load_count(i)));
  }
  input_count_ += std::ssize(hub_inputs_);
}

MatrixXd Assembly::find_hub_motion(std::size_t hub) const {
  if (linear_.support) return rows_of(hub, linear_.support->J);
  const Index d = model_.twist_size();
  const MatrixXd all = MatrixXd::Identity(d, d);
  return all(Eigen::all, free());
}

void Assembly::add_hub_input(const LinearSignal& signal, const Eigen::VectorXd& force) {
  hub_inputs_.push_back(signal);
  hub_forces_.push_back(force);
}

/// Finds the inputs of hubs: loads, then forces on what moves freely, then the torques of drives.
void Assembly::find_hub_inputs() {
  for (std::size_t h = 0; h < model_.hubs(); ++h)
    for (const LoadEffect& effect : effects_.hubs[h])
      add_hub_input(effect.input, hub_motions_[h].transpose() * effect.hub_force);
  for (std::size_t h = 0; h < model_.hubs(); ++h)
    for (const int c : free())
      add_hub_input(name_hub_effort(h, c, model_), hub_motions_[h].row(c).transpose());
  if (!linear_.support) return;
  for (std::size_t h = 0; h < model_.hubs(); ++h)
    if (const Eigen::VectorXd& drive = linear_.support->drives[h]; !drive.isZero(0.0))
      add_hub_input(name_drive_torque(h, model_), drive);
}

void Assembly::name_states() {
  std::vector<LinearSignal>& states = result_.states;
  states = name_hub_states(linear_, model_);
  for (std::size_t i = 0; i < model_.subsystems(); ++i)
    for (const SubsystemCoordinate& coordinate : list_independent(i, linear_, model_))
      states.push_back({model_.full_name(i, coordinate.name), coordinate.unit()});
  for (std::size_t k = 0; k < static_cast<std::size_t>(size_); ++k)
    states.push_back(rate_of(states[k]));
}

void Assembly::name_inputs() {
  std::vector<LinearSignal>& inputs = result_.inputs;
  for (const std::vector<LoadEffect>& subsystem : effects_.subsystems)
    for (const LoadEffect& effect : subsystem) inputs.push_back(effect.input);
  inputs.insert(inputs.end(), hub_inputs_.begin(), hub_inputs_.end());
}

Part Assembly::make_subsystem_part(std::size_t i) {
  const LinearSubsystem& subsystem = linear_.subsystem(i);
  return {subsystem.M, subsystem.C, subsystem.K, on_subsystem(i)};
}

LinearSignal Assembly::name_coordinate(std::size_t i, Index k) const {
  const SubsystemCoordinate& coordinate = model_.coordinates(i)[static_cast<std::size_t>(k)];
  return {model_.full_name(i, coordinate.name), coordinate.unit()};
}

/// Returns the forces of the inputs of a subsystem on its independent coordinates.
MatrixXd Assembly::on_subsystem(std::size_t i) const {
  const MatrixXd force =
      to_columns(effects_.subsystems[i], &LoadEffect::force, std::ssize(model_.coordinates(i)));
  const MatrixXd& Z = linear_.subsystem(i).basis;
  return Z.rows() == 0 ? force : MatrixXd(Z.transpose() * force);
}

/// Returns the forces of these effects on the hub's coordinates, by their wrench on what `motion`
/// moves.
MatrixXd Assembly::on_hub(const std::vector<LoadEffect>& effects, const MatrixXd& motion) const {
  return motion.transpose() * to_columns(effects, &LoadEffect::hub_force, model_.twist_size());
}

Part Assembly::make_whole_part() {
  const MatrixXd zero = MatrixXd::Zero(size_, size_);
  Part part{zero, zero, zero, MatrixXd::Zero(size_, input_count_)};
  const Index h = hub_size();
  part.M.topLeftCorner(h, h) = linear_.M;
  part.C.topLeftCorner(h, h) = linear_.C;
  part.K.topLeftCorner(h, h) = linear_.K;
  for (std::size_t i = 0; i < model_.subsystems(); ++i) {
    const LinearSubsystem& subsystem = linear_.subsystem(i);
    const HubCoupling& hub = linear_.couplings[i];
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
    const std::vector<LoadEffect>& effects = effects_.subsystems[i];
    part.F.block(at, inputs_[i], n, load_count(i)) = on_subsystem(i);
    part.F.block(0, inputs_[i], h, load_count(i)) = on_hub(effects, carrier_motion(i));
    if (hub.following.size() > 0 && load_count(i) > 0)
      part.F.block(0, inputs_[i], h, load_count(i)) +=
          hub.following.transpose() *
          to_columns(effects, &LoadEffect::force, std::ssize(model_.coordinates(i)));
  }
  Index column = input_count_ - std::ssize(hub_forces_);
  for (const Eigen::VectorXd& force : hub_forces_) part.F.col(column++).head(h) = force;
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
  const OutputDerivatives by = calc_output_derivatives(i, make_state(equilibrium_.q[i]), model_);
  const Index row = std::ssize(result_.outputs);
  const std::vector<LinearSignal>& signals = model_.outputs(i);
  result_.outputs.insert(result_.outputs.end(), signals.begin(), signals.end());
  add_by_coordinates(i, row, by.by_q, 0);
  add_by_coordinates(i, row, by.by_v, size_);
  add_by_forces(i, row, by.by_forces);
  D_.add(row, inputs_[i],
         to_columns(effects_.subsystems[i], &LoadEffect::outputs, std::ssize(signals)));
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

/// Returns the numbers of the forces of a subsystem among the coordinates.
std::vector<Index> Assembly::list_forces(std::size_t i) const {
  std::vector<Index> list =
      model_.stands(i) ? linear_.support->forces : linear_.subsystem(i).forces;
  if (!model_.stands(i))
    for (Index& k : list) k += coordinates_[i];
  return list;
}

void Assembly::add_by_forces(std::size_t i, Index row, const MatrixXd& by) {
  const std::vector<Index> columns = list_forces(i);
  for (std::size_t k = 0; k < columns.size(); ++k)
    C_.add(row, columns[k], by.col(static_cast<Index>(k)));
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

/// Adds the motion of hubs on a support.
void Assembly::add_supported_hub_outputs() {
  for (std::size_t h = 0; h < model_.hubs(); ++h)
    for (const int c : free()) {
      const LinearSignal moved = name_hub_motion(h, c, model_);
      for (const bool is_rate : {false, true}) {
        C_.add(std::ssize(result_.outputs), is_rate ? size_ : 0, hub_motions_[h].row(c));
        result_.outputs.push_back(is_rate ? rate_of(moved) : moved);
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
  std::vector<Index> forces;
  for (std::size_t i = 0; i < model_.subsystems(); ++i)
    for (const Index k : list_forces(i)) forces.push_back(k);
  take_out_rates(std::move(forces), result_);
  return std::move(result_);
}

}  // namespace

LinearSystem make_turning_system(const Scenario& scenario, const Equilibrium& equilibrium,
                                 SteadyModel& model) {
  return Assembly(scenario, equilibrium, model).make();
}

}  // namespace spoke::steady
