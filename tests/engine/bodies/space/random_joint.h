#pragma once

// Makes random joints of all kinds.

#include <random>
#include <vector>

#include "models/space/joint.h"

namespace spoke::space::testing {

/// The kinds of joints, by the letters of their primitives: R and P about and along random axes, r
/// and p the same driven, S and s spherical in the child's and the parent's frame; "" is rigid.
inline const std::vector<const char*> kJointKinds{"",    "R",   "P",   "S",   "s",  "RR", "PR",
                                                  "RRR", "RrR", "pRP", "PsP", "rS", "rp", "PPPS"};

/// Makes a joint of a kind, with a random offset; springs and dampers in all primitives that are
/// free.
Joint make_random_joint(const char* kind, std::mt19937& random);

}  // namespace spoke::space::testing
