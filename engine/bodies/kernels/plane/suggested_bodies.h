#pragma once

// Advice where bodies bend too far.

namespace spoke::plane {

/// Returns the bodies into which a blade of `bodies` bodies is to be cut for a deflection of
/// `ratio` of the length of a body to come down to `limit`. Under a given curvature the ratio goes
/// with the length of the bodies, and a little slower at the root, where it is largest: a uniform
/// transverse force is assumed.
int suggest_bodies(int bodies, double ratio, double limit);

}  // namespace spoke::plane
