#pragma once

// A trace as the data of trace.html.

#include <string>
#include <string_view>

#include "engine/trace/trace.h"

namespace spoke::trace {

/// The trace without its slices, as JSON: settings, machine, graph, threads and steps. Fields are
/// those of docs/trace.md.
std::string make_description(const Trace& trace);

/// The same with the slices as columns: what the page trace.html reads.
std::string make_page_data(const Trace& trace);

/// The page with data in it: `page` is that of graph/viewer, whose element
/// <script type="application/json" id="spoke-trace"> holds null. Throws std::invalid_argument
/// without exactly one such element.
std::string make_trace_page(std::string_view page, std::string_view json);

}  // namespace spoke::trace
