#include "bench/reproduce/claims.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/approx.h"
#include "tests/bench/reproduce/samples.h"

using namespace spoke;
using namespace spoke::reproduce;
using spoke::testing::approx;

namespace {

const Claim& find(const std::vector<Claim>& claims, const std::string& what) {
  for (const Claim& claim : claims)
    if (claim.what.starts_with(what)) return claim;
  FAIL("no claim: " << what);
  return claims.front();
}

/// The methods of Table 3, and Spoke's own [us].
Reproduction methods(double conventional, double parallel) {
  return reproduction_of(Work::steps, {{serial(Formulation::augmented), conventional * 1e-6},
                                       {serial(Formulation::subsystem), 100e-6},
                                       {scheme(1, 3), parallel * 1e-6},
                                       {scheme(1, {3, 2}), 25e-6},
                                       {serial(Formulation::structured), 20e-6},
                                       {automatic(Formulation::structured), 12e-6}});
}

/// Scheme 1 on 3x2 threads in four rounds; its 3x1 takes 50 us.
Reproduction layers(const std::vector<double>& microseconds) {
  std::vector<double> times;
  for (const double time : microseconds) times.push_back(time * 1e-6);
  return reproduction_of_rounds(
      Work::steps, {{scheme(1, {3, 1}), {50e-6, 50e-6, 50e-6, 50e-6}}, {scheme(1, {3, 2}), times}});
}

std::optional<bool> inner_threads_gain(const Reproduction& all) {
  return find(claims_on_layers(all), "scheme 1, 3x2 / 3x1").holds;
}

}  // namespace

TEST_CASE("claims on counts: the total is as printed, the inverse is not that of a blade") {
  const auto claims = claims_on_counts();
  CHECK(find(claims, "total").holds == true);
  CHECK(*find(claims, "total").here == 7790118.0);
  CHECK(find(claims, "inverse of M_sub").holds == false);
  CHECK(*find(claims, "inverse of M_sub").here == 3 * 60.0 * 60.0 * 60.0 / 3.0);
  CHECK(*find(claims, "the same, twelve blocks").here == 12 * 15.0 * 15.0 * 15.0 / 3.0);
}

TEST_CASE("claims on methods: the paper's ratio and ours, and whether it holds") {
  const auto good = claims_on_methods(methods(360, 40));
  const Claim& algorithm = find(good, "conventional / subsystem");
  CHECK(*algorithm.paper == approx(17.92 / 4.93));
  CHECK(*algorithm.here == approx(3.6));
  CHECK(algorithm.holds == true);
  CHECK(*find(good, "structured, auto / serial").here == approx(0.6));
  CHECK_FALSE(find(good, "structured, auto / serial").holds);
  const auto bad = claims_on_methods(methods(140, 60));
  CHECK(find(bad, "conventional / subsystem").holds == false);
  if (!has_schemes()) return;
  CHECK(find(good, "subsystem / parallel").holds == true);
  CHECK(*find(good, "subsystem / parallel").here == approx(2.5));
  CHECK(find(bad, "subsystem / parallel").holds == false);
}

TEST_CASE("claims on threads hold, do not, or are open where rounds disagree or are few") {
  if (!has_schemes()) return;
  CHECK(inner_threads_gain(layers({30, 31, 32, 30})) == true);
  CHECK(inner_threads_gain(layers({55, 56, 57, 55})) == false);
  CHECK_FALSE(inner_threads_gain(layers({30, 90, 30, 90})));
  CHECK_FALSE(inner_threads_gain(layers({30, 30})));  // no quartiles
  CHECK_FALSE(inner_threads_gain(layers({})));
}

TEST_CASE("claims on threads are open on a busy machine, those on one thread are not") {
  Reproduction all = methods(360, 40);
  all.loads.before = 1.1;  // more than half of two processors
  const auto claims = claims_on_methods(all);
  CHECK(find(claims, "conventional / subsystem").holds == true);
  if (has_schemes()) CHECK_FALSE(find(claims, "subsystem / parallel").holds);
}

TEST_CASE("two schemes that are alike, and two that are not") {
  if (!has_schemes()) return;
  const auto alike = [](double two) {
    return find(claims_on_subsystem_threads(reproduction_of(
                    Work::steps, {{scheme(1, 2), 50e-6}, {scheme(2, 2), two * 1e-6}})),
                "scheme 1 / scheme 2")
        .holds;
  };
  CHECK(alike(52) == true);
  CHECK(alike(80) == false);
  CHECK(alike(30) == false);
}

TEST_CASE("claims on the inverse part: its share, and whether it falls with inner threads") {
  Reproduction all =
      reproduction_of(Work::inverse, {{scheme(1, {3, 1}), 50e-6}, {scheme(1, {3, 4}), 25e-6}});
  all.inverse_share = 0.621;
  CHECK(*find(claims_on_inverse(all), "inverse nodes, share").here == 0.621);
  if (has_schemes()) CHECK(find(claims_on_inverse(all), "scheme 1, 3x4 / 3x1").holds == true);
}

TEST_CASE("a table of claims has a row each, with what is not there left open") {
  using Cells = std::vector<std::string>;
  const report::Table table = claim_table(
      {{"a", 2.0, 1.5, Ratio{1.4, 1.5, 1.6, 3}, {Condition::Kind::above, 1.0, 0.0}, true},
       {"b", 1.0, {}, {}, {Condition::Kind::below, 0.0, 0.97}, {}},
       {"c", {}, 0.0014, {}, {}, {}}});
  REQUIRE(table.rows.size() == 3);
  for (const report::Row& row : table.rows) CHECK(row.cells.size() == table.columns.size());
  CHECK(table.rows[0].cells == Cells{"a", "2.00", "1.50", "1.40 to 1.60", "0.75", "> 1.00", "yes"});
  CHECK(table.rows[1].cells == Cells{"b", "1.00", "-", "", "-", "< 0.970", "open"});
  CHECK(table.rows[2].cells[2] == "0.00140");  // never 0.00
}
