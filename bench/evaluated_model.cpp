// Sets a random state and runs passes that only evaluate.

#include "bench/evaluated_model.h"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"

namespace spoke::bench {
namespace {

constexpr double kStateTime = 5.0;  // s

}  // namespace

template <class World>
EvaluatedModel<World>::EvaluatedModel(System<World> system, Formulation formulation,
                                      const Method& method) {
  context_.system = std::move(system);
  context_.formulation = formulation;
  context_.integrator.method = method;
  allocate(context_);
  graph_ = std::make_unique<graph::StepGraph>(build_step_graph(context_));
  executor_ = graph::make_executor(*graph_, graph::ExecutorKind::serial);
}

template <class World>
void EvaluatedModel<World>::integrate() {
  constexpr int kSteps = 500;
  TimeStepper stepper(context_, *graph_);
  const bool fine = stepper.start() == StepOutcome::done &&
                    stepper.advance(kSteps, *executor_) == StepOutcome::done;
  if (!fine) throw std::runtime_error("the state to evaluate at cannot be reached");
}

template <class World>
void EvaluatedModel<World>::disturb() {
  std::mt19937 random(20170941);
  const auto scale = [&](double* values, int size) {
    for (int k = 0; k < size; ++k) values[k] *= 0.9 + 0.2 * random() / double{std::mt19937::max()};
  };
  for (SubsystemData<World>& subsystem : context_.data.subsystems)
    for (BodyData<World>& body : subsystem.bodies) {
      scale(body.coordinates.q, body.coordinates.size);
      scale(body.coordinates.v, body.coordinates.size);
    }
}

template <class World>
void EvaluatedModel<World>::take_state(const EvaluatedModel& other) {
  const auto copy = [](const CoordinateBlock& from, CoordinateBlock& to) {
    std::copy_n(from.q, from.size, to.q);
    std::copy_n(from.v, from.size, to.v);
  };
  StepData<World>& data = context_.data;
  const StepData<World>& source = other.context_.data;
  copy(source.hub_coordinates, data.hub_coordinates);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < data.subsystems[i].bodies.size(); ++j)
      copy(source.subsystems[i].bodies[j].coordinates, data.subsystems[i].bodies[j].coordinates);
}

template <class World>
void EvaluatedModel<World>::evaluate() {
  for (StepProgress& progress : context_.data.progress) {
    progress = StepProgress{};
    progress.control.time = kStateTime;
  }
  executor_->run();
}

template <class World>
Eigen::VectorXd EvaluatedModel<World>::accelerations() const {
  std::vector<double> all;
  for (const SubsystemData<World>& subsystem : context_.data.subsystems)
    for (const BodyData<World>& body : subsystem.bodies)
      all.insert(all.end(), body.coordinates.a, body.coordinates.a + body.coordinates.size);
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

template <class World>
std::vector<ModelPointer<World>> make_models(const System<World>& system,
                                             const std::vector<Formulation>& formulations) {
  EvaluatedModel<World> source(system, Formulation::structured, make_generalized_alpha(0.8, 0.01));
  source.integrate();
  source.disturb();
  std::vector<ModelPointer<World>> models;
  for (const Formulation formulation : formulations) {
    // rk4's table has no extras of an implicit method; its step is not used.
    models.push_back(std::make_shared<EvaluatedModel<World>>(system, formulation, Rk4{1e-5}));
    models.back()->take_state(source);
  }
  return models;
}

template class EvaluatedModel<Plane>;
template class EvaluatedModel<Space>;
template std::vector<ModelPointer<Plane>> make_models(const System<Plane>&,
                                                      const std::vector<Formulation>&);
template std::vector<ModelPointer<Space>> make_models(const System<Space>&,
                                                      const std::vector<Formulation>&);

}  // namespace spoke::bench
