// Puts the matrices of patterns of blades, hub and support together.

#include "engine/small_motions/vibration/multi_blade_system.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/small_motions/steady/joined_rotors.h"
#include "engine/small_motions/steady/output_derivatives.h"
#include "engine/small_motions/steady/state_space.h"
#include "engine/small_motions/vibration/blade_amplitude.h"
#include "engine/small_motions/vibration/family_blades.h"
#include "engine/small_motions/vibration/fixed_modes.h"
#include "engine/small_motions/vibration/multi_blade_inputs.h"
#include "engine/small_motions/vibration/multi_blade_outputs.h"
#include "engine/support/dense.h"
#include "models/error.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Patterns that have a problem of their own, or that meet at the hub.
struct Group {
  std::vector<std::size_t> patterns;
  bool has_hub = false;
};

/// By an amplitude itself, and by the other one of its pair.
struct RingSums {
  MatrixXd by_same, by_partner;
};

/// Returns 1 of a cosine, whose partner comes behind it, and -1 of a sine.
double side_of(const Amplitude& amplitude) { return amplitude.is_sine ? -1.0 : 1.0; }

Amplitude partner_of(Amplitude amplitude) {
  amplitude.is_sine = !amplitude.is_sine;
  return amplitude;
}

/// Returns n times the angle to the blade of a ring that is `k` further on.
double turn_to(std::size_t k, const Amplitude& amplitude, std::size_t blades) {
  return amplitude.multiple * 2.0 * std::numbers::pi * static_cast<double>(k) /
         static_cast<double>(blades);
}

class MultiBladeAssembly {
 public:
  MultiBladeAssembly(const Scenario& scenario, const Linearised& all)
      : all_(all),
        frame_(see_from_outside(all)),
        hubs_(find_hubs()),
        inputs_(find_inputs(scenario, all, frame_, hubs_.front().axes.T)),
        size_(frame_.start(frame_.patterns.size())) {}

  LinearSystem make();

 private:
  /// A hub that blades are on.
  struct Hub {
    StandingAxes axes;  ///< of all components of a twist
    MatrixXd motion;    ///< how the frame's hub coordinates move it, all components
  };

  Index hub_size() const { return frame_.model.M.rows(); }
  const steady::LinearSupport* support() const {
    return all_.linear.support ? &*all_.linear.support : nullptr;
  }
  double blades_of(std::size_t family) const {
    return static_cast<double>(frame_.families[family].azimuths.size());
  }
  const Hub& hub_of(std::size_t family) const { return hubs_[frame_.families[family].rotor]; }
  std::vector<Hub> find_hubs() const;
  MatrixXd find_motion(std::size_t hub) const;
  std::vector<Amplitude> list_amplitudes(std::size_t family) const;
  std::vector<Group> list_groups() const;

  void name_states();
  void add_input(const LinearSignal& signal, const VectorXd& force);
  void add_blade_inputs(std::size_t family);
  void add_standing_inputs();
  void add_hub_inputs();
  std::vector<Index> list_coordinates(const Group& group) const;
  std::vector<Index> list_forces() const;
  SecondOrder assemble(const Group& group, Index size) const;
  void add_group(const Group& group);
  void add_hub_rows(Index row, const SecondOrder& by_hub);
  void add_blade_outputs(std::size_t family);
  MatrixXd show(const BladeInput& input, const Amplitude& to, const Amplitude& by) const;
  void add_pattern_outputs(std::size_t family, const BladeOutputs& outputs, const Amplitude& to);
  void add_support_outputs();
  void add_hub_outputs();
  void add_output(const LinearSignal& signal) { result_.outputs.push_back(signal); }

  const Linearised& all_;
  FixedFrame frame_;
  std::vector<Hub> hubs_;
  MultiBladeInputs inputs_;
  Index size_ = 0;                                  ///< number of all coordinates
  std::vector<VectorXd> forces_;                    ///< of inputs on all coordinates
  std::vector<std::vector<Amplitude>> amplitudes_;  ///< by family
  std::vector<Index> first_inputs_;                 ///< of families
  Index first_standing_ = 0;                        ///< input
  std::vector<Index> hub_group_;                    ///< coordinates that meet at the hub
  MatrixXd hub_by_x_, hub_by_rate_, hub_by_input_;  ///< accelerations of the hub's coordinates
  steady::MatrixEntries A_, B_, C_, D_;
  LinearSystem result_;
};

