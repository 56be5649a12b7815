// Returns the equilibrium as coordinates of bodies.

#include "engine/small_motions/steady/steady_start.h"

#include <string>
#include <utility>

#include "engine/small_motions/steady/find_equilibrium.h"
#include "engine/small_motions/steady/supported_model.h"
#include "models/error.h"
#include "models/start.h"

namespace spoke::steady {

namespace {

/// Twists the shaft of a drive train by the moment of the rotor [N m]: a generator that no drive
/// holds is turned back, else the axle, the last coordinate, ahead.
void twist_shaft(const spatial::DriveTrain& train, double moment,
                 const std::vector<SubsystemCoordinate>& coordinates, Eigen::VectorXd& support) {
  const double twist = moment / train.stiffness;
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    if (coordinates[k].joint == spatial::kGeneratorName) {
      support[static_cast<Eigen::Index>(k)] -= train.gear_ratio * twist;
      return;
    }
  support[support.size() - 1] += twist;
}

std::vector<Eigen::VectorXd> solve_start(const Scenario& scenario) {
  const std::unique_ptr<SteadyModel> model =
      make_steady_model(scenario, {start_speed(scenario), Instant::start});
  const Equilibrium found = find_machine_equilibrium(*model);
  require_held(found);
  if (model->is_hub_free() || model->on_support()) require_steady_machine(*model, found);
  std::vector<Eigen::VectorXd> q;
  for (std::size_t i = 0; i < model->subsystems(); ++i) q.push_back(model->absolute(i, found.q[i]));
  // A rotor begins at azimuth zero, the last coordinate of its support.
  if (const SupportedModel* machine = model->on_support();
      machine && machine->parts().turns_freely) {
    Eigen::VectorXd& support = q.back();
    support.conservativeResize(support.size() + 1);
    support[support.size() - 1] = 0.0;
    if (machine->parts().train)
      twist_shaft(*machine->parts().train, -found.wrench[5], model->coordinates(q.size() - 1),
                  support);
  }
  return q;
}

}  // namespace

std::vector<Eigen::VectorXd> find_start(const Scenario& scenario) {
  try {
    return solve_start(scenario);
  } catch (const InputError& error) {
    throw InputError(error.what() + std::string(kStartUndeformed), error.place());
  } catch (const DivergenceError& error) {
    throw DivergenceError(error.what() + std::string(kStartUndeformed), error.divergence());
  }
}

}  // namespace spoke::steady
