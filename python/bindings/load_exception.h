#pragma once

// What a load or a controller in Python raises, on its way through the engine as a C++ exception.

#include <pybind11/pybind11.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace spoke::python {

/// Shares a Python object that threads without the interpreter lock may drop.
inline std::shared_ptr<const pybind11::object> share(pybind11::object object) {
  return {new pybind11::object(std::move(object)), [](const pybind11::object* held) {
            const pybind11::gil_scoped_acquire lock;
            delete held;
          }};
}

/// An exception of the program's Python function, and its sentence, which needs no interpreter
/// lock. The engine nests that of a load in its LoadError; that of a controller leaves it as it is.
class LoadException : public std::runtime_error {
 public:
  /// Precondition: the interpreter lock is held.
  LoadException(const std::string& sentence, pybind11::object raised)
      : std::runtime_error(sentence), raised_(share(std::move(raised))) {}
  /// Returns it. Precondition: the interpreter lock is held.
  const pybind11::object& raised() const { return *raised_; }

 private:
  std::shared_ptr<const pybind11::object> raised_;
};

}  // namespace spoke::python
