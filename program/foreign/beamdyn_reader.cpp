// BeamDyn's axes are x flapwise, y edgewise towards the trailing edge, z along the blade; its twist
// is in degrees, and of the other sense than a right-handed one about z.

#include "program/foreign/beamdyn_reader.h"

#include <cmath>
#include <numbers>

#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/section_check.h"

namespace spoke::foreign {
namespace {

constexpr double kLeastGap = 1e-9;

/// Reads the counts of key points of members, which share their ends.
void read_members(InputLines& lines, int members, int total) {
  int points = 0;
  for (int m = 1; m <= members; ++m) {
    const auto row = lines.take_numbers(
        2, "the number of member " + std::to_string(m) + " and its number of key points");
    if (row[0] != m)
      lines.refuse("member number is " + describe(row[0]) + ", expected " + std::to_string(m));
    if (row[1] != std::floor(row[1]) || row[1] < 3.0 || row[1] > total)
      lines.refuse("member " + std::to_string(m) + " has " + describe(row[1]) +
                   " key points, expected a whole number from 3 to kp_total, " +
                   std::to_string(total));
    points += static_cast<int>(row[1]) - (m > 1 ? 1 : 0);
  }
  if (points != total)
    lines.refuse("the members have " + std::to_string(points) + " key points, expected kp_total, " +
                 std::to_string(total));
}

KeyPoint read_key_point(InputLines& lines, int number, const std::vector<KeyPoint>& before) {
  const std::string what =
      "kp_xr, kp_yr, kp_zr and initial_twist of key point " + std::to_string(number);
  const auto row = lines.take_numbers(4, what);
  KeyPoint point;
  point.x = row[2];
  point.sweep = row[1] == 0.0 ? 0.0 : -row[1];
  point.prebend = row[0];
  if (before.empty() && is_at_root(point)) point.x = point.sweep = point.prebend = 0.0;
  point.twist = row[3] == 0.0 ? 0.0 : -row[3] * std::numbers::pi / 180.0;
  point.from = "key point " + std::to_string(number) + ", " + lines.place();
  if (before.empty() && (point.x != 0.0 || point.sweep != 0.0 || point.prebend != 0.0))
    lines.refuse("key point 1 is not at the root, expected 0 for kp_xr, kp_yr and kp_zr");
  if (!before.empty() && !(point.x > before.back().x))
    lines.refuse("kp_zr is " + describe(point.x) + ", expected more than that of the key point " +
                 "before, " + describe(before.back().x));
  return point;
}

using Check = std::string (*)(SectionMatrix& matrix, double& asymmetry);

/// Reads six rows and checks them; a fault of the whole is placed at the first row.
SectionMatrix read_matrix(InputLines& lines, const std::string& name, Check check,
                          double& asymmetry) {
  SectionMatrix matrix;
  int line = 0;
  for (int r = 0; r < 6; ++r) {
    const auto row = lines.take_numbers(6, "row " + std::to_string(r + 1) + " of the " + name);
    for (int c = 0; c < 6; ++c) matrix(r, c) = row[static_cast<std::size_t>(c)];
    if (r == 0) line = lines.number();
  }
  if (const std::string fault = check(matrix, asymmetry); !fault.empty())
    refuse(lines.file(), line, name + ' ' + fault);
  return matrix;
}

FoundSection read_section(InputLines& lines, int number, int total, double before,
                          double& asymmetry) {
  const std::string of = " of section " + std::to_string(number);
  FoundSection section;
  section.eta = lines.take_numbers(1, "eta" + of)[0];
  section.from = "section " + std::to_string(number) + ", " + lines.place();
  if (number == 1 && section.eta != 0.0)
    lines.refuse("eta of the first section is " + describe(section.eta) + ", expected 0, the root");
  if (number > 1 && !(section.eta > before + kLeastGap))
    lines.refuse("eta" + of + " is " + describe(section.eta) +
                 ", expected more than that of the one before, " + describe(before));
  if (number == total && section.eta != 1.0)
    lines.refuse("eta of the last section is " + describe(section.eta) + ", expected 1, the tip");
  section.stiffness = read_matrix(lines, "stiffness matrix" + of, check_stiffness, asymmetry);
  section.mass = read_matrix(lines, "mass matrix" + of, check_mass, asymmetry);
  return section;
}

/// Reads the ratios of modes that newer files have behind the factors.
void read_modal_damping(InputLines& lines, bool is_used, BeamDynBlade& blade) {
  lines.take_filled("the headline MODAL DAMPING");
  const int modes = lines.take_count("n_modes", 1, 200);
  const auto ratios = lines.take_numbers(static_cast<std::size_t>(modes),
                                         "zeta, a damping ratio for each of n_modes");
  if (!is_used) return;
  for (const double ratio : ratios)
    if (!(ratio >= 0.0 && ratio < 1.0))
      lines.refuse("zeta is " + describe(ratio) + ", expected ratios of 0 or more and less than 1");
  blade.ratios = ratios;
  blade.damping_from = "zeta, " + lines.place();
}

void read_damping(InputLines& lines, BeamDynBlade& blade) {
  const bool has_modes = lines.has("n_modes");
  const int kind = lines.take_count("damp_type", 0, has_modes ? 2 : 1);
  lines.take_filled("the headline DAMPING COEFFICIENT");
  lines.take_filled("the heads of the columns mu1 to mu6");
  lines.take_filled("the units of mu1 to mu6");
  const std::vector<double> mu = lines.take_numbers(6, "mu1 to mu6");
  for (const double factor : mu)
    if (factor < 0.0)
      lines.refuse("mu is " + describe(factor) + ", expected six numbers of 0 or more (s)");
  blade.damping_from = "mu1 to mu6, " + lines.place();
  if (kind == 1) blade.mu = mu;
  if (has_modes) read_modal_damping(lines, kind == 2, blade);
}

}  // namespace

BeamDynPrimary read_beamdyn_primary(const SourceFile& source) {
  InputLines lines(source.text, source.name);
  BeamDynPrimary primary;
  lines.take("the first line of a primary file of BeamDyn");
  primary.title = printable(lines.take("a title"));
  lines.seek("member_total");
  primary.members = lines.take_count("member_total", 1, 1000);
  const int total = lines.take_count("kp_total", 3, kMostStations);
  read_members(lines, primary.members, total);
  lines.take_filled("the heads of the key points' columns, kp_xr kp_yr kp_zr initial_twist");
  lines.take_filled("the units of the key points' columns");
  for (int number = 1; number <= total; ++number)
    primary.points.push_back(read_key_point(lines, number, primary.points));
  primary.blade_file = lines.find_value("BldFile");
  primary.blade_file_line = lines.number();
  return primary;
}

BeamDynBlade read_beamdyn_blade(const SourceFile& source) {
  InputLines lines(source.text, source.name);
  BeamDynBlade blade;
  lines.take("the first line of a blade file of BeamDyn");
  blade.title = printable(lines.take("a title"));
  lines.take_filled("the headline BLADE PARAMETERS");
  const int total = lines.take_count("station_total", 2, kMostStations);
  read_damping(lines, blade);
  lines.take_filled("the headline DISTRIBUTED PROPERTIES");
  for (int number = 1; number <= total; ++number)
    blade.sections.push_back(read_section(
        lines, number, total, number > 1 ? blade.sections.back().eta : 0.0, blade.asymmetry));
  return blade;
}

}  // namespace spoke::foreign
