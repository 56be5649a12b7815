// Version 1 has c_l, c_d, c_m over angles in rad, version 2 cl, cd, cm over degrees, by Reynolds
// number in re_sets.

#include "program/foreign/windio_polars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/air/airfoil_check.h"
#include "models/support/quantity.h"
#include "program/foreign/input_lines.h"

namespace spoke::foreign {
namespace {

constexpr double kHalfTurn = 180.0;  // degrees

/// A coefficient over angles of attack.
struct Coefficient {
  std::vector<double> angle, value;
  double at(double place) const {
    const auto above = std::upper_bound(angle.begin() + 1, angle.end() - 1, place);
    const auto k = static_cast<std::size_t>(above - angle.begin());
    const double t = std::clamp((place - angle[k - 1]) / (angle[k] - angle[k - 1]), 0.0, 1.0);
    return t == 1.0 ? value[k] : value[k - 1] + t * (value[k] - value[k - 1]);
  }
};

/// Reads a coefficient. Its first and last angles become half a turn where they nearly are.
Coefficient read_coefficient(const Entry& table, double unit) {
  const Entry grid = table.at("grid"), values = table.at("values");
  Coefficient read{grid.numbers(), values.numbers()};
  check_count(values, read.value.size(), read.angle.size());
  if (read.angle.size() < 2) grid.refuse("expected two or more angles of attack");
  for (double& angle : read.angle) angle *= unit;
  constexpr double tolerance = 0.1, least_gap = 1e-6;
  const auto snap = [&](double& angle, double end) {
    if (std::abs(angle - end) <= tolerance) angle = end;
  };
  snap(read.angle.front(), -kHalfTurn);
  snap(read.angle.back(), kHalfTurn);
  if (read.angle.front() != -kHalfTurn || read.angle.back() != kHalfTurn)
    grid.refuse("goes from " + describe(read.angle.front()) + " to " + describe(read.angle.back()) +
                " degrees, expected -180 to 180");
  for (std::size_t i = 1; i < read.angle.size(); ++i)
    if (!(read.angle[i] > read.angle[i - 1] + least_gap))
      grid.refuse("element " + std::to_string(i + 1) + " is " + describe(read.angle[i]) +
                  " degrees, expected more than the one before, " + describe(read.angle[i - 1]));
  return read;
}

/// Makes the two ends of a column equal, which are the same angle; where they differ much, they
/// stay and are refused.
void close_column(std::vector<double>& column) {
  constexpr double most = 0.1;
  if (!column.empty() && std::abs(column.front() - column.back()) <= most)
    column.front() = column.back() = 0.5 * (column.front() + column.back());
}

void check_polar(const FoundPolar& polar, const Entry& entry) {
  spatial::Polar found{polar.reynolds, polar.angle, polar.lift, polar.drag, polar.moment};
  for (double& angle : found.angle) angle *= std::numbers::pi / kHalfTurn;
  if (const auto fault = air::find_polar_fault(found))
    entry.refuse((fault->row < 0 ? "" : "row " + std::to_string(fault->row + 1) + ": ") +
                 fault->what);
}

FoundPolar read_polar(const Entry& entry, double unit) {
  const bool is_old = entry.has("c_l");
  const auto read = [&](const char* old, const char* now) {
    return read_coefficient(entry.at(is_old ? old : now), unit);
  };
  const Coefficient lift = read("c_l", "cl"), drag = read("c_d", "cd");
  std::vector<Coefficient> moment;
  if (entry.has(is_old ? "c_m" : "cm")) moment.push_back(read("c_m", "cm"));
  FoundPolar polar;
  if (entry.has("re")) polar.reynolds = entry.at("re").positive();
  std::vector<double>& angle = polar.angle;
  angle = lift.angle;
  angle.insert(angle.end(), drag.angle.begin(), drag.angle.end());
  if (!moment.empty()) angle.insert(angle.end(), moment[0].angle.begin(), moment[0].angle.end());
  angle.push_back(0.0);  // a table may have the ends only, and scenarios need three angles
  std::sort(angle.begin(), angle.end());
  const auto is_close = [](double a, double b) { return b - a <= 1e-4; };
  angle.erase(std::unique(angle.begin(), angle.end(), is_close), angle.end());
  for (const double place : angle) {
    polar.lift.push_back(lift.at(place));
    polar.drag.push_back(drag.at(place));
    if (!moment.empty()) polar.moment.push_back(moment[0].at(place));
  }
  for (auto* column : {&polar.lift, &polar.drag, &polar.moment}) close_column(*column);
  check_polar(polar, entry);
  return polar;
}

/// A set of polars: those of one configuration, or of the first.
struct PolarSet {
  FoundPolars polars;
  bool has_more = false;
};

PolarSet read_set(const Entry& airfoil, const std::string& configuration, double unit) {
  const Entry list = airfoil.at("polars");
  const std::vector<Entry> entries = list.elements();
  const auto name_of = [](const Entry& entry) {
    return entry.has("configuration") ? entry.at("configuration").text() : std::string();
  };
  if (entries.empty()) list.refuse("has no polars, expected one or more");
  const std::string wanted = configuration.empty() ? name_of(entries.front()) : configuration;
  PolarSet set;
  const auto add = [&](const Entry& entry) {
    const FoundPolar polar = read_polar(entry, unit);
    if (!set.polars.empty() && !(polar.reynolds > set.polars.back().reynolds))
      entry.refuse("re is " + describe(polar.reynolds) +
                   ", expected more than in the polar before, " +
                   describe(set.polars.back().reynolds));
    if (!set.polars.empty() && !(set.polars.back().reynolds > 0.0))
      entry.refuse("is a second polar, expected re in the one before");
    set.polars.push_back(polar);
  };
  for (const Entry& entry : entries) {
    if (!is_same_word(name_of(entry), wanted)) {
      set.has_more = true;
    } else if (entry.has("re_sets")) {
      for (const Entry& at : entry.at("re_sets").elements()) add(at);
    } else {
      add(entry);
    }
  }
  if (set.polars.empty())
    list.refuse("has no polars of the configuration \"" + wanted + "\", expected one or more");
  return set;
}

/// Reads and sums sets by their weights, which make up 1.
void read_sets(const Entry& airfoil, const Entry& use, double unit, WindioAirfoil& read) {
  const Entry names = use.at("configuration"), weights = use.at("weight");
  const std::vector<Entry> all = names.elements();
  const std::vector<double> weight = weights.numbers();
  if (all.empty() || weight.size() != all.size())
    weights.refuse("has " + std::to_string(weight.size()) + " elements, expected " +
                   std::to_string(std::max<std::size_t>(all.size(), 1)) +
                   ", one for each of configuration");
  double sum = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!(weight[k] >= 0.0))
      weights.refuse("element " + std::to_string(k + 1) + " is " + describe(weight[k]) +
                     ", expected 0 or more");
    const PolarSet set = read_set(airfoil, all[k].text(), unit);
    sum += weight[k];
    if (k == 0)
      read.polars = set.polars;
    else if (sum > 0.0)
      read.polars = mix_polars(read.polars, set.polars, weight[k] / sum);
    if (weight[k] > 0.0)
      read.name += (k == 0 ? " " : " and ") + all[k].text() + ' ' + describe(weight[k]);
  }
  constexpr double tolerance = 1e-6;
  if (std::abs(sum - 1.0) > tolerance)
    weights.refuse("has the sum " + describe(sum) + ", expected 1");
}

}  // namespace

WindioAirfoil read_windio_airfoil(const Entry& airfoils, const Entry& name, const Entry& use,
                                  double unit) {
  const std::string wanted = name.text();
  for (const Entry& entry : airfoils.elements()) {
    if (!is_same_word(entry.at("name").text(), wanted)) continue;
    WindioAirfoil read;
    read.name = wanted;
    const Entry center = entry.at("aerodynamic_center");
    read.center = center.number();
    if (!(read.center >= 0.0 && read.center <= 1.0))
      center.refuse("is " + describe(read.center) + ", expected 0 to 1");
    if (use.has("configuration")) {
      read_sets(entry, use, unit, read);
    } else {
      PolarSet set = read_set(entry, "", unit);
      read.polars = std::move(set.polars);
      read.has_more = set.has_more;
    }
    return read;
  }
  name.refuse("is \"" + wanted + "\", expected the name of one of airfoils");
}

}  // namespace spoke::foreign
