// Rules for sections and beams.

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "models/reader/scenario_fields.h"
#include "models/reader/spatial/fault.h"

namespace spoke::spatial {
namespace {

std::string count_numbers(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " value" : " values");
}

/// Whether the matrix, scaled to ones on its diagonal, is regular and positive definite.
bool is_positive_definite(const SectionMatrix& matrix) {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  if ((matrix.diagonal().array() <= 0.0).any()) return false;
  const Eigen::Matrix<double, 6, 1> scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Matrix scaled = scale.asDiagonal() * Matrix(matrix) * scale.asDiagonal();
  const Eigen::LLT<Matrix> factor(scaled);
  // Least pivot of the factor; its square is next to round-off.
  constexpr double least_pivot = 1e-7;
  return factor.info() == Eigen::Success &&
         Matrix(factor.matrixL()).diagonal().minCoeff() > least_pivot;
}

/// Finds a fault of one matrix; `path` is the path of its key.
Fault find_matrix_fault(const std::string& path, const SectionMatrix& matrix) {
  constexpr double slack = 1e-6;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < r; ++c) {
      const double size = std::sqrt(std::abs(matrix(r, r) * matrix(c, c)));
      if (std::abs(matrix(r, c) - matrix(c, r)) > slack * size)
        return {path, "is not symmetric: row " + std::to_string(c + 1) + ", column " +
                          std::to_string(r + 1) + " is " + describe(matrix(c, r)) +
                          ", the other is " + describe(matrix(r, c)) + "; expected equal ones"};
    }
  if (is_positive_definite(matrix)) return {};
  return {path, "is not positive definite, expected a matrix that gives every motion energy"};
}

/// Finds a mass matrix that is no slice of a beam: one mass, centre in the section, thin.
Fault find_slice_fault(const std::string& path, const SectionMatrix& m) {
  const double mass = m(0, 0), second = m(3, 3);
  const double first = std::sqrt(mass * second);
  const auto differ = [](double a, double b, double size) { return std::abs(a - b) > 1e-3 * size; };
  const bool is_of_mass = !differ(m(1, 1), mass, mass) && !differ(m(2, 2), mass, mass) &&
                          !differ(m(0, 1), 0.0, mass) && !differ(m(0, 2), 0.0, mass) &&
                          !differ(m(1, 2), 0.0, mass);
  const bool is_of_center = !differ(m(0, 3), 0.0, first) && !differ(m(1, 4), 0.0, first) &&
                            !differ(m(2, 5), 0.0, first) && !differ(m(1, 5), 0.0, first) &&
                            !differ(m(2, 4), 0.0, first) && !differ(m(0, 4), -m(1, 3), first) &&
                            !differ(m(0, 5), -m(2, 3), first);
  const bool is_thin = !differ(m(3, 3), m(4, 4) + m(5, 5), second) &&
                       !differ(m(3, 4), 0.0, second) && !differ(m(3, 5), 0.0, second);
  if (is_of_mass && is_of_center && is_thin) return {};
  return {path,
          "is not the mass of a thin slice, expected m three times on the diagonal, the first "
          "moments of a centre in the section, and a polar inertia that is the sum of the two "
          "others; or matrix_convention = \"beamdyn\"?"};
}

Fault find_matrices_fault(const std::string& key, const std::vector<SectionMatrix>& matrices,
                          bool is_mass) {
  const FirstFault first;
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const std::string path = key + '.' + std::to_string(i + 1);
    for (int k = 0; k < 36; ++k)
      first(path + '.' + std::to_string(k + 1), matrices[i](k / 6, k % 6), Quantity::any(""));
    if (first.found()) return first.found();
    first.add(find_matrix_fault(path, matrices[i]));
    if (is_mass) first.add(find_slice_fault(path, matrices[i]));
    if (first.found()) return first.found();
  }
  return {};
}

/// Finds values that are given beside a matrix that holds them.
Fault find_double(const Sections& sections) {
  const FirstFault first;
  const auto refuse = [&](bool doubled, std::string_view key, const char* matrix) {
    if (doubled)
      first.add({std::string(key),
                 std::string("given along with ") + matrix + ", expected only one of them"});
  };
  const bool has_stiffness = !sections.stiffness_6x6.empty(), has_mass = !sections.mass_6x6.empty();
  const auto of_stiffness = [&](std::string_view key, const auto& values, const Quantity&) {
    refuse(has_stiffness && !values.empty(), key, "stiffness_6x6");
  };
  const auto of_mass = [&](std::string_view key, const auto& values, const Quantity&) {
    refuse(has_mass && !values.empty(), key, "mass_6x6");
  };
  visit_stiffnesses(sections, of_stiffness);
  visit_shear_stiffnesses(sections, of_stiffness);
  visit_stiffness_centers(sections, of_stiffness);
  of_mass("mass_per_length", sections.mass_per_length, {});
  visit_inertias(sections, of_mass);
  of_mass("mass_center", sections.mass_center, {});
  return first.found();
}

