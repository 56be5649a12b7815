#pragma once

// Calls of Python functions from threads of the engine.

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

#include "python/bindings/load_exception.h"

namespace spoke::python {

/// Returns "ValueError: message (file.py, line 7)", with the place where it was raised.
std::string describe_raised(const pybind11::error_already_set& error);
/// Returns the exception, which pybind11 keeps apart from its traceback.
pybind11::object with_traceback(const pybind11::error_already_set& error);

/// Calls `evaluate` with the interpreter lock; a Python exception leaves as a LoadException, since
/// it must not be touched without the lock.
template <class Evaluate>
void run_in_python(Evaluate&& evaluate) {
  const pybind11::gil_scoped_acquire lock;
  try {
    evaluate();
  } catch (pybind11::error_already_set& error) {
    const LoadException exception(describe_raised(error), with_traceback(error));
    // For Recording::run(). From here on, what runs in Python is interrupted.
    if (error.matches(PyExc_KeyboardInterrupt)) PyErr_SetInterrupt();
    throw exception;
  } catch (const pybind11::builtin_exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace spoke::python
