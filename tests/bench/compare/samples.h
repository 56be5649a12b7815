#pragma once

#include <vector>

#include "bench/compare/comparison.h"

inline constexpr auto kSerial = spoke::ExecutorKind::serial;
inline constexpr auto kFlow = spoke::ExecutorKind::flow_graph;

/// A measurement of `structured` with the times per step and as many hashes 1, 2, ...
spoke::compare::Measurement measurement_of(spoke::ExecutorKind executor, int threads,
                                           const std::vector<double>& step_times);

/// A comparison of one formulation on an idle machine of 2 processors, a quarter of the work on the
/// costliest path, evaluated.
spoke::compare::Comparison comparison_of(std::vector<spoke::compare::Measurement> measurements);
