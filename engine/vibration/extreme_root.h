#pragma once

// The other end of a spectrum: the roots of largest magnitude.

#include <complex>
#include <functional>

#include "engine/vibration/pencil.h"

namespace spoke::vibration {

/// How much a root s [1/s] counts; grows with its magnitude.
using RootMeasure = std::function<double(std::complex<double>)>;

/// The root of a pencil that counts most, of a pair of conjugate ones that with the positive
/// imaginary part; 0 if there is none. By an Arnoldi iteration on the first-order system, until the
/// measure stands to 1e-6: ends of a spectrum are what it finds first.
std::complex<double> find_extreme_root(const Pencil& pencil, const RootMeasure& measure);

}  // namespace spoke::vibration
