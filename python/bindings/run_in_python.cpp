// Describes what Python raised.

#include "python/bindings/run_in_python.h"

namespace spoke::python {

namespace py = pybind11;

std::string describe_raised(const py::error_already_set& error) {
  std::string text = py::str(error.type().attr("__name__")).cast<std::string>() + ": " +
                     py::str(error.value()).cast<std::string>();
  py::object trace = error.trace() ? py::object(error.trace()) : py::object(py::none());
  if (trace.is_none()) return text;
  while (!trace.attr("tb_next").is_none()) trace = trace.attr("tb_next");
  const py::object code = trace.attr("tb_frame").attr("f_code");
  return text + " (" + py::str(code.attr("co_filename")).cast<std::string>() + ", line " +
         py::str(trace.attr("tb_lineno")).cast<std::string>() + ')';
}

py::object with_traceback(const py::error_already_set& error) {
  py::object raised = error.value();
  if (error.trace()) PyException_SetTraceback(raised.ptr(), error.trace().ptr());
  return raised;
}

}  // namespace spoke::python
