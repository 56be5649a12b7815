#pragma once

#include <utility>
#include <vector>

#include "bench/predict/prediction.h"

/// A prediction of a step of 10 us on an idle machine of 2 processors, of which nothing was
/// measured: 2 us are on the costliest path of one pass, 1 us on that of the 50 steps that auto
/// runs at once. No executor but serial.
spoke::predict::Prediction sample_prediction();

/// An executor's points: numbers of threads and times per step [s], with a band of a tenth.
/// `window` of all on more than one thread.
spoke::predict::Series series_of(spoke::ExecutorKind executor,
                                 const std::vector<std::pair<int, double>>& times, int window = 1);

/// Sets the measured values of a point: a time per step [s], without spread, and the speedup.
void measure_as(double step, double speedup, spoke::predict::Point& point);
