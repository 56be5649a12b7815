#pragma once

// Measures one kind of model in several sizes: costs of each, and their growth.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/compare/interleaved.h"
#include "bench/repeated_steps.h"
#include "bench/report.h"

namespace spoke::bench {

/// Sizes of one kind, ascending, and how long each takes.
struct Growth {
  std::string title, items;
  std::vector<int> sizes{};
  std::vector<Alternative> alternatives{};  ///< by size
  std::vector<double> memory{};             ///< by size [bytes]; empty: not asked

  void add(int size, Alternative alternative);
  /// Adds steps of a simulation, or its evaluations, with the memory that it took to make it.
  enum class Unit { step, evaluation };
  void add(int size, const Scenario& scenario, int steps, Unit unit);
  /// Adds the start of a simulation.
  void add_start(int size, const Scenario& scenario);
  /// Adds the cloning of a simulation.
  void add_clone(int size, const Scenario& scenario);
};

/// Exponents from each size to the next, 1 where twice as much costs twice as much.
struct Exponents {
  std::vector<double> steps;
  /// Cost of an item of the largest size by that of one of the smallest.
  double per_item = 1.0;
};

/// Returns the memory of this process that lies in pages [bytes]; those that are free, given back.
double resident_memory();

/// Measures, prints and returns the exponents; all sizes in turns.
Exponents measure_growth(const Growth& growth, const Effort& effort, Report& report);

}  // namespace spoke::bench
