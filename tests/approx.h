#pragma once

#include <doctest/doctest.h>

namespace spoke::testing {

/// Equal within about 1e-5 of the value itself. doctest's own Approx measures against 1 plus the
/// value, by which all times of microseconds are equal.
inline doctest::Approx approx(double value) { return doctest::Approx(value).scale(0.0); }

}  // namespace spoke::testing
