#pragma once

// A rotor in steady rotation on a support that stands: two models that meet at the hub. The rotor
// is held in the place that the support gives it, and its mean wrench acts on the support.

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/small_motions/steady/find_equilibrium.h"
#include "engine/small_motions/steady/steady_model.h"
#include "models/spatial_model.h"

namespace spoke::steady {

/// Which part of vectors that are constant in the inertial frame acts on a rotor.
enum class DeadLoads {
  steady,  ///< what does not turn against the rotor, see make_steady_model()
  all,     ///< all, as it is at one azimuth
};

/// What a supported model is made of.
struct SupportedParts {
  /// Makes the rotor, whose hub at azimuth zero has these axes in the inertial frame. Its hub is
  /// driven at constant speed.
  std::function<std::unique_ptr<SteadyModel>(const Eigen::Matrix3d& axes, DeadLoads loads)> rotor;
  /// Makes the support at rest: one subsystem, whose last body has the place and the axes of the
  /// hub. `wrench`: on that body at its origin, inertial axes.
  std::function<std::unique_ptr<SteadyModel>(const HubVector& wrench)> support;
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity();  ///< axes of the base, inertial frame
  Eigen::MatrixXd ballast;    ///< mass matrix of the last body of the support, which is no mass
  bool averages = false;      ///< whether loads on the rotor turn against it
  bool turns_freely = false;  ///< whether the angle about the axle is a coordinate
  bool has_torque = false;    ///< whether a torque that gives what is needed acts there
  double torque_slope = 0.0;  ///< of the drive's torque by the speed [N m s/rad]
  std::optional<spatial::DriveTrain> train{};  ///< between hub and drive, if there is one
};

class SupportedModel final : public SteadyModel {
 public:
  /// Takes the support undeformed, and puts the rotor on it. `speed`: of the rotor.
  SupportedModel(SupportedParts parts, double speed);

  SteadyModel& rotor() const { return *rotor_; }
  SteadyModel& support() const { return *support_; }
  const SupportedParts& parts() const { return parts_; }
  /// Returns the number of the support among the subsystems: it is the last.
  std::size_t support_index() const { return rotor_->subsystems(); }

  /// Returns the axes of the hub at azimuth zero, and its place, in the frame of the base, where
  /// the support was evaluated last.
  NodePlace hub_place() const;
  /// Puts the rotor on a hub with these axes, frame of the base. Returns the model before.
  std::unique_ptr<SteadyModel> move_rotor(const Eigen::Matrix3d& axes);
  /// Lets a wrench of the rotor act on the support, along the axes of the hub in force. Returns the
  /// model before.
  std::unique_ptr<SteadyModel> load_support(const HubVector& wrench);
  /// Puts the rotor, and lets a wrench act, as in another model.
  void stand_like(const SupportedModel& other);
  /// Puts the rotor where it is at an azimuth of its hub, with all loads that act there.
  void turn_rotor(double azimuth);
  /// Returns the mean over a turn of what the rotor in equilibrium exerts on its hub, along the
  /// axes that the hub has at azimuth zero, if it is turned by the small rotation vector `turn`,
  /// the other components of a twist being unused.
  HubVector mean_wrench(const Equilibrium& equilibrium, const HubVector& turn,
                        DeadLoads loads) const;

  SupportedModel* on_support() override { return this; }
  bool stands(std::size_t subsystem) const override { return subsystem == support_index(); }

