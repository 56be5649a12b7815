// Files of ElastoDyn with faults: each is refused with file, line and what was expected.

#include <doctest/doctest.h>

#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kTurbine = "small_ElastoDyn.dat";
constexpr const char* kTurbineBlade = "small_ElastoDyn_blade.dat";
constexpr const char* kTower = "small_ElastoDyn_tower.dat";

}  // namespace

TEST_CASE("faults of ElastoDyn's primary file are refused") {
  const std::string good = samples().at(kTurbine);
  check_refused(
      kTurbine, {kTurbine},
      {{up_to_line(good, 1), ":1: the file ends here, expected a title"},
       {up_to_line(good, 20), "the file ends here, expected a line of a value and then"},
       {replaced(good, "3             NumBl", "0 NumBl"),
        ":14: NumBl is \"0\", expected a whole "
        "number from 1"},
       {replaced(good, "3             NumBl", "three NumBl"), ":14: NumBl is \"three\""},
       {replaced(good, "HubRad ", "HubRadius "), "a value and then \"HubRad\""},
       {replaced(good, "1.0           HubRad", "-1.0 HubRad"), ":16: HubRad is -1, expected 0 or"},
       {replaced(good, "1.0           HubRad", "20.0 HubRad"),
        ":15: TipRad is 19.5, expected more "
        "than HubRad, 20"},
       {replaced(good, "19.5          TipRad", "far TipRad"),
        ":15: found \"far\", expected a "
        "number of TipRad"},
       {replaced(good, "25.0          TowerHt", "0.5 TowerHt"),
        ":27: TowerHt is 0.5, expected "
        "more than TowerBsHt, 1"},
       {replaced(good, "9000          NacMass", "0 NacMass"), "NacMass is 0, expected more than 0"},
       {replaced(good, "14000         NacYIner", "140 NacYIner"),
        "NacYIner is 140, expected more "
        "than NacMass times"},
       {replaced(good, "5.0           TipMass(1)", "-5.0 TipMass(1)"),
        "TipMass(1) is -5, expected"},
       {replaced(good, "2000          HubMass", "-1 HubMass"), "HubMass is -1, expected 0 or more"},
       {replaced(good, "-4.0          ShftTilt", "x ShftTilt"), ":22: found \"x\""},
       {replaced(good, "BldFile1 ", "BladeFile "), "names no file"},
       {replaced(good, "\"small_ElastoDyn_tower.dat\"", "\"tower.dat\""),
        ":47: names a file that "
        "cannot be read"}});
}

TEST_CASE("faults of ElastoDyn's blade file are refused") {
  const std::string good = samples().at(kTurbineBlade);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  check_refused(
      kTurbineBlade, {kTurbineBlade},
      {{up_to_line(good, 4), ":4: the file ends here"},
       {with(4, "1 NBlInpSt"), ":4: NBlInpSt is \"1\", expected a whole number from 2"},
       {without_line(good, 4), ":4: found \"0.5 "},
       {with(4, "6 NBlInpSt"), ":22: has 5 words, expected 6 numbers: row 6"},
       {with(4, "4 NBlInpSt"), ":20: BlFract is 0.8, expected 1 in the last row"},
       {with(5, "-0.5 BldFlDmp1"), ":5: BldFlDmp1 is -0.5, expected 0 or more and less than 100"},
       {with(5, "100 BldFlDmp1"), ":5: BldFlDmp1 is 100"},
       {with(11, "0 AdjBlMs"), ":11: AdjBlMs is 0, expected more than 0"},
       {without_line(good, 12), "a value and then \"AdjFlSt\""},
       {with(15, "BlFract StrcTwst BMassDen FlpStff"), ":15: no column EdgStff, expected BlFract"},
       {with(17, "0.1 .25 11 70 1.8e7 5e7"), ":17: BlFract is 0.1, expected 0 in the first row"},
       {with(18, "0 .25 11 70 1.8e7 5e7"), ":18: BlFract is 0, expected more than in the row"},
       {with(18, "0.2 .25 11 -70 1.8e7 5e7"), ":18: BMassDen is -70, expected more than 0"},
       {with(18, "0.2 .25 11 70 0 5e7"), ":18: FlpStff is 0, expected more than 0"},
       {with(18, "0.2 .25 11 70 1.8e7"), ":18: has 5 words, expected 6 numbers: row 2"},
       {with(18, "0.2 .25 11 70 1.8e7 stiff"), ":18: found \"stiff\", expected a number of row 2"},
       {up_to_line(good, 19), ":19: the file ends here, expected row 4 of the table"},
       {with(18, "1e-320 .25 11 70 1.8e7 5e7"),
        ":18: BlFract is 1e-320, expected more than in the row before"}},
      {.blade_length = 18.5});
  check_refused(kTurbineBlade, {kTurbineBlade},
                {{good, ":1: does not say how long it is, expected --length"}});
}

TEST_CASE("faults of ElastoDyn's tower file are refused") {
  const std::string good = samples().at(kTower);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  check_refused(
      kTower, {kTower},
      {{with(4, "four NTwInpSt"), ":4: NTwInpSt is \"four\""},
       {with(5, "-1 TwrFADmp(1)"), ":5: TwrFADmp(1) is -1"},
       {without_line(good, 6), "a value and then \"TwrFADmp2\""},
       {with(14, "-1 AdjTwMa"), ":14: AdjTwMa is -1, expected more than 0"},
       {with(18, "HtFract TMassDen TwFAStif"), ":18: no column TwSSStif"},
       {with(21, "0.3 1000 7e9 0"), ":21: TwSSStif is 0, expected more than 0"},
       {with(23, "0.9 650 2.5e9 2.4e9"), ":23: HtFract is 0.9, expected 1 in the last row"},
       {up_to_line(good, 21), ":21: the file ends here, expected row 3"}},
      {.tower_height = 24.0});
  check_refused(kTower, {kTower}, {{good, ":1: does not say how long it is, expected --height"}});
  check_refused(kTower, {kTower}, {{good, "makes a scenario that is refused"}},
                {.tower_height = 1e-20});
}
