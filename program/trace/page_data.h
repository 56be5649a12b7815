#pragma once

// Writes a trace as the data of trace.html.

#include <string>
#include <string_view>

#include "program/trace/trace.h"

namespace spoke::trace {

/// Returns the trace without its slices, as JSON: settings, machine, graph, threads, steps, and
/// what more threads would gain. Fields are those of docs/trace.md.
std::string make_description(const Trace& trace);

/// Returns the trace with its slices as columns: the data that the page trace.html reads.
std::string make_page_data(const Trace& trace);

/// Returns the page with data in it: `page` is that of program/viewer, whose element <script
/// type="application/json" id="spoke-trace"> holds null. Throws std::invalid_argument without
/// exactly one such element.
std::string make_trace_page(std::string_view page, std::string_view json);

}  // namespace spoke::trace
