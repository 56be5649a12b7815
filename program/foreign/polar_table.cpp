// Sums of polars over the angles and Reynolds numbers of both, and their text.

#include "program/foreign/polar_table.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

#include "models/air/airfoil_reader.h"
#include "program/foreign/input_lines.h"
#include "program/foreign/toml_text.h"

namespace spoke::foreign {
namespace {

/// Returns the value at a place, linear between the given ones and constant beyond.
double value_at(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (y.empty()) return 0.0;
  const auto above = std::lower_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto k = static_cast<std::size_t>(above - x.begin());
  const double t = (at - x[k - 1]) / (x[k] - x[k - 1]);
  return t == 1.0 ? y[k] : y[k - 1] + t * (y[k] - y[k - 1]);
}

/// Returns the numbers of both, in order; those that are as good as equal once.
std::vector<double> unite_places(const std::vector<double>& a, const std::vector<double>& b,
                                 double least_gap) {
  std::vector<double> all(a);
  all.insert(all.end(), b.begin(), b.end());
  std::sort(all.begin(), all.end());
  const auto is_close = [&](double x, double y) { return y - x <= least_gap; };
  all.erase(std::unique(all.begin(), all.end(), is_close), all.end());
  return all;
}

FoundPolar mix(const FoundPolar& a, const FoundPolar& b, double share) {
  if (share == 0.0) return a;
  if (share == 1.0) return b;
  constexpr double least_gap = 1e-4;  // degrees; scenarios take those that are 1e-6 rad apart
  FoundPolar mixed;
  mixed.angle = unite_places(a.angle, b.angle, least_gap);
  const auto add = [&](std::vector<double> FoundPolar::*column, double angle) {
    (mixed.*column)
        .push_back((1.0 - share) * value_at(a.angle, a.*column, angle) +
                   share * value_at(b.angle, b.*column, angle));
  };
  const bool has_moment = !a.moment.empty() || !b.moment.empty();
  for (const double angle : mixed.angle) {
    add(&FoundPolar::lift, angle);
    add(&FoundPolar::drag, angle);
    if (has_moment) add(&FoundPolar::moment, angle);
  }
  return mixed;
}

/// Returns the polar at a Reynolds number.
FoundPolar at_reynolds(const FoundPolars& polars, double reynolds) {
  const auto above = std::lower_bound(
      polars.begin(), polars.end(), reynolds,
      [](const FoundPolar& polar, double value) { return polar.reynolds < value; });
  if (above == polars.begin()) return polars.front();
  if (above == polars.end()) return polars.back();
  const FoundPolar &low = *(above - 1), &high = *above;
  return mix(low, high, std::log(reynolds / low.reynolds) / std::log(high.reynolds / low.reynolds));
}

std::vector<double> reynolds_of(const FoundPolars& polars) {
  std::vector<double> all;
  if (polars.size() > 1)
    for (const FoundPolar& polar : polars) all.push_back(polar.reynolds);
  return all;
}

std::string write_rows(const FoundPolar& polar) {
  constexpr double least = 1e-30;  // degrees; smaller ones are too small in rad
  std::string text;
  for (std::size_t i = 0; i < polar.angle.size(); ++i) {
    const double angle = std::abs(polar.angle[i]) < least ? 0.0 : polar.angle[i];
    text += digits(angle) + ' ' + digits(polar.lift[i]) + ' ' + digits(polar.drag[i]);
    if (!polar.moment.empty()) text += ' ' + digits(polar.moment[i]);
    text += '\n';
  }
  return text;
}

std::string write_table(const FoundPolars& polars, const std::string& from) {
  const char* columns =
      polars.front().moment.empty() ? "lift, drag" : "lift, drag, moment (nose up)";
  std::string text = "! Written by spoke import: " + printable(from) +
                     "\n! angle of attack [deg], " + columns + '\n';
  if (polars.size() == 1) return text + write_rows(polars.front());
  text += std::to_string(polars.size()) + " NumTabs\n";
  constexpr double million = 1e6;
  for (const FoundPolar& polar : polars)
    text += digits(polar.reynolds / million) + " Re   ! millions\n0 UserProp\n" +
            std::to_string(polar.angle.size()) + " NumAlf\n" + write_rows(polar);
  return text;
}

bool is_taken(const std::string& name, const std::vector<FoundAirfoil>& airfoils) {
  return std::any_of(airfoils.begin(), airfoils.end(), [&](const FoundAirfoil& airfoil) {
    return is_same_word(airfoil.airfoil.name, name);
  });
}

}  // namespace

FoundPolars mix_polars(const FoundPolars& a, const FoundPolars& b, double share) {
  assert(!a.empty() && !b.empty());
  if (share == 0.0) return a;
  if (share == 1.0) return b;
  const std::vector<double> all = unite_places(reynolds_of(a), reynolds_of(b), 0.0);
  if (all.empty()) return {mix(a.front(), b.front(), share)};
  FoundPolars mixed;
  for (const double reynolds : all) {
    mixed.push_back(mix(at_reynolds(a, reynolds), at_reynolds(b, reynolds), share));
    mixed.back().reynolds = reynolds;
  }
  return mixed;
}

FoundAirfoil make_airfoil(const FoundPolars& polars, const std::string& name,
                          const std::string& from) {
  FoundAirfoil made{{}, write_table(polars, from), from};
  made.airfoil = air::parse_airfoil(made.table, from, name);
  return made;
}

std::string choose_airfoil_name(const std::string& wish,
                                const std::vector<FoundAirfoil>& airfoils) {
  constexpr std::size_t longest = 56;  // of 64, a number may follow
  std::string name = wish.substr(0, longest);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) {
        return !(std::isalnum(c) || c == '_' || c == '-' || c == '.') || c > '~';
      },
      '_');
  if (name.empty() || name.front() == '.') name = "airfoil" + name;
  std::string own = name;
  for (int number = 2; is_taken(own, airfoils); ++number) own = name + '_' + std::to_string(number);
  return own;
}

}  // namespace spoke::foreign
