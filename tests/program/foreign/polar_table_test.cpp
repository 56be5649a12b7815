// Sums of polars against those of their values, and the tables they are written as.

#include "program/foreign/polar_table.h"

#include <doctest/doctest.h>

#include <cmath>

#include "models/air/airfoil_reader.h"
#include "models/air/section_polar.h"
#include "tests/contains.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;
using foreign::FoundPolar;
using foreign::FoundPolars;

namespace {

FoundPolars thick_polars() {
  FoundPolar polar;
  polar.reynolds = 3e6;
  polar.angle = {-180, -30, -5, 10, 40, 180};
  polar.lift = {0, -0.8, -0.3, 1.1, 0.7, 0};
  polar.drag = {0.1, 0.5, 0.02, 0.03, 0.9, 0.1};
  return {polar};
}

FoundPolars thin_polars() {
  FoundPolar low;
  low.reynolds = 1e6;
  low.angle = {-180, -12, 0, 12, 180};
  low.lift = {0, -1.0, 0.4, 1.3, 0};
  low.drag = {0.05, 0.02, 0.009, 0.03, 0.05};
  low.moment = {0, -0.05, -0.07, -0.06, 0};
  FoundPolar high = low;
  high.reynolds = 8e6;
  high.lift = {0, -1.1, 0.45, 1.5, 0};
  return {low, high};
}

/// The coefficients at an angle [rad] and a Reynolds number, as the engine has them.
air::PolarValues values_of(const FoundPolars& polars, double reynolds, double angle) {
  const spatial::Airfoil airfoil = foreign::make_airfoil(polars, "a", "a").airfoil;
  const air::SectionPolar section(airfoil, airfoil, 0.0);
  return section.values(section.level(reynolds), angle);
}

}  // namespace

TEST_CASE("a sum of polars has the sums of their coefficients everywhere") {
  for (const double share : {0.0, 0.3, 0.75, 1.0}) {
    const FoundPolars mixed = foreign::mix_polars(thick_polars(), thin_polars(), share);
    CHECK(mixed.size() == (share == 0.0 ? 1 : 2));
    for (const double reynolds : {5e5, 1e6, 3e6, 8e6, 2e7})
      for (double angle = -3.1; angle < 3.1; angle += 0.037) {
        const auto found = values_of(mixed, reynolds, angle);
        const auto a = values_of(thick_polars(), reynolds, angle),
                   b = values_of(thin_polars(), reynolds, angle);
        CHECK(std::abs(found.lift - std::lerp(a.lift, b.lift, share)) < 1e-12);
        CHECK(std::abs(found.drag - std::lerp(a.drag, b.drag, share)) < 1e-12);
        CHECK(std::abs(found.moment - std::lerp(a.moment, b.moment, share)) < 1e-12);
      }
  }
}

TEST_CASE("tables of aerofoils are read as they are written") {
  for (const FoundPolars& polars : {thick_polars(), thin_polars()}) {
    const foreign::FoundAirfoil made = foreign::make_airfoil(polars, "wing", "a\nfile");
    CHECK(air::parse_airfoil(made.table, "t", "wing") == made.airfoil);
    CHECK(made.airfoil.polars.size() == polars.size());
    CHECK(contains(made.table, "! Written by spoke import: a?file\n"));
    for (std::size_t i = 0; i < polars[0].angle.size(); ++i)
      CHECK(made.airfoil.polars[0].lift[i] == polars[0].lift[i]);
  }
}

TEST_CASE("names of aerofoils are those that scenarios allow, and their own") {
  std::vector<foreign::FoundAirfoil> all;
  const auto choose = [&](const std::string& wish) {
    const std::string name = foreign::choose_airfoil_name(wish, all);
    all.push_back(foreign::make_airfoil(thick_polars(), name, "test"));
    return name;
  };
  CHECK(choose("DU40 \"A17\"") == "DU40__A17_");
  CHECK(choose("DU40__A17_") == "DU40__A17__2");
  CHECK(choose("du40__a17_") == "du40__a17__3");
  CHECK(choose("") == "airfoil");
  CHECK(choose("..") == "airfoil..");
  CHECK(choose("Fl\xc3\xbcgel") == "Fl__gel");
  CHECK(choose(std::string(100, 'x')).size() <= 64);
}
