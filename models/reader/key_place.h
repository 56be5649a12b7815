#pragma once

// Where the key of a fault that a model shows only when it is built stands in its file.

#include "models/error.h"
#include "models/scenario.h"

namespace spoke {

/// Returns the error with the place of its key in the scenario's file, as far as it is found;
/// an error without a key with the name of the file alone.
InputError place_in_file(const InputError& error, const std::string& file,
                         const Overrides& overrides);

}  // namespace spoke
