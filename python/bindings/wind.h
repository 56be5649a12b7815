#pragma once

// Winds that are Python functions.

#include <pybind11/pybind11.h>

#include <memory>

#include "models/wind.h"

namespace spoke::python {

/// Makes a wind of function(place, t) -> velocity. It takes the interpreter lock for each call.
/// What the function raises, or returns in place of three numbers, is shown by sys.unraisablehook;
/// the velocity is then not a number. The interpreter lock must be held.
std::shared_ptr<const WindField> make_python_wind(pybind11::function function);

}  // namespace spoke::python
