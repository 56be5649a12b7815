// Writes what vector_reader.cpp reads.

#include "models/reader/spatial/course_json.h"

#include "models/reader/spatial/spatial_fields.h"

namespace spoke::spatial {

Json to_json(const Vector& vector, const VectorShape& shape) {
  const auto component = [&](std::size_t i) {
    return vector[static_cast<Eigen::Index>(shape.first + i)];
  };
  if (shape.count == 1) return component(0);
  Json json = Json::array();
  for (std::size_t i = 0; i < shape.count; ++i) json.push_back(component(i));
  return json;
}

Json to_json(const VectorCourse& course, std::string_view unit, const VectorShape& shape) {
  Json json;
  if (const auto* harmonic = std::get_if<VectorHarmonic>(&course)) {
    visit_fields(*harmonic, unit,
                 [&](std::string_view key, const auto& value, const Quantity&, Presence) {
                   if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Vector>)
                     json.set(key, to_json(value, shape));
                   else
                     json.set(key, value);
                 });
    return json;
  }
  // A component that is not given is zero, and has one point only.
  bool is_any = false;
  const auto& components = std::get<VectorTable>(course).components;
  for (std::size_t i = 0; i < shape.count; ++i) {
    const Curve& component = components[shape.first + i];
    if (component.times().size() == 1 && component.values()[0] == 0.0) continue;
    json.set("time", component.times());
    json.set(shape.names[i], component.values());
    is_any = true;
  }
  if (!is_any) return to_json(VectorCourse(VectorHarmonic{}), unit, shape);
  return json;
}

}  // namespace spoke::spatial