std::vector<MultiBladeAssembly::Hub> MultiBladeAssembly::find_hubs() const {
  std::vector<Hub> hubs;
  const std::vector<int> all = list_components(all_.model, steady::HubFreedom::all);
  for (std::size_t h = 0; h < all_.model.hubs(); ++h)
    hubs.push_back({make_standing_axes(all, all_.model.is_spatial(), all_.model.rotor(h).speed()),
                    find_motion(h)});
  return hubs;
}

MatrixXd MultiBladeAssembly::find_motion(std::size_t hub) const {
  if (support()) return steady::rows_of(hub, support()->J);
  const Index d = all_.model.twist_size();
  const MatrixXd all = MatrixXd::Identity(d, d);
  return all(Eigen::all, all_.model.free_components());
}

std::vector<Amplitude> MultiBladeAssembly::list_amplitudes(std::size_t family) const {
  std::vector<Amplitude> list;
  for (std::size_t k = 0; k < frame_.patterns.size(); ++k) {
    const BladePattern& pattern = frame_.patterns[k];
    if (pattern.family != family) continue;
    const int n = pattern.multiple;
    const std::string order = n > 1 ? " order " + std::to_string(n) : "";
    const Index at = frame_.start(k);
    if (pattern.is_pair) {
      list.push_back({k, n, false, false, at, "cosine" + order});
      list.push_back({k, n, true, false, at + pattern.size, "sine" + order});
    } else {
      list.push_back({k, n, false, pattern.is_differential, at,
                      frame_.families[family].is_shaft() ? ""
                      : pattern.is_differential          ? "differential"
                                                         : "collective"});
    }
  }
  return list;
}

std::vector<Group> MultiBladeAssembly::list_groups() const {
  std::vector<Group> groups;
  Group meeting{{}, true};
  for (std::size_t k = 0; k < frame_.patterns.size(); ++k) {
    const BladePattern& pattern = frame_.patterns[k];
    const bool meets =
        frame_.model.is_coupled() && !pattern.is_differential && pattern.multiple <= 1;
    if (meets)
      meeting.patterns.push_back(k);
    else
      groups.push_back({{k}, false});
  }
  if (frame_.model.is_coupled()) groups.push_back(std::move(meeting));
  return groups;
}

void MultiBladeAssembly::name_states() {
  std::vector<LinearSignal>& states = result_.states;
  states = name_hub_states(all_.linear, all_.model);
  for (std::size_t f = 0; f < frame_.families.size(); ++f) {
    const BladeFamily& family = frame_.families[f];
    const std::string of = name_family(family, all_.model) + " / ";
    for (const Amplitude& amplitude : amplitudes_[f])
      for (const steady::SubsystemCoordinate& coordinate :
           list_independent(list_blades(family, all_)[0], all_.linear))
        states.push_back({amplitude.of(of + coordinate.name), coordinate.unit()});
  }
  assert(std::ssize(states) == size_);
  for (std::size_t k = 0; k < static_cast<std::size_t>(size_); ++k)
    states.push_back(steady::rate_of(states[k]));
}

void MultiBladeAssembly::add_input(const LinearSignal& signal, const VectorXd& force) {
  result_.inputs.push_back(signal);
  forces_.push_back(force);
}

/// Adds the amplitudes of inputs of blades: forces on each amplitude of the motion, by the equation
/// of one blade, and on the hub the sum over the blades.
void MultiBladeAssembly::add_blade_inputs(std::size_t family) {
  first_inputs_.push_back(std::ssize(forces_));
  const Hub& hub = hub_of(family);
  for (const BladeInput& input : inputs_.families[family])
    for (const Amplitude& by : amplitudes_[family]) {
      VectorXd force = VectorXd::Zero(size_);
      for (const Amplitude& to : amplitudes_[family])
        force.segment(to.at, input.force.mean.rows()) = to.size() * average(to, by).of(input.force);
      if (!by.is_differential && hub_size() > 0)
        force.head(hub_size()) =
            hub.motion.transpose() *
            (frame_.families[family].is_shaft()
                 ? VectorXd(input.hub.mean)
                 : VectorXd(blades_of(family) * average_on_hub(hub.axes.T, input.hub, by)));
      add_input({by.of(input.input.name), input.input.unit}, force);
    }
}

void MultiBladeAssembly::add_standing_inputs() {
  first_standing_ = std::ssize(forces_);
  for (const StandingInput& input : inputs_.standing) {
    VectorXd force = VectorXd::Zero(size_);
    if (hub_size() > 0) force.head(hub_size()) = hubs_[input.rotor].motion.transpose() * input.hub;
    if (input.support.force.size() > 0)
      force.head(hub_size()) += support()->motion.transpose() * input.support.force +
                                support()->base.transpose() * input.support.hub_force;
    add_input(input.input, force);
  }
}

