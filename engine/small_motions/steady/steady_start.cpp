// Returns the equilibrium as coordinates of bodies.

#include "engine/small_motions/steady/steady_start.h"

#include <algorithm>
#include <map>
#include <string>

#include "engine/small_motions/steady/find_equilibrium.h"
#include "engine/small_motions/steady/supported_model.h"
#include "models/error.h"
#include "models/start.h"

namespace spoke::steady {

namespace {

/// Adds the axle of a rotor that turns freely, which begins at azimuth zero, to the coordinates of
/// its support: behind those of the bodies before its hub. `moment`: of the rotor about its axle,
/// which twists the shaft of a drive train: a generator that no drive holds is turned back, else
/// the axle ahead [N m].
void add_axle(const RotorParts& rotor, double moment,
              const std::vector<SubsystemCoordinate>& coordinates, Eigen::Index added,
              Eigen::VectorXd& support) {
  const auto is_before = [&](const SubsystemCoordinate& at) { return at.body < rotor.body; };
  const Eigen::Index axle =
      std::count_if(coordinates.begin(), coordinates.end(), is_before) + added;
  const Eigen::VectorXd behind = support.tail(support.size() - axle);
  support.conservativeResize(support.size() + 1);
  support[axle] = 0.0;
  support.tail(behind.size()) = behind;
  if (!rotor.train) return;
  const double twist = moment / rotor.train->stiffness;
  const std::string name = rotor.prefix + std::string(spatial::kGeneratorName);
  const auto generator = std::find_if(
      coordinates.begin(), coordinates.end(),
      [&name](const SubsystemCoordinate& coordinate) { return coordinate.joint == name; });
  if (generator == coordinates.end())
    support[axle] += twist;
  else
    support[generator - coordinates.begin() + added] -= rotor.train->gear_ratio * twist;
}

/// Adds the axles of all rotors that turn freely, in the order of their hubs.
void add_axles(const Equilibrium& found, const SupportedModel& machine, Eigen::VectorXd& support) {
  Eigen::Index added = 0;
  for (std::size_t r = 0; r < machine.rotors(); ++r)
    if (machine.parts(r).turns_freely)
      add_axle(machine.parts(r), -found.wrenches[r][5],
               machine.coordinates(machine.support_index()), added++, support);
}

std::vector<Eigen::VectorXd> solve_start(const Scenario& scenario) {
  const std::vector<double> speeds = start_speeds(scenario);
  const std::unique_ptr<SteadyModel> model =
      make_steady_model(scenario, {.speed = speeds.front(),
                                   .instant = Instant::start,
                                   .further_speeds = {speeds.begin() + 1, speeds.end()}});
  const Equilibrium found = find_machine_equilibrium(*model);
  require_held(found);
  if (model->is_hub_free() || model->on_support()) require_steady_machine(*model, found);
  std::map<std::size_t, Eigen::VectorXd> by_number;
  for (std::size_t i = 0; i < model->subsystems(); ++i)
    for (const SubsystemPart& part : model->members(i))
      by_number[part.number] = part.model->absolute(part.subsystem, part.part_of(found.q[i]));
  std::vector<Eigen::VectorXd> q;
  for (auto& [number, own] : by_number) q.push_back(std::move(own));
  if (const SupportedModel* machine = model->on_support()) add_axles(found, *machine, q.back());
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
