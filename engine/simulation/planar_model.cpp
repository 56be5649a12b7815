// A rotor in the plane, as a simulation sees it.

#include "engine/simulation/planar_model.h"

#include <optional>
#include <utility>

#include "engine/kernels/hub_motion.h"
#include "engine/kernels/load_terms.h"
#include "engine/kernels/marker_motion.h"
#include "engine/simulation/planar_views.h"
#include "engine/step/model_memory.h"
#include "engine/step/put_bodies.h"
#include "engine/step/share_subsystems.h"
#include "engine/table/state_values.h"
#include "models/error.h"

namespace spoke {
namespace {

class PlanarModel final : public SimulatedModel {
 public:
  PlanarModel(const Scenario& scenario, Formulation formulation, const Integrator& integrator,
              const Loads& loads)
      : scenario_(scenario), loads_(ask_loads(loads)) {
    if (scenario.limits.deflection > 0.0) context_.linear_range = scenario.limits.deflection;
    context_.system = make_system(scenario.rotor);
    context_.formulation = formulation;
    context_.integrator = integrator;
    context_.loads_tie_blades = ties_blades(loads_);
    require_memory(context_.system, formulation);
    keeps_momentum_ = loads.empty() && keeps_momentum(scenario);
  }

  StepContext& context() override { return context_; }
  SystemContext<Plane>* plane() override { return &context_; }

  double ring_bytes() const override {
    return spoke::ring_bytes(
        context_.system,
        count_readings(with_momentum(scenario_, keeps_momentum_), scenario_.rotor.blades.size()));
  }
  void allocate(int records) override {
    spoke::allocate(context_, records);
    place_loads(loads_, context_.data);
    std::vector<SensorColumn> asked =
        place_sensors(with_momentum(scenario_, keeps_momentum_), scenario_.rotor, context_.data);
    std::vector<SensorColumn> momentum = take_momentum(scenario_, keeps_momentum_, asked);
    sensors_.emplace(context_.system, std::move(asked), std::move(momentum));
  }

  void share_out(Exchange& exchange) override { spoke::share_out(exchange, context_); }
  std::vector<double> weights() const override { return weights_of(context_.data); }

  void put_bodies(const std::vector<Eigen::VectorXd>& q) override {
    spoke::put_bodies(q, context_);
  }

  ModelExtent extent() const override {
    const System<Plane>& system = context_.system;
    ModelExtent extent{static_cast<int>(system.subsystems.size()), system.body_count(),
                       system.deformation_count()};
    for (int c = 0; c < kTwist; ++c) extent.coordinates += !is_prescribed(system.hub, c);
    return extent;
  }
  double memory_bytes() const override {
    return estimate_model_memory(context_.system, context_.formulation) +
           static_cast<double>(count_mass_bytes(context_.data));
  }
  std::size_t count_state() override { return count_state_values(context_.data); }
  std::uint64_t hash() const override { return hash_state(context_.data); }
  bool has_body(std::int64_t blade, std::int64_t body) const override {
    const auto& blades = context_.system.subsystems;
    return blade >= 0 && blade < std::ssize(blades) && body >= 0 &&
           body < std::ssize(blades[static_cast<std::size_t>(blade)].bodies);
  }
  Drive& drive() override { return context_.system.hub.drive; }
  void begin_drive(const Drive& drive) override {
    context_.system.hub.drive = drive;
    put_hub_at_start(context_);
  }
  std::shared_ptr<const Load>& replaceable_load(int index,
                                                const std::shared_ptr<const Load>& other) override {
    LoadData<Plane>& load = find_load(index, context_.data);
    require_same_markers(other, load);
    return load.load;
  }

  void require_place(const Marker& marker) const override {
    place_marker("the marker", marker, context_.data);
  }
  MarkerState marker(const Marker& marker, double t) const override {
    return calc_marker_state(context_, marker, t);
  }
  Wrench joint_reaction(int blade, int joint) const override {
    return calc_joint_reaction(context_.data, blade, joint);
  }
  Wrench hub_reaction() const override { return calc_hub_reaction(context_.data); }
  Wrench section_force(const Marker& marker) const override {
    return calc_section_force(scenario_.rotor, context_, marker);
  }

  const std::vector<std::string>& sensor_names() const override { return sensors_->names(); }
  const std::vector<std::string>& sensor_units() const override { return sensors_->units(); }
  double start_sensors() override {
    sensors_->start(context_.system, context_.data);
    return sensors_->initial_energy();
  }
  double energy_resolution() const override { return calc_energy_resolution(scenario_); }
  void sample(std::int64_t step, double t) override {
    Sensors::sample(context_.system, step, t, context_.data);
  }
  const std::vector<double>& measure(const WorkDone& work, std::int64_t step) override {
    return sensors_->measure(context_.system, work, step, context_.data);
  }
  const EnergyBalance& balance() const override { return sensors_->balance(); }
  const MomentumBalance* momentum() const override { return sensors_->momentum(); }
  const StepRecord& record(std::int64_t step) const override {
    return of_step(context_.data.records, step).step;
  }

  void calc_shape(int, double, TreeShape&) override {
    throw InputError("the shape of a tree: the model is in the plane, expected one in space");
  }
  HubPose hub_pose() const override {
    const double* q = context_.data.hub_coordinates.q;
    return {{q[0], q[1], 0.0}, in_space(Rotation::from_angle(q[kRotation]))};
  }

  MarkerState hub_frame(double) const override {
    const CoordinateBlock& hub = context_.data.hub_coordinates;
    MarkerState frame;
    frame.velocity = {hub.v[0], hub.v[1], 0.0};
    frame.angular_velocity = {0.0, 0.0, hub.v[kRotation]};
    frame.acceleration = {hub.a[0], hub.a[1], 0.0};
    frame.angular_acceleration = {0.0, 0.0, hub.a[kRotation]};
    return frame;
  }

  DivergenceError diagnose(const FailedStep& failed) const override {
    return spoke::diagnose(scenario_, context_, failed);
  }
  std::string describe_failed_load(const std::string& at) const override {
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= scenario_.rotor.blades.size(); ++i)
      names.push_back("blade " + std::to_string(i));
    return spoke::describe_failed_load(context_.data, names, at);
  }

 private:
  const Scenario& scenario_;
  SystemContext<Plane> context_;
  std::vector<AskedLoad> loads_;
  bool keeps_momentum_ = false;     ///< free, and nothing acts on it
  std::optional<Sensors> sensors_;  // once there is a table
};

}  // namespace

std::unique_ptr<SimulatedModel> make_planar_model(const Scenario& scenario, Formulation formulation,
                                                  const Integrator& integrator,
                                                  const Loads& loads) {
  return std::make_unique<PlanarModel>(scenario, formulation, integrator, loads);
}

}  // namespace spoke
