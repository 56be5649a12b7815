#pragma once

// The one header for programs that embed Spoke. Installed as <spoke/spoke.h>, with the headers that
// it includes.

#include "engine/campbell.h"
#include "engine/checkpoint.h"
#include "engine/controller.h"
#include "engine/courses.h"
#include "engine/critical.h"
#include "engine/equilibrium.h"
#include "engine/linearize.h"
#include "engine/modes.h"
#include "engine/performance.h"
#include "engine/reduce.h"
#include "engine/results.h"
#include "engine/run_statistics.h"
#include "engine/simulation.h"
#include "graph/declaration_check.h"
#include "graph/executor.h"
#include "graph/run_trace.h"
#include "models/air/iec_wind.h"
#include "models/error.h"
#include "models/hints.h"
#include "models/scenario.h"

/// Systems of flexible bodies, and their simulation.
namespace spoke {}

/// Step graphs, and the executors that run them.
namespace spoke::graph {}
