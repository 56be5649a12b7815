#pragma once

// Vectors of roots that are equal: any combination of them is a mode, too, and which one a solver
// finds is chance.

#include <functional>
#include <vector>

#include "engine/vibration/pencil.h"
#include "engine/vibration/root.h"

namespace spoke::vibration {

/// What a vector does, linear in it: vectors are told apart by the squared lengths of these.
using Features = std::vector<Eigen::VectorXcd>;

/// Combines the vectors of roots that are equal so that the first feature is as large as it can be
/// in the first vector, and so on; where a feature tells nothing apart, the next one decides.
/// `roots`: ascending, of the pencil, in coordinates of the model. `features_of`: of a vector, for
/// all of the same kinds. Vectors of roots that only meet, which are alike, stay.
void separate_equal_roots(const Pencil& pencil,
                          const std::function<Features(const Eigen::VectorXcd&)>& features_of,
                          std::vector<Root>& roots);

}  // namespace spoke::vibration