  std::size_t subsystems() const override { return support_index() + 1; }
  const std::string& name_of(std::size_t i) const override { return of(i).name_of(in(i)); }
  const std::vector<std::string>& body_names(std::size_t i) const override {
    return of(i).body_names(in(i));
  }
  const std::vector<SubsystemCoordinate>& coordinates(std::size_t i) const override {
    return of(i).coordinates(in(i));
  }
  std::vector<SolidDeformation> solids(std::size_t i) const override { return of(i).solids(in(i)); }
  double azimuth(std::size_t i) const override { return of(i).azimuth(in(i)); }
  Eigen::Matrix3d root_axes(std::size_t i, int body) const override {
    return of(i).root_axes(in(i), body);
  }
  bool is_spatial() const override { return true; }
  int twist_size() const override { return 6; }
  const std::vector<int>& free_components() const override { return all_; }
  bool is_hub_free() const override { return support_->is_hub_free(); }
  bool has_torque_drive() const override { return parts_.has_torque; }
  void set_share(double share) override;
  void hold_states(std::size_t i, bool holds) override { of(i).hold_states(in(i), holds); }
  void hold_states_at(std::size_t i, std::span<const double> states) override {
    of(i).hold_states_at(in(i), states);
  }
  std::vector<double> advance_states(std::size_t i, double elapsed) override {
    return of(i).advance_states(in(i), elapsed);
  }
  void move_hub(double turn, double rate, double acceleration) override {
    rotor_->move_hub(turn, rate, acceleration);
  }
  Eigen::VectorXd initial(std::size_t i) const override { return of(i).initial(in(i)); }
  void settle(std::size_t i, Eigen::VectorXd& q) override { of(i).settle(in(i), q); }
  void settle_at(std::size_t i, const Eigen::VectorXd& absolute) override {
    of(i).settle_at(in(i), absolute);
  }
  /// `hub`: of the rotor's hub, or of the base.
  void evaluate(std::size_t i, const SubsystemState& state, const HubOffset& hub,
                SubsystemResponse& response) override {
    of(i).evaluate(in(i), state, hub, response);
  }
  const Eigen::MatrixXd& stiffness(std::size_t i) override { return of(i).stiffness(in(i)); }
  Eigen::VectorXd accelerations(std::size_t i) override { return of(i).accelerations(in(i)); }
  SubsystemMatrices matrices(std::size_t i) override { return of(i).matrices(in(i)); }
  Eigen::VectorXd momenta(std::size_t i, const Eigen::VectorXd& v) override {
    return of(i).momenta(in(i), v);
  }
  Eigen::MatrixXd twists(std::size_t i, int body) override { return of(i).twists(in(i), body); }
  const std::vector<ClosureRow>& closure_rows(std::size_t i) const override {
    return of(i).closure_rows(in(i));
  }
  const std::string& standing_springs(std::size_t i) const override {
    return of(i).standing_springs(in(i));
  }
  std::string loop_words(std::size_t i, std::size_t loop) const override {
    return of(i).loop_words(in(i), loop);
  }
  Eigen::MatrixXd closures(std::size_t i) override { return of(i).closures(in(i)); }
  std::vector<LoopLoad> loop_loads(std::size_t i,
                                   const Eigen::VectorXd& multipliers) const override {
    return of(i).loop_loads(in(i), multipliers);
  }
  HubVector hub_force(const HubOffset& hub) const override { return rotor_->hub_force(hub); }
  Eigen::MatrixXd hub_mass() const override { return rotor_->hub_mass(); }
  std::vector<NodePlace> places(std::size_t i) override { return of(i).places(in(i)); }
  TipMotion tip(std::size_t i) override { return of(i).tip(in(i)); }
  std::optional<SubsystemAir> air(std::size_t i) const override { return of(i).air(in(i)); }
  std::vector<RootLoad> root_loads(std::size_t i) const override { return of(i).root_loads(in(i)); }
  std::vector<double> bending(std::size_t i) const override { return of(i).bending(in(i)); }
  Eigen::VectorXd absolute(std::size_t i, const Eigen::VectorXd& q) const override {
    return of(i).absolute(in(i), q);
  }
  const std::vector<LinearSignal>& outputs(std::size_t i) const override {
    return of(i).outputs(in(i));
  }
  const std::vector<std::string>& other_sensors() const override { return other_sensors_; }
  Eigen::MatrixXd turn_outputs(std::size_t i, double angle) const override {
    return of(i).turn_outputs(in(i), angle);
  }
  Eigen::VectorXd measure(std::size_t i) override { return of(i).measure(in(i)); }

 private:
  SteadyModel& of(std::size_t i) const { return stands(i) ? *support_ : *rotor_; }
  std::size_t in(std::size_t i) const { return stands(i) ? 0 : i; }

  SupportedParts parts_;
  std::vector<int> all_{0, 1, 2, 3, 4, 5};
  std::vector<std::string> other_sensors_;
  std::unique_ptr<SteadyModel> rotor_, support_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< of the hub, inertial frame
  HubVector wrench_ = HubVector::Zero(6);  ///< of the rotor on the support, inertial axes
};

/// The equilibria of the two models of a supported one.
struct SupportedEquilibrium {
  Equilibrium rotor, support;
};
/// Takes the equilibrium of a supported model apart; wrenches are those of each model.
SupportedEquilibrium split(const Equilibrium& all, const SupportedModel& model);

/// As find_equilibrium(); of a rotor on a support both by turns, until the axes of the hub no
/// longer change.
Equilibrium find_machine_equilibrium(SteadyModel& model);
/// As continue_equilibrium().
std::optional<Equilibrium> continue_machine_equilibrium(const Equilibrium& at,
                                                        const SteadyModel& before,
                                                        SteadyModel& model);
/// As require_steady_hub(); of a rotor on a support for the base and the axle.
void require_steady_machine(SteadyModel& model, const Equilibrium& equilibrium);

}  // namespace spoke::steady
