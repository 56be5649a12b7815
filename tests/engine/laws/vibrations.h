#pragma once

// Small motions of models, as the linear model has them, and as runs have them.

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "engine/step/step_context.h"
#include "models/scenario.h"

namespace spoke::test {

/// A vibration about a steady motion by the linear model.
struct Vibration {
  std::string name;
  std::complex<double> rate;  ///< its eigenvalue [rad/s]
  /// Motion at a time [s], of which the real part counts: of the free coordinates of the hub, or of
  /// what a support stands on, then of
  /// those of all subsystems, as a run has them [m, rad].
  std::function<Eigen::VectorXcd(double t)> motion;

  /// Returns the velocities at t = 0, by a difference in time [m/s, rad/s].
  Eigen::VectorXd start_velocities() const;
};

/// Returns the vibrations of the lowest frequencies, at most `count`, all subsystems that are alike
/// moving alike; rigid motions are left out. The scenario starts at its equilibrium. Throws
/// InputError where there are no modes.
std::vector<Vibration> list_vibrations(const Scenario& scenario, std::size_t count);

/// Returns the speed of the hub in the steady motion of a scenario [rad/s].
double steady_speed(const Scenario& scenario);

/// A run whose coordinates may be displaced.
class Displaced {
 public:
  explicit Displaced(const Scenario& scenario);

  /// Returns the coordinates at the end of each of some steps from the start, where they and their
  /// velocities differ by these from the equilibrium.
  std::vector<Eigen::VectorXd> run(const Eigen::VectorXd& displacement,
                                   const Eigen::VectorXd& velocities, int steps);

 private:
  /// A coordinate and its velocity in the table of the simulation.
  struct Place {
    double* q;
    double* v;
  };
  void add_place(const CoordinateBlock& block, int at);
  void add_joint(const BodyData<Plane>& body);
  void add_joint(const BodyData<Space>& body);
  template <class World>
  void find_places(SystemContext<World>& context);
  Eigen::VectorXd take() const;

  Simulation simulation_;
  SavedState start_;
  std::vector<Place> places_;
  bool turns_in_space_;  ///< whether places 3 to 5 are a rotation since a step's start
  const StepData<Space>* flying_ = nullptr;  ///< likewise, of the fuselage there
};

}  // namespace spoke::test
