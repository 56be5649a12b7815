// Files of BeamDyn with faults: each is refused with file, line and what was expected.

#include <doctest/doctest.h>

#include "models/error.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kPrimary = "small_BeamDyn.dat";
constexpr const char* kBlade = "small_BeamDyn_blade.dat";

}  // namespace

TEST_CASE("faults of BeamDyn's primary file are refused with file, line and what was expected") {
  const std::string good = samples().at(kPrimary);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  check_refused(
      kPrimary, {kPrimary},
      {{"", ":1: found \"\", expected the first line of a file of OpenFAST"},
       {"title = \"a scenario\"\n", ":1: found \"title = "},
       {with(1, "------- HYDRODYN INPUT FILE -------"), ":1: found \"------- HYDRODYN"},
       {std::string("\x7f\x45LF\0\1\2\xff", 8), ":1: found \"?ELF"},
       {up_to_line(good, 1), ":1: the file ends here, expected a title"},
       {up_to_line(good, 18),
        ":18: the file ends here, expected a line of a value and then "
        "\"member_total\""},
       {with(20, " two member_total"), ":20: member_total is \"two\", expected a whole number"},
       {with(20, " 0 member_total"), ":20: member_total is \"0\", expected a whole number from 1"},
       {with(20, " 1.5 member_total"), ":20: member_total is \"1.5\""},
       {without_line(good, 20), "expected a line of a value and then \"member_total\""},
       {without_line(good, 21), ":21: found \"1      7 "},
       {with(21, " 2 kp_total"), ":21: kp_total is \"2\", expected a whole number from 3"},
       {with(21, " 1e9 kp_total"), ":21: kp_total is \"1e9\""},
       {with(22, " 2 7"), ":22: member number is 2, expected 1"},
       {with(22, " 1 2"), ":22: member 1 has 2 key points, expected a whole number from 3"},
       {with(22, " 1 6"), ":22: the members have 6 key points, expected kp_total, 7"},
       {with(22, " 1"), ":22: has 1 words, expected 2 numbers: the number of member 1"},
       {with(25, " 0 0 0.5 12"), ":25: key point 1 is not at the root"},
       {with(25, " 0.1 0 0 12"), ":25: key point 1 is not at the root"},
       {with(26, " -0.02 0.01 2.5"), ":26: has 3 words, expected 4 numbers: kp_xr"},
       {with(26, " -0.02 0.01 2.5 twelve"), ":26: found \"twelve\", expected a number"},
       {with(26, " -0.02 0.01 2.5 NaN"), ":26: found \"NaN\", expected a number"},
       {with(26, " -0.02 0.01 2.5 1e400"), ":26: found \"1e400\", expected a number"},
       {with(26, " -0.02 0.01 2.5 1e31"), ":26: found \"1e31\", expected a number of at most"},
       {with(27, " -0.11 0.04 2.5 8.1"),
        ":27: kp_zr is 2.5, expected more than that of the key "
        "point before, 2.5"},
       {with(27, " -0.11 0.04 1.0 8.1"), ":27: kp_zr is 1, expected more"},
       {without_line(good, 28), ":31: found \"----------------------\""},
       {up_to_line(good, 28), ":28: the file ends here, expected kp_xr, kp_yr, kp_zr"},
       {without_line(good, 35),
        "the file ends here, expected a line of a value and then "
        "\"BldFile\""},
       {with(35, "\"\" BldFile"), ":35: names no file"},
       {with(35, "\"none.dat\" BldFile"), ":35: names a file that cannot be read: none.dat"}});
}

