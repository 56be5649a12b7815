#pragma once

// Common parts of bindings of results: arrays, and numbers as text.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "models/count_text.h"
#include "models/scenario.h"

namespace spoke::python {

/// Returns vectors as rows of an array.
template <class Number>
pybind11::array_t<Number> rows_of(const std::vector<Eigen::Matrix<Number, 3, 1>>& vectors) {
  pybind11::array_t<Number> rows(
      {static_cast<pybind11::ssize_t>(vectors.size()), pybind11::ssize_t{3}});
  Number* to = rows.mutable_data();
  for (const auto& vector : vectors)
    for (int c = 0; c < 3; ++c) *to++ = vector[c];
  return rows;
}

/// Returns the values of a function for each item as an array.
template <class Number, class Item, class Function>
pybind11::array_t<Number> array_of(const std::vector<Item>& items, Function&& function) {
  pybind11::array_t<Number> numbers(static_cast<pybind11::ssize_t>(items.size()));
  Number* to = numbers.mutable_data();
  for (const Item& item : items) *to++ = function(item);
  return numbers;
}

/// Returns "3 blades", "1 mode".
inline std::string counted_text(std::size_t count, const char* what) {
  return counted(static_cast<std::int64_t>(count), what);
}

inline std::string six_digits(double value) { return pybind11::str("{:.6g}").format(value); }

inline std::string title_of(const Scenario& scenario) {
  return scenario.title.empty() ? scenario.name : scenario.title;
}

}  // namespace spoke::python