/// Returns the numbers of forces of relaxing joints among all coordinates.
std::vector<Index> MultiBladeAssembly::list_forces() const {
  std::vector<Index> list = support() ? support()->forces : std::vector<Index>();
  for (std::size_t f = 0; f < frame_.families.size(); ++f) {
    const FamilyBlade blade = list_blades(frame_.families[f], all_)[0];
    for (const Amplitude& amplitude : amplitudes_[f])
      for (const Index k : all_.linear.subsystem(blade.subsystem).forces)
        if (blade.independent.has(k)) list.push_back(amplitude.at + k - blade.independent.first);
  }
  return list;
}

/// Adds the forces on each hub along standing axes, and the torques between hubs and carriers.
void MultiBladeAssembly::add_hub_inputs() {
  const auto add = [this](const LinearSignal& signal, const VectorXd& on_hub) {
    VectorXd force = VectorXd::Zero(size_);
    force.head(hub_size()) = on_hub;
    add_input(signal, force);
  };
  for (std::size_t h = 0; h < hubs_.size(); ++h)
    for (const int c : all_.model.free_components())
      add(name_hub_effort(h, c, all_.model), hubs_[h].motion.row(c).transpose());
  if (!support()) return;
  for (std::size_t h = 0; h < hubs_.size(); ++h)
    if (!support()->drives[h].isZero(0.0))
      add(name_drive_torque(h, all_.model), support()->drives[h]);
}

/// Returns the numbers of a group's coordinates among all: the hub's first.
std::vector<Index> MultiBladeAssembly::list_coordinates(const Group& group) const {
  std::vector<Index> at;
  const auto append = [&at](Index first, Index count) {
    for (Index k = 0; k < count; ++k) at.push_back(first + k);
  };
  if (group.has_hub) append(0, hub_size());
  for (const std::size_t k : group.patterns)
    append(frame_.start(k), frame_.model.subsystem(k).M.rows());
  return at;
}

/// Returns the matrices of a group. Amplitudes are 1/sqrt(N), or of pairs sqrt(2/N), of the frame's
/// orthonormal coordinates, and so are their equations.
SecondOrder MultiBladeAssembly::assemble(const Group& group, Index size) const {
  const steady::LinearModel& model = frame_.model;
  const MatrixXd zero = MatrixXd::Zero(size, size);
  SecondOrder all{zero, zero, zero};
  const Index h = group.has_hub ? hub_size() : 0;
  if (group.has_hub) {
    all.M.topLeftCorner(h, h) = model.M;
    all.C.topLeftCorner(h, h) = model.C;
    all.K.topLeftCorner(h, h) = model.K;
  }
  Index row = h;
  for (const std::size_t k : group.patterns) {
    const steady::LinearSubsystem& own = model.subsystem(k);
    const Index rows = own.M.rows();
    all.M.block(row, row, rows, rows) = own.M;
    all.C.block(row, row, rows, rows) = own.C;
    all.K.block(row, row, rows, rows) = own.K;
    if (group.has_hub) {
      const steady::HubCoupling& hub = model.couplings[k];
      const BladePattern& pattern = frame_.patterns[k];
      const double scale = std::sqrt(blades_of(pattern.family) / (pattern.is_pair ? 2.0 : 1.0));
      const auto couple = [&](const MatrixXd& bh, const MatrixXd& hb, MatrixXd& whole) {
        whole.block(row, 0, rows, h) = bh / scale;
        whole.block(0, row, h, rows) = hb * scale;
      };
      couple(hub.M_bh, hub.M_hb, all.M);
      couple(hub.C_bh, hub.C_hb, all.C);
      couple(hub.K_bh, hub.K_hb, all.K);
    }
    row += rows;
  }
  return all;
}

