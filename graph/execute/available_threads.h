#pragma once

// The processors of this process, whatever OpenMP has bound.

namespace spoke::graph {

/// Returns the number of processors that this process started with: the OpenMP runtime may have
/// bound the calling thread to one of them since. At least 1. Quotas of control groups do not
/// count, as they do in available_threads().
int processors_of_process();

}  // namespace spoke::graph
