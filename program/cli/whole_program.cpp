// What the program `spoke`, linked with archives, has in place of the parts of the engine that most
// runs do without: it goes on as `spoke-whole`, which has them.

#include <filesystem>

#include "engine/small_motions/steady/steady_start.h"
#include "engine/small_motions/vibration/frequency_limits.h"
#include "engine/support/dense.h"
#include "models/solid/mesh_check.h"
#include "models/solid/solid.h"
#include "models/solid/vibration.h"
#include "program/cli/commands.h"
#include "program/ranks/launch.h"

namespace spoke {

// Readers call these first of all, where a model has a solid.
namespace solid {

SolidGeometry make_geometry(const spatial::SolidBody&) { throw cli::OtherProgramNeeded(); }
bool has_locking_elements(const spatial::SolidMesh&) { throw cli::OtherProgramNeeded(); }
std::shared_ptr<const space::SolidConstants> make_constants(const spatial::SolidBody&,
                                                            const SolidGeometry&, const LoadedSets&,
                                                            const Control&, CacheUse*) {
  throw cli::OtherProgramNeeded();
}

// Damping by modes.
VibrationModes find_modes(const Sparse&, const Inverse&, const Eigen::MatrixXd&, const ModeChoice&,
                          const PartDone&) {
  throw cli::OtherProgramNeeded();
}

}  // namespace solid

// Closed loops.
RightSingular find_right_singular(const Eigen::MatrixXd&) { throw cli::OtherProgramNeeded(); }

namespace steady {
std::vector<Eigen::VectorXd> find_start(const Scenario&) { throw cli::OtherProgramNeeded(); }
}  // namespace steady

// What makes rk4 diverge.
namespace vibration {
Rk4Limit find_rk4_limit(const Scenario&) { throw cli::OtherProgramNeeded(); }
}  // namespace vibration

namespace cli {

// In good time, so that no function above is called once a run has begun.
void require_enough(const Scenario& scenario) {
  const Damping& damping = scenario.space ? scenario.space->damping : scenario.rotor.damping;
  const bool may_ask_for_limit =
      scenario.space && scenario.integration.method == IntegrationMethod::rk4;
  if (scenario.initial.state == InitialState::equilibrium || has_loops(scenario) ||
      !damping.modes.ratios.empty() || may_ask_for_limit)
    throw OtherProgramNeeded();
}

void require_enough(const Arguments& arguments) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::file_status status = fs::status(arguments.scenario, none);
  const bool can_be_read_again =
      !fs::exists(status) || fs::is_directory(status) || fs::is_regular_file(status);
  if (!can_be_read_again || ranks::is_launched()) throw OtherProgramNeeded();
}

}  // namespace cli
}  // namespace spoke
