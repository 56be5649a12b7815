#pragma once

// Logarithm, exponential and normal quantile by sums, products and quotients alone, so that the
// points of a design have the same bits on every machine. They are compiled without contraction of
// operations.

namespace spoke::study {

/// Returns the natural logarithm of x > 0, to two units in the last place.
double portable_log(double x);

/// Returns e^x, to two units in the last place; 0 and infinity beyond the range of doubles.
double portable_exp(double x);

/// Returns base^exponent: by products where the exponent is a whole number up to 64, otherwise by
/// portable_exp(). Not a number where the base is negative and the exponent not whole.
double portable_power(double base, double exponent);

/// Returns the number that a standard normal variable stays below with probability p, 0 < p < 1: M.
/// J. Wichura, "Algorithm AS 241: the percentage points of the normal distribution", Appl. Statist.
/// 37 (1988) 477-484, to 16 digits.
double normal_quantile(double p);

}  // namespace spoke::study
