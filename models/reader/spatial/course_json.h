#pragma once

// Writes vectors and their courses over time as JSON, in the shape of their keys.

#include <string_view>

#include "models/mount_motion.h"
#include "models/reader/spatial/vector_shape.h"
#include "models/support/json.h"

namespace spoke::spatial {

/// Returns an array of the components that the shape has, or a number if that is one.
Json to_json(const Vector& vector, const VectorShape& shape);
/// Returns the table of a course.
Json to_json(const VectorCourse& course, std::string_view unit,
             const VectorShape& shape = kVectorInSpace);

}  // namespace spoke::spatial
