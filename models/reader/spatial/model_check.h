#pragma once

// Checks models in space that are filled in code.

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Gives solids that have none their meshes and geometries, and the air its wind, so that these are
/// read and made once. Throws InputError as check_model() does.
void read_model_files(Model& model);

/// Throws InputError unless the model could stand in a file: "KEY: what is wrong, what is
/// expected", the key as Scenario::to_json() has it, blades and loads counted from 1. check_drive()
/// checks the hub's drive.
void check_model(const Model& model);

}  // namespace spoke::spatial
