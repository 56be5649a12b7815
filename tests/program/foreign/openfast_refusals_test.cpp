// Faults of OpenFAST's main file and of the modules that it names.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "models/error.h"
#include "tests/program/foreign/samples.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr const char* kMainFile = "small_turbine.fst";
constexpr const char* kPrimaryFile = "small_turbine_ElastoDyn.dat";
constexpr const char* kServoFile = "small_turbine_ServoDyn.dat";
constexpr const char* kInflowFile = "small_turbine_InflowWind.dat";
constexpr const char* kAirFile = "small_turbine_AeroDyn.dat";
constexpr const char* kWindFile = "small_turbine_wind.txt";

/// Imports the turbine with a file that is another one; returns the message, empty if it is taken.
/// Requires that a message is one line on a file, with what was expected.
std::string import_spoiled(const std::string& name, const std::string& text) {
  Texts texts = samples();
  texts[name] = text;
  foreign::ImportOptions options;
  options.is_there = [](const std::string&) { return true; };
  try {
    import_texts(texts, {kMainFile}, options);
    return {};
  } catch (const InputError& error) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find("expected") != std::string::npos);
    CHECK(message.starts_with("small_"));
    CHECK(texts.contains(error.place().file));
    return message;
  }
}

/// Returns a line with another first word.
std::string with_value(const std::string& line, const std::string& value) {
  return value + line.substr(std::min(line.find_first_of(" \t"), line.size()));
}

}  // namespace

TEST_CASE("faults of a main file are refused") {
  const std::string good = samples().at(kMainFile);
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  check_refused(
      kMainFile, {kMainFile},
      {{up_to_line(good, 5),
        ":5: the file ends here, expected a line of a value and then \"TMax\""},
       {with("20            TMax", "-20 TMax"), ":6: TMax is -20, expected more than 0"},
       {with("20            TMax", "long TMax"), ":6: found \"long\", expected a number of TMax"},
       {with("0.005         DT ", "0 DT "), ":7: DT is 0, expected more than 0"},
       {with("0.05          DT_Out", "0 DT_Out"), "DT_Out is 0, expected more than 0"},
       {with("1             CompElast", "3 CompElast"),
        ":10: CompElast is 3, expected 1, ElastoDyn, or 2"},
       {with("1             CompElast", "0 CompElast"),
        ":10: CompElast is \"0\", expected a whole"},
       {with("1             CompInflow", "5 CompInflow"), ":11: CompInflow is \"5\""},
       {with("2             CompAero", "1 CompAero"), ":12: CompAero is 1, expected 0, none, or 2"},
       {with("1             CompServo", "2 CompServo"), ":13: CompServo is \"2\""},
       {with("0             MHK", "1 MHK"), ":18: MHK is 1, expected 0: a turbine in water"},
       {with("9.81          Gravity", "-9.81 Gravity"),
        ":20: Gravity is -9.81, expected 0 or more"},
       {with("1.21          AirDens", "0 AirDens"), ":21: AirDens is 0, expected more than 0"},
       {with("EDFile ", "ElastoFile "), "expected a line of a value and then \"EDFile\""},
       {with("\"small_turbine_ElastoDyn.dat\"", "\"none.dat\""),
        ":24: names a file that cannot be read: none.dat"},
       {with("\"small_turbine_ServoDyn.dat\"", "\"\""), ":30: names no file, expected one of"},
       {with("ServoFile ", "ServFile "), "expected a line of a value and then \"ServoFile\""},
       {good + "True MirrorRotor - Rotor turns the other way\n", "MirrorRotor is True, expected"}});
}

TEST_CASE("a file of another kind than the one that is named is refused") {
  const std::string message = import_spoiled(
      kMainFile, replaced(samples().at(kMainFile), kServoFile, "small_turbine_AeroDyn.dat"));
  CHECK(message ==
        "small_turbine_AeroDyn.dat:1: is of the kind \"AeroDyn, primary file\", expected "
        "\"ServoDyn\", as which small_turbine.fst:30 names it");
}

