#pragma once

// Vectors of equal roots: any combination of them is a mode, too, and the solver returns an
// arbitrary one.

#include <functional>
#include <vector>

#include "engine/small_motions/vibration/pencil.h"
#include "engine/small_motions/vibration/root.h"

namespace spoke::vibration {

/// Linear functions of a vector: vectors are told apart by the squared lengths of these.
using Features = std::vector<Eigen::VectorXcd>;

/// Combines the vectors of equal roots so that the first feature is as large as possible in the
/// first vector, and so on; where a feature tells nothing apart, the next one decides. `roots`:
/// ascending, of the pencil, in coordinates of the model. `features_of`: returns the same kinds of
/// features for every vector. Vectors of roots that only meet, which are alike, stay.
void separate_equal_roots(const Pencil& pencil,
                          const std::function<Features(const Eigen::VectorXcd&)>& features_of,
                          std::vector<Root>& roots);

}  // namespace spoke::vibration
