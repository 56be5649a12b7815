#pragma once

// Reads keys of several components: vectors, tensors, curves of vectors.

#include <string_view>

#include "models/reader/field_reader.h"
#include "models/reader/spatial/fault.h"
#include "models/reader/spatial/spatial_fields.h"
#include "models/reader/spatial/vector_shape.h"
#include "models/reader/toml_section.h"

namespace spoke::spatial {

/// Reads a vector of a shape, by default an array of three numbers.
Vector read_vector(const TomlSection& section, std::string_view key, const Quantity& quantity,
                   const VectorShape& shape = kVectorInSpace);

/// Reads an inertia tensor: one number, about every axis; three moments; or the six entries xx, yy,
/// zz, xy, xz, yz.
Tensor read_inertia(const TomlSection& section, std::string_view key, MayBeZero may_be_zero);

/// Reads the keys "time" and "factor" of a load; 1 if there are none.
Curve read_factor(const TomlSection& section);

/// Reads the table `key`, with "time" and arrays x, y, z or as the shape has it, or with
/// "constant", "rate", "amplitude" and "frequency"; zero if it is missing.
VectorCourse read_course(const TomlSection& section, std::string_view key, std::string_view unit,
                         const VectorShape& shape = kVectorInSpace);

}  // namespace spoke::spatial
