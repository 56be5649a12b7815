// Spoke's errors as Python exceptions.

#include "models/error.h"
#include "python/bindings/bindings.h"

namespace spoke::python {
namespace py = pybind11;

void bind_errors(py::module_& module) {
  // The one that is registered last is asked first: bases before what derives from them.
  static const py::exception<Error> error(module, "Error");
  const auto derive = [&](PyObject* builtin) { return py::make_tuple(error, py::handle(builtin)); };
  py::register_exception<Error>(module, "InternalError", error);
  py::register_exception<InputError>(module, "InputError", derive(PyExc_ValueError));
  py::register_exception<DivergenceError>(module, "DivergenceError", derive(PyExc_ArithmeticError));
  py::register_exception<LoadError>(module, "LoadError", derive(PyExc_RuntimeError));
  py::register_exception<StateError>(module, "StateError", derive(PyExc_RuntimeError));
  error.attr("__doc__") = "What all errors of Spoke have in common: one sentence.";
  module.attr("InternalError").attr("__doc__") = "A fault in Spoke.";
  module.attr("InputError").attr("__doc__") =
      "A scenario, file or argument that cannot be used: the sentence names file, line and column "
      "where there are some, the key, the value, and what was expected.";
  module.attr("DivergenceError").attr("__doc__") =
      "The simulation left the range of its model: the sentence names time, step, subsystem, body, "
      "node of the step graph and quantity, and what to try.";
  module.attr("LoadError").attr("__doc__") =
      "A load raised, or returned what the system cannot take. The simulation stands at the end of "
      "the step before, and can be stepped again.";
  module.attr("StateError").attr("__doc__") =
      "A step failed, and what was asked for needs the state after it: restore one before.";
}

}  // namespace spoke::python
