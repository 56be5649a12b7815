#pragma once

// Rotors in steady rotation on a support that stands: models that meet at the hubs. Each rotor is
// held in the place that the support gives it, and its mean wrench acts on the support.

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

/// A rotor of a supported model.
struct RotorParts {
  /// Makes the rotor, whose hub at azimuth zero has these axes in the inertial frame. Its hub is
  /// driven at constant speed.
  std::function<std::unique_ptr<SteadyModel>(const Eigen::Matrix3d& axes, DeadLoads loads)> make;
  std::string name;                     ///< of the rotor; may be empty where there is one
  std::string prefix;                   ///< of the names of its hub and axle
  std::vector<std::size_t> trees;       ///< numbers of its trees in the scenario
  std::vector<std::size_t> subsystems;  ///< numbers of its subsystems in the supported model
  int body = 0;                         ///< of the support that is its hub
  double speed = 0.0;                   ///< [rad/s]
  Eigen::MatrixXd ballast;              ///< mass matrix of that body, which is no mass
  bool averages = false;                ///< whether loads on it turn against it
  bool turns_freely = false;            ///< whether the angle about the axle is a coordinate
  bool has_torque = false;              ///< whether a torque that gives what is needed acts there
  double torque_slope = 0.0;            ///< of the drive's torque by the speed [N m s/rad]
  std::optional<spatial::DriveTrain> train{};  ///< between hub and drive, if there is one
};

/// What a supported model is made of.
struct SupportedParts {
  std::vector<RotorParts> rotors;  ///< one or more
  std::size_t trees = 0;           ///< number of the trees of all rotors in the scenario
  /// Makes the support at rest: one subsystem, with the hubs among its bodies. `wrenches`: by rotor
  /// on its hub at its origin, inertial axes.
  std::function<std::unique_ptr<SteadyModel>(const std::vector<HubVector>& wrenches)> support;
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity();  ///< axes of the base, inertial frame
};

/// Subsystems have the numbers of the scenario's trees, over all rotors; the support is the last.
class SupportedModel final : public SteadyModel {
 public:
  /// Takes the support undeformed, and puts the rotors on it.
  explicit SupportedModel(SupportedParts parts);

  std::size_t rotors() const { return parts_.rotors.size(); }
  SteadyModel& rotor(std::size_t r) const override { return *rotors_[r]; }
  SteadyModel& support() const { return *support_; }
  const RotorParts& parts(std::size_t r) const { return parts_.rotors[r]; }
  /// Returns the rotor that carries a subsystem. Precondition: that is not the support.
  std::size_t rotor_of(std::size_t subsystem) const { return places_[subsystem].rotor; }
  /// Returns the number of the support among the subsystems: it is the last.
  std::size_t support_index() const { return places_.size(); }

  /// Returns the axes of a hub at azimuth zero, and its place, in the frame of the base, where the
  /// support was evaluated last.
  NodePlace hub_place(std::size_t r) const;
  /// Puts a rotor on a hub with these axes, frame of the base. Returns the model before.
  std::unique_ptr<SteadyModel> move_rotor(std::size_t r, const Eigen::Matrix3d& axes);
  /// Lets wrenches of the rotors act on the support, each along the axes of its hub in force.
  /// Returns the model before.
  std::unique_ptr<SteadyModel> load_support(const std::vector<HubVector>& wrenches);
  /// Puts the rotors, and lets wrenches act, as in another model.
  void stand_like(const SupportedModel& other);
  /// Puts the rotors where they are at an azimuth of their hubs, with all loads that act there.
  void turn_rotors(double azimuth);
  /// Returns the mean over a turn of what a rotor in equilibrium, its own, exerts on its hub, along
  /// the axes that the hub has at azimuth zero, if it is turned by the small rotation vector
  /// `turn`, the other components of a twist being unused.
  HubVector mean_wrench(std::size_t r, const Equilibrium& equilibrium, const HubVector& turn,
                        DeadLoads loads) const;

  /// Returns what is before the name of a motion of rotors, of several: of those that move not much
  /// less than the one that moves most, "tail: ", "front + rear: ". `motions`: by rotor, as large
  /// as energies; those that are missing are none.
  std::string name_rotors(const std::vector<double>& motions) const;