TEST_CASE("faults of ServoDyn's file are refused") {
  const std::string good = samples().at(kServoFile);
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  check_refused(
      kServoFile, {kMainFile},
      {{with("0             PCMode", "6 PCMode"), ":7: PCMode is \"6\", expected a whole number"},
       {with("1             VSContrl", "1.5 VSContrl"), "VSContrl is \"1.5\""},
       {with("600           VS_RtGnSp", "0 VS_RtGnSp"), "VS_RtGnSp is 0, expected more than 0"},
       {with("6000          VS_RtTq", "-1 VS_RtTq"), "VS_RtTq is -1, expected more than 0"},
       {with("0.013         VS_Rgn2K", "0.02 VS_Rgn2K"),
        "VS_Rgn2K is 0.02, expected no more than VS_RtTq by VS_RtGnSp squared, 0.01666"},
       {with("8             VS_SlPc", "-8 VS_SlPc"), "VS_SlPc is -8, expected 0 or more"},
       {with("4.0           PitManRat(1)", "0 PitManRat(1)"), "PitManRat(1) is 0, expected"},
       {with("3.0E+07       YawSpr", "-1 YawSpr"), "YawSpr is -1, expected 0 or more"},
       {with("YawDamp ", "YawDmp "), "expected a line of a value and then \"YawDamp\""}});
  const auto old_generator = [&](std::string_view from, std::string_view to, int kind) {
    std::string text = replaced(good, "1             VSContrl", "0 VSContrl");
    text = replaced(text, "1             GenModel", std::to_string(kind) + " GenModel");
    return replaced(text, from, to);
  };
  check_refused(kServoFile, {kMainFile},
                {{old_generator("1.5           SIG_SlPc", "0 SIG_SlPc", 1), "SIG_SlPc is 0"},
                 {old_generator("2.0           SIG_PORt", "x SIG_PORt", 1), "SIG_PORt"},
                 {old_generator("10            TEC_NPol", "1 TEC_NPol", 2), "TEC_NPol is \"1\""},
                 {old_generator("690           TEC_VLL", "0 TEC_VLL", 2), "TEC_VLL is 0"},
                 {old_generator("8             VS_SlPc", "8 VS_SlPc", 4), "GenModel is \"4\""}});
}

TEST_CASE("faults of InflowWind's file and of a uniform wind are refused") {
  const std::string good = samples().at(kInflowFile);
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  const std::string steady = with("2             WindType", "1 WindType");
  const std::string box =
      replaced(with("2             WindType", "3 WindType"), "\"unused\"", "\"none.bts\"");
  check_refused(
      kInflowFile, {kMainFile},
      {{with("2             WindType", "4 WindType"), ":5: WindType is 4, expected 1, steady, 2"},
       {with("0             VFlowAng", "90 VFlowAng"), ":7: VFlowAng is 90, expected an angle"},
       {replaced(steady, "9.0           HWindSpeed", "-9 HWindSpeed"), ":10: HWindSpeed is -9"},
       {replaced(steady, "26.0          RefHt ", "0 RefHt "), ":11: RefHt is 0, expected more"},
       {replaced(steady, "0.2           PLExp", "1.2 PLExp"), ":12: PLExp is 1.2, expected"},
       {with("40.0          RefLength", "0 RefLength"), "RefLength is 0, expected more than 0"},
       {box, ":18: FileName_BTS is \"none.bts\", but there is no file none.bts, expected a file"},
       {replaced(box, "0             VFlowAng", "3 VFlowAng"),
        "VFlowAng is not 0, expected 0 with a file of TurbSim"}});
  const std::string wind = samples().at(kWindFile);
  check_refused(
      kWindFile, {kMainFile},
      {{up_to_line(wind, 3), ":3: the file ends here, expected rows of time and wind"},
       {with_line(wind, 5, "0 8 0 0 0 0.14 0 0"), ":5: time is 0, expected more than in the row"},
       {with_line(wind, 5, "10 8 0 0 0 0.14 0"), ":5: has 7 words, expected 8 numbers"},
       {with_line(wind, 5, "10 -8 0 0 0 0.14 0 0"), ":5: speed with gust is -8, expected 0 or"},
       {with_line(wind, 5, "10 8 0 0 0 1.4 0 0"), ":5: exponent of shear is 1.4, expected"},
       {with_line(wind, 5, "10 fast 0 0 0 0.14 0 0"), ":5: found \"fast\", expected a number"}});
}

