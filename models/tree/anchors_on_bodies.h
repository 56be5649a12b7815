#pragma once

// Anchors that move against bodies: loops that close on them close on these bodies.

#include <optional>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns a model whose loops that close on anchors of the frame `body` close on the bodies of
/// these, on their own subsystem or elsewhere, see LoopPlace::moved_by; none if it has no such
/// anchor.
std::optional<Model> put_on_bodies_of_anchors(const Model& model);

}  // namespace spoke::spatial
