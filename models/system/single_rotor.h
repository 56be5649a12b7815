#pragma once

// A rotor of a model apart from what carries it.

#include <string>
#include <vector>

#include "models/sensor.h"
#include "models/spatial_model.h"
#include "models/tree/tree.h"

namespace spoke {

/// Returns the number of the rotor of a model by a name. Throws InputError, which begins with
/// `what`, if there is none.
int find_rotor(const spatial::Model& model, const std::string& name, const std::string& what);

/// Returns a rotor of a model on a support without it: on an axle that nothing moves, with its own
/// blades, subsystems and loads. Blades have the numbers that they have among those of the rotor.
spatial::Model without_support(const spatial::Model& model, int rotor);

/// Returns its trees, with the names that they have in the whole model. `trees`: those of
/// build_trees() of the model. Precondition: no loop of another rotor or of the support ends on
/// them.
std::vector<spatial::Tree> take_trees(const std::vector<spatial::Tree>& trees, int rotor);

/// Returns the numbers of these trees among all.
std::vector<std::size_t> list_trees(const std::vector<spatial::Tree>& trees, int rotor);

/// Returns the sensors of a model that are on a rotor, for without_support(); those of the first
/// rotor with all that are on no subsystem.
std::vector<Sensor> take_sensors(const std::vector<Sensor>& sensors, const spatial::Model& model,
                                 int rotor);

}  // namespace spoke
