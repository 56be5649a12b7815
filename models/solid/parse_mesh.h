#pragma once

// Reads meshes from texts.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "models/solid_body.h"

namespace spoke::solid {

/// Reads the text of a mesh file as read_mesh() does. `file` is its name in messages.
std::shared_ptr<const spatial::SolidMesh> parse_mesh(
    std::string_view text, const std::string& file, double length_scale,
    std::optional<spatial::SolidMaterial>* material = nullptr);

/// Reads nodes and sets of a mesh file: all nodes, no elements. Of an .inp file these may be of any
/// types. Throws InputError as read_mesh() does.
std::shared_ptr<spatial::SolidMesh> read_node_mesh(const std::string& file, double length_scale);

}  // namespace spoke::solid
