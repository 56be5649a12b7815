// Arrays by station; where a number stands in place of an array, it holds at every station.

#include "models/reader/spatial/section_reader.h"

#include <algorithm>

#include "models/reader/row_reader.h"
#include "models/reader/spatial/vector_reader.h"

namespace spoke::spatial {
namespace {

/// The place of entry (r, c) of a matrix in Spoke's axes within the matrix in BeamDyn's axes, and
/// its sign. BeamDyn's x is out of the plane of rotation, y in it towards the trailing edge, z
/// along the blade: ours are (z, -y, x).
struct BeamDynAxis {
  int index;
  double sign;
};
constexpr BeamDynAxis kBeamDyn[6] = {{2, 1.0}, {1, -1.0}, {0, 1.0}, {5, 1.0}, {4, -1.0}, {3, 1.0}};

/// Makes a matrix from all entries row by row, or from those of its upper triangle.
SectionMatrix to_matrix(const std::vector<double>& entries) {
  if (entries.size() == 36)
    return Eigen::Matrix<double, 6, 6, Eigen::RowMajor>::Map(entries.data());
  SectionMatrix matrix;
  std::size_t next = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) matrix(r, c) = matrix(c, r) = entries[next++];
  return matrix;
}

class SectionReader {
 public:
  SectionReader(const TomlSection& section, std::size_t stations)
      : section_(section), stations_(stations) {}

  void operator()(std::string_view key, std::vector<double>& values,
                  const Quantity& quantity) const {
    if (!section_.has(key)) return;
    if (section_.is_array(key)) {
      values = section_.numbers(key, quantity);
    } else {
      values.assign(stations_, section_.number(key, quantity));
    }
  }

  void operator()(std::string_view key, std::vector<Offset>& values,
                  const Quantity& quantity) const {
    if (!section_.has(key)) return;
    for (const std::vector<double>& row : section_.rows(key, quantity, 2))
      values.push_back(Offset::Map(row.data()));
  }

  void matrices(std::string_view key, std::vector<SectionMatrix>& values) const {
    if (!section_.has(key)) return;
    constexpr std::size_t all = 36, upper_triangle = 21;
    const bool is_beamdyn =
        section_.has("matrix_convention") &&
        keys::read_word(section_, keys::kSectionMatrixRows, "matrix_convention") == 1;
    for (const std::vector<double>& row :
         section_.rows(key, Quantity::any("SI"), all, upper_triangle))
      values.push_back(is_beamdyn ? swap_beamdyn_axes(to_matrix(row)) : to_matrix(row));
  }

 private:
  const TomlSection& section_;
  std::size_t stations_;
};

TomlSection::Keys section_keys() {
  return keys::keys_of(keys::kSectionRows, keys::kStiffnessRows, keys::kShearStiffnessRows,
                       keys::kSectionInertiaRows, keys::kSectionMatrixRows,
                       keys::kSectionShapeRows);
}

}  // namespace

SectionMatrix swap_beamdyn_axes(const SectionMatrix& matrix) {
  SectionMatrix swapped;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      swapped(r, c) =
          kBeamDyn[r].sign * kBeamDyn[c].sign * matrix(kBeamDyn[r].index, kBeamDyn[c].index);
  return swapped;
}

TomlSection::Keys beam_keys() { return keys::keys_of(keys::kBeamRows); }

Sections read_sections(const TomlSection& beam, double length) {
  if (!beam.has("sections"))
    beam.fail("sections", "is missing, expected a table of properties by station");
  const TomlSection table = beam.section("sections", section_keys());
  Sections sections;
  sections.station = table.has("station") ? table.increasing_numbers("station", kStation)
                                          : std::vector<double>{0.0, length};
  if (table.has("matrix_convention") && !table.has("stiffness_6x6") && !table.has("mass_6x6"))
    table.fail("matrix_convention",
               "would be ignored, expected only with \"stiffness_6x6\" or \"mass_6x6\"");
  const SectionReader read(table, sections.station.size());
  keys::visit_stations(keys::kSectionRows, sections, read);
  visit_stiffnesses(sections, read);
  visit_shear_stiffnesses(sections, read);
  visit_inertias(sections, read);
  read("mass_center", sections.mass_center, kLength);
  visit_stiffness_centers(sections, read);
  read.matrices("stiffness_6x6", sections.stiffness_6x6);
  read.matrices("mass_6x6", sections.mass_6x6);
  visit_shape(sections, read);
  return sections;
}

std::vector<PointMass> read_point_masses(const TomlSection& beam) {
  std::vector<PointMass> points;
  for (const TomlSection& table :
       beam.sections("point_mass", keys::keys_of(keys::kSpacePointMassRows))) {
    PointMass point;
    keys::read(table, keys::kSpacePointMassRows, &point);
    if (table.has("inertia")) point.inertia = read_inertia(table, "inertia", MayBeZero::yes);
    points.push_back(point);
  }
  return points;
}

}  // namespace spoke::spatial