/// Adds the rows of A and B of coordinates that move together: x'' = -M^-1 (K x + C x' - F u).
void MultiBladeAssembly::add_group(const Group& group) {
  const std::vector<Index> at = list_coordinates(group);
  const Index n = std::ssize(at), inputs = std::ssize(forces_);
  if (group.has_hub) steady::require_few_coupled(n);
  const SecondOrder own = assemble(group, n);
  const LuFactors mass(own.M);
  const MatrixXd by_x = -mass.solve(own.K), by_rate = -mass.solve(own.C);
  MatrixXd F(n, inputs), by_input(n, inputs);
  std::vector<Index> columns;
  for (Index k = 0; k < inputs; ++k) {
    F.col(k) = forces_[static_cast<std::size_t>(k)](at);
    columns.push_back(k);
  }
  if (inputs > 0) by_input = mass.solve(F);  // Eigen does not solve for empty blocks
  A_.add(0, at, size_, at, MatrixXd::Identity(n, n));
  A_.add(size_, at, 0, at, by_x);
  A_.add(size_, at, size_, at, by_rate);
  B_.add(size_, at, 0, columns, by_input);
  if (!group.has_hub) return;
  hub_group_ = at;
  hub_by_x_ = by_x.topRows(hub_size());
  hub_by_rate_ = by_rate.topRows(hub_size());
  hub_by_input_ = by_input.topRows(hub_size());
}

/// Adds what outputs from `row` on show of the hub's coordinates, by these, their rates and their
/// accelerations.
void MultiBladeAssembly::add_hub_rows(Index row, const SecondOrder& by_hub) {
  C_.add(row, 0, by_hub.K);
  C_.add(row, size_, by_hub.C);
  std::vector<Index> rows;
  for (Index k = 0; k < by_hub.M.rows(); ++k) rows.push_back(k);
  C_.add(row, rows, 0, hub_group_, by_hub.M * hub_by_x_);
  C_.add(row, rows, size_, hub_group_, by_hub.M * hub_by_rate_);
  D_.add(row, 0, by_hub.M * hub_by_input_);
}

/// Sums up derivatives by the blades of a ring, by how far each is on: the one at psi + 2 pi k/N
/// has the values a_c cos n psi_k + a_s sin n psi_k.
RingSums sum_ring(const std::vector<MatrixXd>& by, const Amplitude& to) {
  RingSums sums{MatrixXd::Zero(by[0].rows(), by[0].cols()), {}};
  sums.by_partner = sums.by_same;
  for (std::size_t k = 0; k < by.size(); ++k) {
    const double angle = turn_to(k, to, by.size());
    sums.by_same += std::cos(angle) * by[k];
    if (to.size() > 1.0) sums.by_partner += side_of(to) * std::sin(angle) * by[k];
  }
  return sums;
}

/// Returns what an amplitude of an input adds to one of the outputs, of all blades that it moves.
MatrixXd MultiBladeAssembly::show(const BladeInput& input, const Amplitude& to,
                                  const Amplitude& by) const {
  const std::size_t count = input.outputs.size();
  MatrixXd shown = MatrixXd::Zero(input.outputs[0].mean.rows(), input.outputs[0].mean.cols());
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = turn_to(k, to, count);
    shown += std::cos(angle) * average(to, by).of(input.outputs[k]);
    if (to.size() > 1.0)
      shown -= side_of(to) * std::sin(angle) * average(partner_of(to), by).of(input.outputs[k]);
  }
  return to.size() * shown;
}

/// Adds an amplitude of what blades show: as y = a_c cos n psi + a_s sin n psi,
/// y' = (a_c' + n W a_s) cos n psi + (a_s' - n W a_c) sin n psi.
void MultiBladeAssembly::add_pattern_outputs(std::size_t family, const BladeOutputs& outputs,
                                             const Amplitude& to) {
  const Index row = std::ssize(result_.outputs);
  const std::string of = name_family(frame_.families[family], all_.model) + " / ";
  for (const LinearSignal& signal : outputs.signals)
    add_output({to.of(of + signal.name), signal.unit});
  const RingSums by_y = sum_ring(outputs.by_y, to), by_rate = sum_ring(outputs.by_rate, to);
  C_.add(row, to.at, by_y.by_same);
  C_.add(row, size_ + to.at, by_rate.by_same);
  if (to.size() > 1.0) {
    const Index partner = to.at + static_cast<Index>(side_of(to)) * outputs.by_y[0].cols();
    const double rate = side_of(to) * to.multiple * hub_of(family).axes.speed;
    C_.add(row, partner, by_y.by_partner);
    C_.add(row, size_ + partner, by_rate.by_partner);
    C_.add(row, partner, rate * by_rate.by_same);
    C_.add(row, to.at, -rate * by_rate.by_partner);
  }
  Index column = first_inputs_[family];
  for (const BladeInput& input : inputs_.families[family])
    for (const Amplitude& by : amplitudes_[family])
      D_.add(row, column++, MatrixXd(show(input, to, by)(outputs.shown, Eigen::all)));
  if (hub_size() == 0 || to.is_differential || to.multiple > 1) return;
  const Turning& T = hub_of(family).axes.T;
  const MatrixXd turn = frame_.families[family].is_shaft()
                            ? hub_of(family).motion
                            : MatrixXd((to.multiple == 0 ? T.mean
                                        : to.is_sine     ? MatrixXd(T.sine.transpose())
                                                         : T.cosine) *
                                       hub_of(family).motion);
  const SecondOrder& by = outputs.by_hub;
  add_hub_rows(row, {by.M * turn, by.C * turn, by.K * turn});
}

