#pragma once

#include "engine/cli/arguments.h"

namespace spoke::cli {

/// `spoke study`. The exit status.
int study(const Arguments& arguments);

}  // namespace spoke::cli
