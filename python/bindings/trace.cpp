// Binds traces as structured arrays of their own slices.

#include "program/trace/trace.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <vector>

#include "models/error.h"
#include "program/trace/chrome_trace.h"
#include "program/trace/page_data.h"
#include "program/trace/statistics.h"
#include "program/viewer/viewer_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/used_simulation.h"

namespace spoke::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using trace::Trace;

std::unique_ptr<Trace> make_trace(UsedSimulation& simulation, std::int64_t steps,
                                  double buffer_bytes) {
  const Use use(simulation);
  const py::gil_scoped_release unlocked;
  TraceOptions options;
  options.buffer_bytes = static_cast<std::size_t>(buffer_bytes);
  auto made =
      std::make_unique<Trace>(trace::describe(simulation, simulation.trace(steps, {}, options)));
  if (made->steps.steps.empty())
    throw InputError("no step fits into the buffer, expected " +
                         std::to_string(made->steps.bytes_of_first) + " bytes or more",
                     {.key = "buffer_bytes"});
  return made;
}

/// Makes a structured array of the trace's own items.
template <class Item>
py::array view_of(const py::object& self, const std::vector<Item>& items) {
  py::array_t<Item> view(static_cast<py::ssize_t>(items.size()), items.data(), self);
  view.attr("setflags")(false);
  return view;
}

py::array_t<int> edges_of(const Trace& trace) {
  const std::vector<NodeEdge>& edges = trace.steps.graph.edges;
  py::array_t<int> rows({static_cast<py::ssize_t>(edges.size()), py::ssize_t{2}});
  int* to = rows.mutable_data();
  for (const NodeEdge& edge : edges) {
    *to++ = edge.from;
    *to++ = edge.to;
  }
  return rows;
}

py::dict summarise(const Trace& trace) {
  const trace::Summary summary = trace::summarise(trace.steps);
  return py::dict("work"_a = summary.work, "span"_a = summary.span, "elapsed"_a = summary.elapsed,
                  "bound"_a = summary.bound, "speedup"_a = summary.speedup,
                  "idle"_a = summary.idle);
}

std::string make_page(const Trace& trace) {
  if (viewer_page().empty())
    throw StateError("no page: Spoke was built without it, which takes Node and npm");
  return trace::make_trace_page(viewer_page(), trace::make_page_data(trace));
}

}  // namespace

void bind_trace(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(NodeSlice, node, step, pass, cluster, thread, begin, end);
  PYBIND11_NUMPY_DTYPE(TracedStep, step, time, passes);
  py::class_<Trace>(module, "Trace", "Which thread ran which node of the step graph when.")
      .def(py::init(&make_trace))
      .def_property_readonly(
          "slices",
          [](const py::object& self) {
            return view_of(self, self.cast<const Trace&>().steps.slices);
          },
          "(slices,) structured array, a view: node, step, pass, cluster, thread; begin and end "
          "[ns] from the start of the recording. Step -1: a surplus pass.")
      .def_property_readonly(
          "steps",
          [](const py::object& self) {
            return view_of(self, self.cast<const Trace&>().steps.steps);
          },
          "(steps,) structured array, a view: step, time [s] at its end, passes.")
      .def_property_readonly(
          "nodes", [](const Trace& trace) { return trace.steps.graph.names; },
          "By node its name, \"blade 2 / body 3 / inverse\".")
      .def_property_readonly("edges", &edges_of, "(edges, 2): from node, to node, within a pass.")
      .def_property_readonly(
          "threads", [](const Trace& trace) { return trace.steps.threads; },
          "That the steps ran on.")
      .def_property_readonly(
          "executor", [](const Trace& trace) { return trace.steps.executor; },
          "What ran the steps, in one line.")
      .def_property_readonly(
          "dropped_steps", [](const Trace& trace) { return trace.steps.dropped_steps; },
          "Made, but not recorded for want of room.")
      .def("summary", &summarise,
           "Of a typical step: work, span, elapsed and bound [s], speedup, and idle, the share of "
           "the threads' time.")
      .def("page", &make_page, "trace.html: one page without network.")
      .def("chrome_trace", &trace::make_chrome_trace,
           "trace.json, which chrome://tracing and Perfetto open.");
}

}  // namespace spoke::python
