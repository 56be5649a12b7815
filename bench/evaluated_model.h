#pragma once

// A model whose accelerations are evaluated alone, without steps.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "engine/step/step_context.h"
#include "graph/executor.h"

namespace spoke::bench {

/// A system whose accelerations can be evaluated: one pass of the step graph that only evaluates
/// (explicit, no integration), run by the serial executor, in either world.
template <class World>
class EvaluatedModel {
 public:
  EvaluatedModel(System<World> system, Formulation formulation, const Method& method);

  /// Integrates from rest to the time at which evaluate() evaluates.
  void integrate();
  /// Scales each coordinate and velocity by a random factor, the same ones at every call.
  void disturb();
  /// Takes the coordinates and velocities of another model of the same system, for evaluation.
  void take_state(const EvaluatedModel& other);

  void evaluate();
  /// Returns the accelerations of all deformations, with the padding's zeros.
  Eigen::VectorXd accelerations() const;

 private:
  SystemContext<World> context_;
  std::unique_ptr<graph::StepGraph> graph_;
  std::unique_ptr<graph::Executor> executor_;
};

template <class World>
using ModelPointer = std::shared_ptr<EvaluatedModel<World>>;

/// Makes the given formulations of one system, ready to evaluate at the same state: the one that it
/// reaches at 5 s of its motion, each coordinate then disturbed by up to a tenth.
template <class World>
std::vector<ModelPointer<World>> make_models(const System<World>& system,
                                             const std::vector<Formulation>& formulations);

}  // namespace spoke::bench
