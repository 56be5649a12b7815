// Reads aerofoil files: a plain table, tables under lines of a value and its key, or C81.

#include "models/air/airfoil_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "models/air/aerodyn_airfoil.h"
#include "models/air/airfoil_check.h"
#include "models/air/airfoil_lines.h"
#include "models/air/c81_airfoil.h"
#include "models/solid/mesh_text.h"
#include "models/support/quantity.h"
#include "models/text_file.h"

namespace spoke::air {
namespace {

using spatial::Airfoil;
using spatial::Polar;

/// Makes the two ends of a column equal, which are the same angle; refuses those that differ much.
void close_column(const char* name, const AirfoilRows& table, const std::string& file,
                  std::vector<double>& column) {
  constexpr double most = 0.1;
  const double first = column.front(), last = column.back();
  if (std::abs(first - last) > most)
    refuse_airfoil(file, table.lines.back(),
                   std::string(name) + " is " + describe(last) + " at 180 degrees, expected " +
                       describe(first) + " as at -180 degrees");
  if (first != last) column.front() = column.back() = 0.5 * (first + last);
}

/// Makes a polar of rows.
Polar make_polar(const AirfoilRows& table, double reynolds, const std::string& file) {
  constexpr double end_tolerance = 0.1;  // degrees
  Polar polar;
  polar.reynolds = reynolds;
  const bool has_moment = !table.rows.empty() && table.rows.front().size() > 3;
  for (const std::vector<double>& row : table.rows) {
    polar.angle.push_back(row[0] * (std::numbers::pi / 180.0));
    polar.lift.push_back(row[1]);
    polar.drag.push_back(row[2]);
    if (has_moment) polar.moment.push_back(row[3]);
  }
  if (polar.angle.empty())
    refuse_airfoil(file, 0, "has no rows, expected angle of attack, lift and drag");
  const auto snap = [&](double& angle, double end) {
    if (std::abs(angle - end) <= end_tolerance * std::numbers::pi / 180.0) angle = end;
  };
  snap(polar.angle.front(), -std::numbers::pi);
  snap(polar.angle.back(), std::numbers::pi);
  const auto fault = find_polar_fault(polar);
  if (fault && !fault->only_ends_differ)
    refuse_airfoil(file, table.lines[fault->row >= 0 ? fault->row : 0], fault->what);
  close_column("lift", table, file, polar.lift);
  close_column("drag", table, file, polar.drag);
  if (has_moment) close_column("moment", table, file, polar.moment);
  return polar;
}

AirfoilRows read_plain(std::string_view text, const std::string& file) {
  AirfoilRows table;
  for (const AirfoilLine& line : split_airfoil_lines(text, "#!")) {
    add_row(line, file, 3, 4, false, table);
    const std::size_t columns = table.rows.front().size(), here = table.rows.back().size();
    if (here != columns)
      refuse_airfoil(file, line.number,
                     "has " + std::to_string(here) + " columns, expected " +
                         std::to_string(columns) + " as in the first row");
  }
  return table;
}

}  // namespace

Airfoil parse_airfoil(std::string_view text, const std::string& file, const std::string& name) {
  Airfoil airfoil;
  airfoil.name = name;
  if (is_c81_airfoil(text)) {
    airfoil.polars = read_c81_airfoil(text, file);
    for (const Polar& polar : airfoil.polars)
      if (const auto fault = find_polar_fault(polar))
        refuse_airfoil(
            file, 0,
            "at the Mach number " + describe(polar.mach.value_or(0.0)) + ' ' + fault->what);
    return airfoil;
  }
  if (!is_aerodyn_airfoil(text)) {
    airfoil.polars.push_back(make_polar(read_plain(text, file), 0.0, file));
    return airfoil;
  }
  int line_before = 0;
  for (const AerodynTable& table : read_aerodyn_airfoil(text, file)) {
    if (!airfoil.polars.empty() && !(table.reynolds > airfoil.polars.back().reynolds))
      refuse_airfoil(file, table.line,
                     "Re makes a Reynolds number of " + describe(table.reynolds) +
                         ", expected more than that of line " + std::to_string(line_before) + ", " +
                         describe(airfoil.polars.back().reynolds));
    line_before = table.line;
    airfoil.polars.push_back(make_polar(table.rows, table.reynolds, file));
  }
  return airfoil;
}

Airfoil read_airfoil(const std::filesystem::path& file, const std::string& name) {
  return parse_airfoil(read_text(file, "an aerofoil file"), file.string(), name);
}

}  // namespace spoke::air
