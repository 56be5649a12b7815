#pragma once

// A trace as Chrome trace events.

#include <string>

#include "program/trace/trace.h"

namespace spoke::trace {

/// Returns the text of trace.json: Chrome trace events, for Perfetto and chrome://tracing. Tracks,
/// events and arguments are those of docs/trace.md. Precondition: there is a step.
std::string make_chrome_trace(const Trace& trace);

}  // namespace spoke::trace