TEST_CASE("faults of the tower in the air are refused") {
  const std::string good = samples().at(kAirFile);
  const auto with = [&](std::string_view from, std::string_view to) {
    return replaced(good, from, to);
  };
  check_refused(
      kAirFile, {kMainFile},
      {{with("2             TwrPotent", "3 TwrPotent"), ":7: TwrPotent is \"3\", expected a whole"},
       {with("4             NumTwrNds", "1 NumTwrNds"), "NumTwrNds is \"1\", expected a whole"},
       {with("TwrElev   TwrDiam", "TwrElev   Diam"), "no column TwrDiam, expected TwrElev"},
       {with("10.0      1.8", "0.0      1.8"), "TwrElev is 0, expected more than in the row"},
       {with("10.0      1.8", "10.0      0"), "TwrDiam is 0, expected more than 0"},
       {with("1.8       0.6", "1.8       -0.6"), "TwrCd is -0.6, expected 0 or more"},
       {replaced(replaced(with("0.0       2.0       0.6", "50 2 0.6"), "10.0      1.8", "60 1.8"),
                 "20.0      1.5       0.5     0.1     0.0\n30.0      1.2",
                 "70.0      1.5       0.5     0.1     0.0\n80.0      1.2"),
        "no node is on the tower, expected TwrElev from 1 to 25"}});
}

TEST_CASE("modules that lack another one, and a main file beside an ontology, are refused") {
  const auto message_of_import = [](const std::vector<std::string>& names) {
    try {
      import_texts(samples(), names);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message_of_import({kServoFile, "small_BeamDyn.dat"}) ==
        std::string(kServoFile) +
            ":1: has no rotor to control, expected ElastoDyn's primary file besides");
  CHECK(message_of_import({kInflowFile, kPrimaryFile}) ==
        std::string(kInflowFile) +
            ":1: has no blades for its wind, expected AeroDyn's primary file besides");
  CHECK(message_of_import({kMainFile, "small_windio.yaml"}) ==
        std::string(kMainFile) +
            ":1: given along with small_windio.yaml, expected an ontology by itself");
}

TEST_CASE("whatever line is missing, cut off or spoiled, there is one error or a scenario") {
  int refused = 0, tried = 0;
  for (const char* name : {kMainFile, kPrimaryFile, kServoFile, kInflowFile, kAirFile, kWindFile}) {
    CAPTURE(name);
    const std::string good = samples().at(name);
    const int count = static_cast<int>(std::count(good.begin(), good.end(), '\n'));
    for (int line = 1; line <= count; ++line) {
      CAPTURE(line);
      const std::string whole = up_to_line(good, line);
      const std::size_t begin = whole.rfind('\n', whole.size() - 2) + 1;
      const std::string text = whole.substr(begin, whole.size() - 1 - begin);
      std::vector<std::string> spoiled = {without_line(good, line), up_to_line(good, line)};
      for (const char* value : {"x", "-7", "0", "1e40", "1e29", "\"", "9999999999", "True"})
        spoiled.push_back(with_line(good, line, with_value(text, value)));
      for (const std::string& bad : spoiled) {
        ++tried;
        if (!import_spoiled(name, bad).empty()) ++refused;
      }
    }
  }
  CHECK(tried > 2000);
  CHECK(refused > tried / 4);
}
