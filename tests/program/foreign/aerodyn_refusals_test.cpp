// Files of AeroDyn with faults: each is refused with file, line and what was expected.

#include <doctest/doctest.h>

#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kAirPrimary = "small_AeroDyn.dat";
constexpr const char* kAirNodes = "small_AeroDyn_blade.dat";
constexpr const char* kAirThin = "small_AeroDyn_polar_thin.dat";
constexpr const char* kBeam = "small_BeamDyn.dat";

}  // namespace

TEST_CASE("faults of AeroDyn's primary file are refused") {
  const std::string good = samples().at(kAirPrimary);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  const std::string blade = "ADBlFile(1) - Blade file (quoted string)";
  check_refused(
      kAirPrimary, {kBeam, kAirPrimary},
      {{up_to_line(good, 1), ":1: the file ends here, expected a title"},
       {up_to_line(good, 5), "the file ends here, expected a line of a value and then \"WakeMod\""},
       {with(6, "4 WakeMod"), ":6: WakeMod is \"4\", expected a whole number from 0 to 3"},
       {with(6, "9 WakeMod"), "expected a whole number from 0 to 3, or from 10 to 12"},
       {with(6, "13 WakeMod"), ":6: WakeMod is \"13\", expected a whole number"},
       {with(6, "11 Wake_Mod\n0 UA_Mod"), ":6: Wake_Mod is \"11\""},
       {with(6, "BEMT WakeMod"), ":6: WakeMod is \"BEMT\""},
       {with(7, "0 AFAeroMod"), ":7: AFAeroMod is \"0\", expected a whole number from 1 to 2"},
       {with(7, ""), "a value and then \"AFAeroMod\""},
       {with(6, "1 Wake_Mod"), "a value and then \"UA_Mod\""},
       {with(6, "1 Wake_Mod\n7 DBEMT_Mod\n0 UA_Mod"), ":7: DBEMT_Mod is \"7\""},
       {with(10, "0 AirDens"), ":10: AirDens is 0, expected more than 0"},
       {with(10, "thick AirDens"), ":10: found \"thick\", expected a number of AirDens"},
       {with(11, "-1e-5 KinVisc"), ":11: KinVisc is -"},
       {without_line(good, 11), "a value and then \"KinVisc\""},
       {with(14, "maybe TipLoss"), ":14: TipLoss is \"maybe\", expected True or False"},
       {with(18, "4 AFTabMod"), ":18: AFTabMod is \"4\""},
       {with(19, "2 InCol_Alfa"), ":19: InCol_Alfa is 2, expected 1"},
       {with(20, "5 InCol_Cl"), ":20: InCol_Cl is 5, expected 2"},
       {with(21, "0 InCol_Cd"), ":21: InCol_Cd is 0, expected 3"},
       {with(22, "6 InCol_Cm"), ":22: InCol_Cm is 6, expected 4"},
       {with(24, "0 NumAFfiles"), ":24: NumAFfiles is \"0\", expected a whole number from 1"},
       {with(24, "9 NumAFfiles"), ":29: found a headline, expected the name of aerofoil file 5"},
       {with(25, "\"none.dat\" AFNames"), ":25: names a file that cannot be read: none.dat"},
       {with(25, "\"\" AFNames"), ":25: names no file, expected an aerofoil file"},
       {without_line(good, 25), "a value and then \"AFNames\""},
       {up_to_line(good, 27), ":27: the file ends here, expected the name of aerofoil file 4 of 4"},
       {with(30, "Yes UseBlCm"), ":30: UseBlCm is \"Yes\", expected True or False"},
       {with(31, "\"none.dat\" " + blade), ":31: names a file that cannot be read: none.dat"},
       {with(31, ""), "names no file, expected one of the kind \"AeroDyn, blade file\""}});
}

