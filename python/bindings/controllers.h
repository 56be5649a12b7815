#pragma once

// Controllers that are Python objects.

#include <pybind11/pybind11.h>

#include <memory>

#include "engine/controller.h"

namespace spoke::python {

/// Makes a controller of an object with the method control(record, commands), and where it has
/// them begin(sensors), save() and restore(saved); or of a function(record, commands).
/// Precondition: it is one of these.
std::shared_ptr<Controller> make_python_controller(pybind11::object object);

}  // namespace spoke::python
