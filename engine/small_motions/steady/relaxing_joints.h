#pragma once

// Small motions of models whose joints relax: linear models have no states of forces.

#include "models/scenario.h"

namespace spoke::steady {

/// Throws InputError, naming the joint, if a joint has a spring that relaxes.
void refuse_relaxation(const Scenario& scenario);

}  // namespace spoke::steady
