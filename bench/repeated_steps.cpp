#include "bench/repeated_steps.h"

#include <utility>

namespace spoke::bench {

RepeatedSteps::RepeatedSteps(const Scenario& scenario, const SimulationOptions& options,
                             double begin, int steps)
    : simulation_(scenario, options), steps_(steps) {
  simulation_.run_until(begin);
  start_ = simulation_.save();
  const int rounds = options.executor == ExecutorKind::automatic ? 20 : 1;
  for (int k = 0; k < rounds; ++k) {
    go_back();
    run();
  }
  evaluations_ = static_cast<double>(simulation_.evaluations() - start_.evaluations) / steps;
  hash_ = simulation_.state_hash();
}

void RepeatedSteps::run() {
  simulation_.run_until(static_cast<double>(start_.steps + steps_) * simulation_.step_size());
}

Alternative RepeatedSteps::alternative(std::string name,
                                       const std::shared_ptr<RepeatedSteps>& steps, int reference) {
  return {std::move(name), [steps] { steps->run(); }, [steps] { steps->go_back(); },
          1.0 / steps->steps_, reference};
}

}  // namespace spoke::bench