TEST_CASE("faults of AeroDyn's blade file are refused") {
  const std::string good = samples().at(kAirNodes);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  check_refused(
      kAirNodes, {kBeam, kAirPrimary},
      {{up_to_line(good, 2), ":2: the file ends here, expected the headline BLADE PROPERTIES"},
       {with(4, "1 NumBlNds"), ":4: NumBlNds is \"1\", expected a whole number from 2"},
       {with(4, "9 NumBlNds"), ":14: the file ends here, expected row 9 of the table"},
       {with(4, "8 Nodes"), ":4: found \"8 Nodes\", expected a line of a value and then"},
       {with(5, "BlSpn BlCrvAC BlSwpAC BlCrvAng BlTwist BlChord"), ":5: no column BlAFID"},
       {with(7, "-1 0 0 0 12 1 1"), ":7: BlSpn is -1, expected 0 or more"},
       {with(8, "0 0 0 0 12 1 1"), ":8: BlSpn is 0, expected more than in the row before, 0"},
       {with(8, "1.5 0 0 0 12 -1 1"), ":8: BlChord is -1, expected 0 or more"},
       {with(8, "1.5 0 0 0 12 1 0"), ":8: BlAFID is 0, expected a whole number from 1 to NumAFf"},
       {with(8, "1.5 0 0 0 12 1 5"), ":8: BlAFID is 5"},
       {with(8, "1.5 0 0 0 12 1 1.5"), ":8: BlAFID is 1.5"},
       {with(8, "1.5 0 0 0 12 1"), ":8: has 6 words, expected 7 numbers: row 2 of the table"},
       {with(8, "1.5 0 0 0 much 1 1"), ":8: found \"much\", expected a number of row 2"},
       {with(8, "1.5 0 0 0 1e31 1 1"), ":8: found \"1e31\", expected a number of at most 1e30"},
       {with(14, "20.1 0 0 0 0 1 3"),
        ":14: BlSpn is 20.1, expected at most the blade's length, 20"},
       {with(13, "20.0001 0 0 0 0 1 3"), ":14: BlSpn is 20, expected more than in the row before"},
       {samples().at("small_BeamDyn_blade.dat"), ":1: is of the kind \"BeamDyn, blade file\""}});
  const std::string twice = with_line(with(13, "20.0001 0 0 0 0 1 3"), 14, "20.0002 0 0 0 0 1 3");
  check_refused(kAirNodes, {kBeam, kAirPrimary},
                {{twice, ":14: BlSpn is beyond the blade's tip, expected one node there"}});
}

TEST_CASE("faults of AeroDyn's aerofoils are refused") {
  const std::string good = samples().at(kAirThin);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  check_refused(kAirThin, {kBeam, kAirPrimary},
                {{"", ":1: is no aerofoil file of AeroDyn 15, expected a line of a value and then"},
                 {with(7, "2 Tables"), ":1: is no aerofoil file of AeroDyn 15"},
                 {with(7, "0 NumTabs"), ":7: NumTabs is \"0\""},
                 {with(9, "0 Re"), ":9: Re is 0, expected the Reynolds number in millions"},
                 {with(12, "2 NumAlf"), ":12: NumAlf is \"2\""},
                 {with(12, "12 NumAlf"), "expected 180 in the last row"},
                 {with(12, "14 NumAlf"), ":29: is \"Re\", expected a lift coefficient"},
                 {with(15, "-175 0 0.02 0"), ":15: angle of attack is -175 degrees, expected -180"},
                 {with(16, "-135 lift 0.9 0.4"), ":16: is \"lift\", expected"},
                 {with(16, "-135 0.6 -0.9 0.4"), ":16: drag is -0.9, expected 0 to 100"},
                 {up_to_line(good, 27), "the file ends here, expected a line of a value and Re"}});
}

TEST_CASE("files of AeroDyn need others") {
  check_refused(
      kAirPrimary, {kAirPrimary},
      {{samples().at(kAirPrimary), ":1: has no structure of the blades, expected files"}});
  check_refused(kAirPrimary, {"small_ElastoDyn_tower.dat", kAirPrimary},
                {{samples().at(kAirPrimary), ":1: has no structure of the blades"}},
                {.tower_height = 3.0});
  check_refused(kAirNodes, {kBeam, kAirNodes},
                {{samples().at(kAirNodes), ":1: has no names of aerofoils, expected AeroDyn's"}});
  check_refused(kAirPrimary, {kBeam, kAirPrimary, kAirPrimary},
                {{samples().at(kAirPrimary), ":1: is a second file of the kind"}});
}
