// Binds Spoke's errors as Python exceptions with the fields of the C++ ones.

#include <pybind11/stl.h>

#include <exception>
#include <string>

#include "models/error.h"
#include "python/bindings/bindings.h"
#include "python/bindings/load_exception.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The exceptions. They live as long as the interpreter: they must not be destroyed after it.
struct Types {
  py::handle error, internal, input, divergence, load, state;
};
Types types;

/// Makes an exception `spoke.NAME`; `fields` are its attributes unless an instance has its own.
py::handle make_type(py::module_& module, const char* name, const char* doc,
                     const py::object& bases, const py::dict& fields = {}) {
  const std::string full = std::string("spoke.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), fields.ptr());
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

py::object none_if_empty(const std::string& text) {
  return text.empty() ? py::object(py::none()) : py::str(text);
}

py::object none_if_zero(int number) {
  return number == 0 ? py::object(py::none()) : py::int_(number);
}

/// Returns what a load in Python raised; None if it was another failure.
py::object cause_of(const LoadError& error) {
  try {
    std::rethrow_if_nested(error);
  } catch (const LoadException& cause) {
    return cause.raised();
  } catch (...) {  // of another kind: the sentence tells it
  }
  return py::none();
}

/// Raises an exception with the error's sentence.
void raise(py::handle type, const Error& error, const py::dict& fields = {}) {
  const py::object raised = type(error.what());
  for (const auto& [name, value] : fields) py::setattr(raised, name, value);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    const InputPlace& place = error.place();
    raise(types.input, error,
          py::dict("file"_a = none_if_empty(place.file), "line"_a = none_if_zero(place.line),
                   "column"_a = none_if_zero(place.column), "key"_a = none_if_empty(place.key)));
  } catch (const DivergenceError& error) {
    const Divergence& at = error.divergence();
    raise(types.divergence, error,
          py::dict("time"_a = at.time, "step"_a = at.step,
                   "subsystem"_a = none_if_empty(at.subsystem), "body"_a = none_if_empty(at.body),
                   "node"_a = none_if_empty(at.node), "quantity"_a = none_if_empty(at.quantity)));
  } catch (const LoadError& error) {
    raise(types.load, error, py::dict("__cause__"_a = cause_of(error)));
  } catch (const StateError& error) {
    raise(types.state, error);
  } catch (const Error& error) {
    raise(types.internal, error);
  } catch (const LoadException& error) {  // of a controller
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.raised().ptr())),
                    error.raised().ptr());
  }
}

py::dict nones(std::initializer_list<const char*> names) {
  py::dict fields;
  for (const char* name : names) fields[name] = py::none();
  return fields;
}

}  // namespace

void bind_errors(py::module_& module) {
  types.error = make_type(module, "Error", "What all errors of Spoke have in common: one sentence.",
                          py::reinterpret_borrow<py::object>(PyExc_Exception));
  const auto and_builtin = [](PyObject* builtin) {
    return py::make_tuple(types.error, py::handle(builtin));
  };
  types.internal = make_type(module, "InternalError", "A fault in Spoke.",
                             py::reinterpret_borrow<py::object>(types.error));
  types.input = make_type(
      module, "InputError",
      "A scenario, file or argument that cannot be used: the sentence names place, key, value, and "
      "what was expected.\n\n"
      "Attributes, None where not known:\n"
      "    file: as it was named.\n"
      "    line, column: from 1.\n"
      "    key: its path, \"blade.bodies\".",
      and_builtin(PyExc_ValueError), nones({"file", "line", "column", "key"}));
  types.divergence = make_type(
      module, "DivergenceError",
      "The simulation left the range of its model: the sentence names time, step, place and "
      "quantity, and what to try.\n\n"
      "Attributes, None where not known:\n"
      "    time: that the step was to reach [s].\n"
      "    step: from 1.\n"
      "    subsystem, body: \"blade 2\", \"body 3\".\n"
      "    node: of the step graph, \"blade 2 / body 3 / recovery\".\n"
      "    quantity: \"deflection v of node 4\".\n"
      "    result: the Result of the steps before, of Simulation.run().",
      and_builtin(PyExc_ArithmeticError),
      nones({"time", "step", "subsystem", "body", "node", "quantity", "result"}));
  types.load = make_type(
      module, "LoadError",
      "A load raised, or returned what the system cannot take. The simulation stands at the end of "
      "the step before, and can be stepped again.\n\n"
      "Attributes:\n"
      "    result: the Result of the steps before, of Simulation.run(), else None.\n"
      "    __cause__: what the load raised, with its traceback; None if it returned what it must "
      "not.",
      and_builtin(PyExc_RuntimeError), nones({"result"}));
  types.state = make_type(module, "StateError",
                          "A step failed, and what was asked for needs the state after it: restore "
                          "one before. Or another thread uses the simulation.",
                          and_builtin(PyExc_RuntimeError));
  py::register_local_exception_translator(&translate);
}

}  // namespace spoke::python
