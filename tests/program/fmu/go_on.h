#pragma once

// Steps of an instance of an FMU, of either version, and its outputs.

#include <doctest/doctest.h>

#include <vector>

#include "tests/program/fmu/importer.h"

namespace spoke::test {

/// Makes `count` steps from a point on, and returns all outputs behind each.
template <class Instance>
std::vector<std::vector<double>> go_on(Instance& instance, double from, double step, int count) {
  std::vector<std::vector<double>> rows;
  for (int k = 0; k < count; ++k) {
    CHECK(instance.step(from + k * step, step) == kOk);
    rows.push_back(instance.outputs());
  }
  return rows;
}

}  // namespace spoke::test