/// Finds arrays that are not as long as the array of stations.
Fault find_length_fault(const Sections& sections) {
  const FirstFault first;
  const std::size_t stations = sections.station.size();
  const auto check = [&](std::string_view key, const auto& values, bool is_needed) {
    if (values.size() == stations || (!is_needed && values.empty())) return;
    first.add({std::string(key), values.empty()
                                     ? "is missing, expected " + std::to_string(stations) +
                                           " values, one for each station"
                                     : "has " + count_numbers(values.size()) + ", expected " +
                                           std::to_string(stations) + ", one for each station"});
  };
  const bool by_values = sections.stiffness_6x6.empty(), mass_by_values = sections.mass_6x6.empty();
  const auto needed = [&](std::string_view key, const auto& values, const Quantity&) {
    check(key, values, by_values);
  };
  const auto optional = [&](std::string_view key, const auto& values, const Quantity&) {
    check(key, values, false);
  };
  check("mass_per_length", sections.mass_per_length, mass_by_values);
  visit_stiffnesses(sections, needed);
  visit_shear_stiffnesses(sections, optional);
  visit_stiffness_centers(sections, optional);
  // Stiffness matrices do not say how wide the sections are.
  visit_inertias(sections, [&](std::string_view key, const auto& values, const Quantity&) {
    check(key, values, mass_by_values && !by_values);
  });
  check("mass_center", sections.mass_center, false);
  check("stiffness_6x6", sections.stiffness_6x6, false);
  check("mass_6x6", sections.mass_6x6, false);
  visit_shape(sections, optional);
  return first.found();
}

Fault find_range_fault(const Sections& sections) {
  const FirstFault first;
  const auto numbers = [&](std::string_view key, const std::vector<double>& values,
                           const Quantity& quantity) { first.numbers(key, values, quantity); };
  const auto offsets = [&](const char* key, const std::vector<Offset>& values,
                           const Quantity& quantity) {
    for (std::size_t i = 0; i < values.size(); ++i)
      first.numbers(key + ('.' + std::to_string(i + 1)), {values[i].x(), values[i].y()}, quantity);
  };
  first.numbers("station", sections.station, kStation);
  first.numbers("mass_per_length", sections.mass_per_length, Quantity::positive("kg/m"));
  visit_stiffnesses(sections, numbers);
  visit_shear_stiffnesses(sections, numbers);
  visit_inertias(sections, numbers);
  visit_shape(sections, numbers);
  visit_stiffness_centers(sections, offsets);
  offsets("mass_center", sections.mass_center, kLength);
  return first.found();
}

Fault find_station_fault(const std::vector<double>& station, double length) {
  if (station.size() < 2)
    return {"station", "has " + count_numbers(station.size()) + ", expected 2 or more"};
  for (std::size_t i = 1; i < station.size(); ++i)
    if (!(station[i] > station[i - 1]))
      return {"station." + std::to_string(i + 1), "is " + describe(station[i]) +
                                                      ", expected more than the value before it, " +
                                                      describe(station[i - 1])};
  if (station.front() != 0.0)
    return {"station", "begins at " + describe(station.front()) + ", expected 0 (m, the root)"};
  if (std::abs(station.back() - length) > 1e-9 * length)
    return {"station", "ends at " + describe(station.back()) + ", expected " + describe(length) +
                           " (m, length)"};
  return {};
}

Fault find_point_mass_fault(const PointMass& point, double length) {
  const FirstFault first;
  first("position", point.position, {"m, from root to tip", 0.0, length}, Presence::required);
  visit_fields(point, first);
  first.add(find_inertia_fault("inertia", point.inertia, MayBeZero::yes));
  return first.found();
}

}  // namespace

Fault find_fault(const Sections& sections, double length) {
  const FirstFault first;
  first.add(find_station_fault(sections.station, length));
  first.add(find_range_fault(sections));
  first.add(find_double(sections));
  first.add(find_length_fault(sections));
  if (!first.found())
    first.add(find_matrices_fault("stiffness_6x6", sections.stiffness_6x6, false));
  if (!first.found()) first.add(find_matrices_fault("mass_6x6", sections.mass_6x6, true));
  return first.found();
}

Fault find_fault(const Beam& beam) {
  const FirstFault first;
  visit_fields(beam, first);
  if (first.found()) return first.found();
  if (const char* fault = find_strain_fault(beam.strain, beam.geometric_stiffening))
    first.add({"geometric_stiffening", fault});
  first.add(find_fault(beam.sections, beam.length).within("sections"));
  if (beam.point_masses.size() > kMostPointMasses)
    first.add({"point_mass", "are " + std::to_string(beam.point_masses.size()) +
                                 " tables, expected at most " + std::to_string(kMostPointMasses)});
  for (std::size_t i = 0; i < beam.point_masses.size() && !first.found(); ++i)
    first.add(find_point_mass_fault(beam.point_masses[i], beam.length)
                  .within("point_mass." + std::to_string(i + 1)));
  return first.found();
}

Fault find_fault(const RigidBody& body) {
  const FirstFault first;
  visit_fields(body, first);
  first.add(find_inertia_fault("inertia", body.inertia, MayBeZero::no));
  return first.found();
}

}  // namespace spoke::spatial
