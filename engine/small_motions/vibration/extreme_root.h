#pragma once

// The upper end of a spectrum: the roots of largest magnitude.

#include <complex>
#include <functional>

#include "engine/small_motions/vibration/pencil.h"

namespace spoke::vibration {

/// Measure of a root s [1/s]; grows with its magnitude.
using RootMeasure = std::function<double(std::complex<double>)>;

/// Returns the root of a pencil with the largest measure, the one with positive imaginary part of a
/// conjugate pair; 0 if there is none. An Arnoldi iteration on the first-order system goes on until
/// the measure stands to 1e-6: it finds the ends of a spectrum first.
std::complex<double> find_extreme_root(const Pencil& pencil, const RootMeasure& measure);

}  // namespace spoke::vibration