void MultiBladeAssembly::add_blade_outputs(std::size_t family) {
  const BladeOutputs outputs =
      find_outputs(frame_.families[family], all_, hub_of(family).axes, result_.left_out);
  for (const Amplitude& to : amplitudes_[family]) add_pattern_outputs(family, outputs, to);
}

/// Adds what sensors on the support show, and the coordinates of its joints.
void MultiBladeAssembly::add_support_outputs() {
  const std::size_t i = all_.model.subsystems() - 1;
  const steady::OutputDerivatives by =
      calc_output_derivatives(i, steady::make_state(all_.equilibrium.q[i]), all_.model);
  const Index row = std::ssize(result_.outputs);
  const MatrixXd& motion = support()->motion;
  const MatrixXd& base = support()->base;
  for (const LinearSignal& signal : all_.model.outputs(i)) add_output(signal);
  add_hub_rows(row, {by.by_acceleration * base, by.by_v * motion + by.by_twist * base,
                     by.by_q * motion + by.by_turn * base});
  for (std::size_t k = 0; k < support()->forces.size(); ++k)
    C_.add(row, support()->forces[k], by.by_forces.col(static_cast<Index>(k)));
  Index column = first_standing_;
  for (const StandingInput& input : inputs_.standing) {
    if (input.support.outputs.size() > 0) D_.add(row, column, input.support.outputs);
    ++column;
  }
  for (std::size_t k = 0; k < all_.model.coordinates(i).size(); ++k) {
    const steady::SubsystemCoordinate& coordinate = all_.model.coordinates(i)[k];
    if (coordinate.node >= 0) continue;
    C_.add(std::ssize(result_.outputs), 0, motion.row(static_cast<Index>(k)));
    add_output({all_.model.full_name(i, coordinate.name), coordinate.unit()});
  }
}

/// Adds the motion of each hub along standing axes.
void MultiBladeAssembly::add_hub_outputs() {
  for (std::size_t h = 0; h < hubs_.size(); ++h)
    for (const int c : all_.model.free_components()) {
      const LinearSignal moved = name_hub_motion(h, c, all_.model);
      C_.add(std::ssize(result_.outputs), 0, hubs_[h].motion.row(c));
      add_output(moved);
      C_.add(std::ssize(result_.outputs), size_, hubs_[h].motion.row(c));
      add_output(steady::rate_of(moved));
    }
}

LinearSystem MultiBladeAssembly::make() {
  result_.frame = ModeFrame::fixed;
  const std::size_t families = frame_.families.size();
  for (std::size_t f = 0; f < families; ++f) amplitudes_.push_back(list_amplitudes(f));
  name_states();
  for (std::size_t f = 0; f < families; ++f) add_blade_inputs(f);
  add_standing_inputs();
  if (hub_size() > 0) add_hub_inputs();
  for (const Group& group : list_groups()) add_group(group);
  for (std::size_t f = 0; f < families; ++f) add_blade_outputs(f);
  if (support()) add_support_outputs();
  if (hub_size() > 0) add_hub_outputs();
  const Index inputs = std::ssize(result_.inputs), outputs = std::ssize(result_.outputs);
  result_.A = A_.matrix(2 * size_, 2 * size_);
  result_.B = B_.matrix(2 * size_, inputs);
  result_.C = C_.matrix(outputs, 2 * size_);
  result_.D = D_.matrix(outputs, inputs);
  const std::vector<std::string>& more = all_.model.other_sensors();
  result_.left_out.insert(result_.left_out.end(), more.begin(), more.end());
  result_.left_out_inputs = std::move(inputs_.left_out);
  steady::take_out_rates(list_forces(), result_);
  return std::move(result_);
}

}  // namespace

LinearSystem make_multi_blade_system(const Scenario& scenario, const Linearised& all) {
  return MultiBladeAssembly(scenario, all).make();
}

}  // namespace spoke::vibration