  SupportedModel* on_support() override { return this; }
  bool stands(std::size_t subsystem) const override { return subsystem == support_index(); }
  std::size_t hub_of(std::size_t i) const override { return stands(i) ? rotors() : rotor_of(i); }
  std::size_t hubs() const override { return rotors(); }
  std::string prefix_of(std::size_t r) const override { return parts(r).prefix; }

  double speed_of(std::size_t i) const override { return stands(i) ? speed_ : of(i).speed(); }
  bool turns() const override;

  std::size_t subsystems() const override { return support_index() + 1; }
  const std::string& name_of(std::size_t i) const override { return of(i).name_of(in(i)); }
  std::string full_name(std::size_t i, const std::string& inner) const override {
    return of(i).full_name(in(i), inner);
  }
  std::vector<CarriedHub> carried_hubs(const std::vector<HubVector>& wrenches) const override;
  std::vector<SubsystemPart> members(std::size_t i) override;
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
  bool has_torque_drive() const override { return parts_.rotors.front().has_torque; }
  void set_share(double share) override;
  void hold_states(std::size_t i, bool holds) override { of(i).hold_states(in(i), holds); }
  void hold_states_at(std::size_t i, std::span<const double> states) override {
    of(i).hold_states_at(in(i), states);
  }
  std::vector<double> advance_states(std::size_t i, double elapsed) override {
    return of(i).advance_states(in(i), elapsed);
  }
  std::vector<ForceState> force_states(std::size_t i) const override {
    return of(i).force_states(in(i));
  }
  void move_hub(double turn, double rate, double acceleration) override {
    for (const auto& rotor : rotors_) rotor->move_hub(turn, rate, acceleration);
  }
  Eigen::VectorXd initial(std::size_t i) const override { return of(i).initial(in(i)); }
  void settle(std::size_t i, Eigen::VectorXd& q) override { of(i).settle(in(i), q); }
  void settle_at(std::size_t i, const Eigen::VectorXd& absolute) override {
    of(i).settle_at(in(i), absolute);
  }
  /// `hub`: of the hub that carries the subsystem, or of the base.
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
  HubVector hub_force(const HubOffset& hub) const override { return rotor(0).hub_force(hub); }
  Eigen::MatrixXd hub_mass() const override { return rotor(0).hub_mass(); }
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
  /// A subsystem of a rotor.
  struct Place {
    std::size_t rotor = 0, own = 0;  ///< `own`: its number there
  };

  SteadyModel& of(std::size_t i) const { return stands(i) ? *support_ : rotor(places_[i].rotor); }
  std::size_t in(std::size_t i) const { return stands(i) ? 0 : places_[i].own; }

  SupportedParts parts_;
  std::vector<Place> places_;  ///< by subsystem but the support
  std::vector<int> all_{0, 1, 2, 3, 4, 5};
  std::vector<std::string> other_sensors_;
  std::vector<std::unique_ptr<SteadyModel>> rotors_;
  std::unique_ptr<SteadyModel> support_;
  std::vector<Eigen::Matrix3d> axes_;  ///< of the hubs, inertial frame
  std::vector<HubVector> wrenches_;    ///< of the rotors on the support, inertial axes
};

/// The equilibria of the models of a supported one.
struct SupportedEquilibrium {
  std::vector<Equilibrium> rotors;
  Equilibrium support;
};
/// Takes the equilibrium of a supported model apart; wrenches are those of each model.
SupportedEquilibrium split(const Equilibrium& all, const SupportedModel& model);

/// As find_equilibrium(); of rotors on a support all by turns, until the axes of the hubs no longer
/// change.
Equilibrium find_machine_equilibrium(SteadyModel& model);
/// As continue_equilibrium().
std::optional<Equilibrium> continue_machine_equilibrium(const Equilibrium& at,
                                                        const SteadyModel& before,
                                                        SteadyModel& model);
/// As require_steady_hub(); of rotors on a support for the base and the axles.
void require_steady_machine(SteadyModel& model, const Equilibrium& equilibrium);

}  // namespace spoke::steady
