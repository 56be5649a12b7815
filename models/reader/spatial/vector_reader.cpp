// Arrays of three and six numbers.

#include "models/reader/spatial/vector_reader.h"

#include "models/reader/curve_reader.h"

namespace spoke::spatial {

Vector read_vector(const TomlSection& section, std::string_view key, const Quantity& quantity,
                   const VectorShape& shape) {
  Vector vector = Vector::Zero();
  if (shape.count == 1) {
    vector[static_cast<Eigen::Index>(shape.first)] = section.number(key, quantity);
    return vector;
  }
  const std::vector<double> values = section.numbers(key, quantity, shape.count);
  for (std::size_t i = 0; i < shape.count; ++i)
    vector[static_cast<Eigen::Index>(shape.first + i)] = values[i];
  return vector;
}

Tensor read_inertia(const TomlSection& section, std::string_view key, MayBeZero may_be_zero) {
  const std::string expected =
      "one moment of inertia, about every axis, 3 moments, or 6 entries xx, yy, zz, xy, xz, yz "
      "(kg m^2)";
  if (!section.has(key)) section.fail(key, "is missing, expected " + expected);
  if (section.is_text(key) || section.is_table(key)) section.fail_expected(key, expected);
  if (!section.is_array(key))
    return section.number(key, may_be_zero == MayBeZero::yes ? Quantity::not_negative("kg m^2")
                                                             : Quantity::positive("kg m^2")) *
           Tensor::Identity();
  const std::vector<double> v = section.numbers(key, kInertia);
  if (v.size() != 3 && v.size() != 6) section.fail_expected(key, expected);
  Tensor tensor = Vector(v[0], v[1], v[2]).asDiagonal();
  if (v.size() == 3) return tensor;
  tensor(0, 1) = tensor(1, 0) = v[3];
  tensor(0, 2) = tensor(2, 0) = v[4];
  tensor(1, 2) = tensor(2, 1) = v[5];
  return tensor;
}

Curve read_factor(const TomlSection& section) {
  if (!section.has("time") && !section.has("factor")) return Curve(1.0);
  return read_curve(section, "time", kTime, "factor", kFactor);
}

namespace {

/// Reads the course of a table that has "time".
VectorTable read_table(const TomlSection& table, const Quantity& quantity,
                       const VectorShape& shape) {
  for (const char* other : {"constant", "rate", "amplitude", "frequency", "phase"})
    if (table.has(other)) table.fail(other, "given along with time, expected only one of them");
  VectorTable course;
  for (std::size_t i = 0; i < shape.count; ++i)
    if (table.has(shape.names[i]))
      course.components[shape.first + i] =
          read_curve(table, "time", kTime, shape.names[i], quantity);
  return course;
}

/// Reads the numbers and vectors of a harmonic course.
struct CourseReader {
  const TomlSection& table;
  const VectorShape& shape;

  void operator()(std::string_view key, double& value, const Quantity& quantity,
                  Presence presence) const {
    FieldReader{table}(key, value, quantity, presence);
  }
  void operator()(std::string_view key, Vector& value, const Quantity& quantity, Presence) const {
    if (table.has(key)) value = read_vector(table, key, quantity, shape);
  }
};

}  // namespace

VectorCourse read_course(const TomlSection& section, std::string_view key, std::string_view unit,
                         const VectorShape& shape) {
  if (!section.has(key)) return VectorHarmonic{};
  const TomlSection::Keys components(shape.names.begin(), shape.names.begin() + shape.count);
  TomlSection::Keys known = components;
  known.insert(known.begin(), "time");
  known.insert(known.end(), {"constant", "rate", "amplitude", "frequency", "phase"});
  const TomlSection table = section.section(key, known);
  if (table.has("time")) return read_table(table, Quantity::any(unit), shape);
  for (const std::string_view component : components)
    if (table.has(component)) table.fail(component, "would be ignored, expected only with time");
  if (!table.has("constant") && !table.has("rate") && !table.has("amplitude"))
    table.fail("", "has none of time, constant, rate and amplitude, expected one or more");
  if (table.has("amplitude") && !table.has("frequency"))
    table.fail("frequency", "is missing, expected a number (rad/s)");
  for (const char* other : {"frequency", "phase"})
    if (table.has(other) && !table.has("amplitude"))
      table.fail(other, "would be ignored, expected only with amplitude");
  VectorHarmonic course;
  visit_fields(course, unit, CourseReader{table, shape});
  return course;
}

}  // namespace spoke::spatial