TEST_CASE("faults of BeamDyn's blade file are refused with file, line and what was expected") {
  const std::string good = samples().at(kBlade);
  const auto with = [&](int line, const std::string& text) { return with_line(good, line, text); };
  const std::string zeros = " 0 0 0 0 0";
  check_refused(
      kBlade, {kPrimary, kBlade},
      {{up_to_line(good, 3),
        ":3: the file ends here, expected a line of a value and then "
        "\"station_total\""},
       {without_line(good, 3), ":4: found \"1   damp_type"},
       {without_line(good, 4), ":4: found \"1   damp_type"},
       {with(4, "1 station_total"), ":4: station_total is \"1\", expected a whole number from 2"},
       {with(4, "-7 station_total"), ":4: station_total is \"-7\""},
       {with(4, "8 station_total"), "the file ends here, expected eta of section 8"},
       {with(4, "6 station_total"), "eta of the last section is 0.875, expected 1, the tip"},
       {with(5, "2 damp_type"), ":5: damp_type is \"2\", expected a whole number from 0 to 1"},
       {with(5, "yes damp_type"), ":5: damp_type is \"yes\""},
       {without_line(good, 5), ":5: found "},
       {with(9, "1e-3 1e-3 1e-3 1e-3 1e-3"), ":9: has 5 words, expected 6 numbers: mu1 to mu6"},
       {with(9, "1e-3 1e-3 -1e-3 1e-3 1e-3 1e-3"), ":9: mu is -0.001, expected six numbers"},
       {without_line(good, 8), ":9: has 3 words, expected 6 numbers: mu1 to mu6"},
       {with(11, "0.01"), ":11: eta of the first section is 0.01, expected 0"},
       {with(26, "0"), ":26: eta of section 2 is 0, expected more than that of the one before, 0"},
       {with(26, "1.1"), ":41: eta of section 3 is 0.3, expected more"},
       {with(12, "4.3E7 3.2E6 0 0 0"),
        ":12: has 5 words, expected 6 numbers: row 1 of the "
        "stiffness matrix of section 1"},
       {with(13, "3.2E6 9.6E7 0 O 0 0"), ":13: found \"O\", expected a number of row 2"},
       {without_line(good, 14), ":12: stiffness matrix of section 1 has 0 in row 5"},
       {with(12, "-4.3E7" + zeros),
        ":12: stiffness matrix of section 1 has -43000000 in row 1, "
        "column 1, expected more than 0"},
       {with(12, "0" + zeros), ":12: stiffness matrix of section 1 has 0 in row 1"},
       {with(12, "4.3E7 9E6 0 0 0 4.8E5"),
        ":12: stiffness matrix of section 1 is not symmetric: "
        "row 1, column 2 is 9000000, the other is 3212476"},
       {with_line(with(12, "4.3E7 9E7 0 0 0 4.830745E5"), 13, "9E7 9.6E7 0 0 0 -4.811985E5"),
        ":12: stiffness matrix of section 1 is not positive definite"},
       {with(19, "68 0 0 0 0"), ":19: has 5 words, expected 6 numbers: row 1 of the mass matrix"},
       {with(19, "70 0 0 0 0 2.72"),
        ":19: mass matrix of section 1 has 70 in row 1, column 1, "
        "expected the mass per length of row 3, 68"},
       {with(22, "0 0 -2.72 -6 0 0"), ":19: mass matrix of section 1 has -6 in row 4"},
       {with(24, "2.72 0.544 0 0 0 9"),
        ":19: mass matrix of section 1 has 9 in row 6, column 6, "
        "expected the sum"},
       {with_line(with(19, "68 3 0 0 0 2.72"), 20, "3 68 0 0 0 0.544"), "couples translations"},
       {with_line(with(19, "68 0 0 0 0 -2.72"), 24, "-2.72 0.544 0 0 0 7.865152"),
        ":19: mass matrix of section 1 is not that of a slice"},
       {up_to_line(good, 60), ":60: the file ends here"},
       {with(5, "2 damp_type\n - \n - \n - \n 1 1 1 1 1 1\n - \n 2 n_modes\n 0.1 1.5"),
        ":12: zeta is 1.5, expected ratios"},
       {with(5, "2 damp_type\n - \n - \n - \n 1 1 1 1 1 1\n - \n 0 n_modes"),
        ":11: n_modes is \"0\", expected a whole number from 1"},
       {with(5, "2 damp_type\n - \n - \n - \n 1 1 1 1 1 1\n - \n 3 n_modes\n 0.1 0.2"),
        ":12: has 2 words, expected 3 numbers: zeta"},
       {samples().at(kPrimary), "expected one; the first is small_BeamDyn.dat"}});
}

TEST_CASE("a blade file alone, a blade twice and files of another kind than named are refused") {
  check_refused(kBlade, {kBlade},
                {{samples().at(kBlade), ":1: has no key points, expected BeamDyn's primary file"}});
  check_refused("small_ElastoDyn_blade.dat", {kPrimary, "small_ElastoDyn_blade.dat"},
                {{samples().at("small_ElastoDyn_blade.dat"),
                  ":1: is a second description of a blade, expected one; the first is " +
                      std::string(kPrimary)}},
                {.blade_length = 3.0});
  check_refused(kBlade, {kPrimary},
                {{samples().at("small_ElastoDyn_tower.dat"),
                  ":1: is of the kind \"ElastoDyn, tower file\", expected \"BeamDyn, blade file\", "
                  "as which small_BeamDyn.dat:35 names it"}});
}
