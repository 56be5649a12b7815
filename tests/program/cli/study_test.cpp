#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/child.h"
#include "tests/program/cli/refusal.h"
#include "tests/program/cli/study_folder.h"

namespace fs = std::filesystem;
using nlohmann::json;

TEST_CASE("a study writes the same files whatever the number of threads, and page and values fit") {
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const Left one = folder.run({"--out", "one", "--threads", "1"});
  const Left three = folder.run({"--out", "three", "--threads", "3"});
  CHECK(one == three);
  const std::vector<std::string> rows = lines_of(one.at("runs.csv"));
  REQUIRE(rows.size() == 13);
  CHECK(rows[0] ==
        "run,status,blade.length,blade.bodies,blade.density,blade1.tip.y.min,hub.speed.final,"
        "diagnosis");
  CHECK(rows[1].starts_with("1,done,2,1,2700,-"));
  CHECK(rows[12].starts_with("12,done,4,2,1350,-"));
  const json study = json::parse(one.at("study.json"));
  CHECK(study["runs"]["done"] == 12);
  CHECK(study["responses"][0]["unit"] == "m");
  CHECK(study["responses"][1]["main_effects"].size() == 2);
  CHECK(lines_of(one.at("histories.csv")).at(0) == "run,t,hub.angle.history");
  CHECK(lines_of(one.at("histories.csv")).size() == 1 + 12 * 6);
  CHECK(one.at("study.html").find("spoke run rotor.toml --set blade.length=4") !=
        std::string::npos);
}

TEST_CASE("a response is what spoke run measures with the command of the run") {
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const json study = json::parse(folder.run({"--out", "o"}).at("study.json"));
  const auto replay = study["responses"][0]["min"]["replay"].get<std::string>();
  std::vector<std::string> words;
  for (std::size_t at = replay.find(' ') + 1; at != 0; at = replay.find(' ', at) + 1)
    words.push_back(replay.substr(at, replay.find(' ', at) - at));
  words.insert(words.end(), {"--out", "again", "--quiet"});
  CHECK(run_spoke(words, folder.work()).status == 0);
  const json summary = json::parse(file_text(folder.work().path() / "again" / "summary.json"));
  CHECK(summary["sensors"]["blade1.tip.y"]["min"] == study["responses"][0]["min"]["value"]);
}

TEST_CASE("runs that diverge or are refused are rows that say why") {
  const StudyFolder folder;
  folder.write_study(
      "scenario = \"rotor.toml\"\ndesign = { kind = \"grid\" }\n"
      "[[parameter]]\nkey = \"integration.max_iterations\"\nvalues = [30, 1, -4]\n"
      "[[response]]\nsensor = \"blade1.tip.y\"\nkind = \"max\"\n");
  const std::vector<std::string> rows = lines_of(folder.run({"--out", "o"}).at("runs.csv"));
  REQUIRE(rows.size() == 4);
  CHECK(rows[1].starts_with("1,done,30,"));
  CHECK(rows[2].starts_with("2,diverged,1,,"));
  CHECK(rows[3].starts_with("3,refused,-4,,"));
  CHECK(rows[3].find("expected a whole number from") != std::string::npos);
}

TEST_CASE("a value that is refused is a row, whichever run it comes in") {
  const StudyFolder folder;
  const auto rows_of = [&](const std::string& parameter, const std::string& responses) {
    folder.write_study("scenario = \"rotor.toml\"\ndesign = { kind = \"grid\" }\n[[parameter]]\n" +
                       parameter + responses);
    return lines_of(folder.run({"--out", "o"}).at("runs.csv"));
  };
  const std::string tip = "[[response]]\nsensor = \"blade2.tip.y\"\nkind = \"max\"\n";
  for (const std::string values : {"[-1, 2, 3]", "[2, -1, 3]", "[2, 3, -1]"}) {
    CAPTURE(values);
    const auto rows = rows_of("key = \"blade.length\"\nvalues = " + values + "\n", tip);
    REQUIRE(rows.size() == 4);
    for (std::size_t k = 1; k < rows.size(); ++k)
      CHECK((rows[k].find(",refused,-1,,") != std::string::npos) !=
            (rows[k].find(",done,") != std::string::npos));
  }
  // So is a run that has not the sensor, or the mode, that others have.
  for (const std::string counts : {"[1, 2]", "[2, 1]"}) {
    const auto rows = rows_of("key = \"blade.count\"\nvalues = " + counts + "\n", tip);
    CHECK(rows.at(counts == "[1, 2]" ? 1 : 2).find(",refused,1,,") != std::string::npos);
    CHECK(rows.at(counts == "[1, 2]" ? 2 : 1).find(",done,2,") != std::string::npos);
  }
}

TEST_CASE("a study that no run of which can be made is refused for what is said against run 1") {
  const StudyFolder folder;
  const auto refused = [&](const std::string& values, const std::string& message) {
    folder.write_study(
        "scenario = \"rotor.toml\"\ndesign = { kind = \"grid\" }\n[[parameter]]\n"
        "key = \"blade.length\"\nvalues = " +
        values + "\n[[response]]\nsensor = \"blade9.tip.y\"\nkind = \"max\"\n");
    check_refused({"study", "study.toml", "--out", "o"}, message, folder.work());
  };
  refused("[-1, -2]", "study.toml:4:7: parameter.1.key: in run 1: blade.length: is -1");
  refused("[1, 2]", "study.toml:7:10: response.1.sensor: \"blade9.tip.y\" is no sensor");
}

TEST_CASE("texts that begin as formulas do are no formulas in CSV files") {
  const StudyFolder folder;
  folder.write_study(
      "scenario = \"rotor.toml\"\ndesign = { kind = \"grid\" }\n"
      "[[parameter]]\nkey = \"title\"\nname = \"=A1\"\nvalues = [\"=1+1\", \"plain\"]\n"
      "[[parameter]]\nkey = \"blade.length\"\nvalues = [2, -1]\n"
      "[[response]]\nsensor = \"blade1.tip.y\"\nkind = \"max\"\nname = \"+tip\"\n");
  const std::vector<std::string> rows = lines_of(folder.run({"--out", "o"}).at("runs.csv"));
  CHECK(rows.at(0) == "run,status,'=A1,blade.length,'+tip,diagnosis");
  CHECK(rows.at(1).starts_with("1,done,'=1+1,2,"));
  CHECK(rows.at(2).starts_with("2,refused,'=1+1,-1,,"));
  CHECK(rows.at(2).find(",\"'--set ") != std::string::npos);
  CHECK(rows.at(3).starts_with("3,done,plain,2,"));
}

TEST_CASE("an unfinished study is not thrown away, and resumed to the bytes of an unbroken one") {
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const Left whole = folder.run({"--out", "whole"});
  const fs::path journal = folder.work().path() / "cut" / "study.journal";
  fs::create_directory(journal.parent_path());
  fs::copy_file(folder.work().path() / "whole" / "study.journal", journal);
  fs::resize_file(journal, fs::file_size(journal) * 2 / 3);
  check_refused({"study", "study.toml", "--out", "cut"},
                "cut/study.journal: has 7 of 12 runs of a study that was not ended, expected "
                "--resume, or another folder",
                folder.work());
  CHECK(folder.run({"--out", "cut", "--resume", "--threads", "2"}) == whole);
  folder.work().write("cut/study.h5", "damaged");  // is written anew, of a study that is complete
  check_refused({"study", "study.toml", "--out", "cut", "--resume"},
                "cut/study.h5: cannot be written: there is a file that is not a file of HDF5, "
                "expected another name, or --force to replace it",
                folder.work());
  CHECK(folder.run({"--out", "cut", "--resume", "--force"}) == whole);
  folder.write_study(std::string("# changed\n") + kSmallStudy);
  check_refused({"study", "study.toml", "--out", "cut", "--resume"},
                "cut/study.journal: is of another study, expected the same one to resume: "
                "study.toml is not what it was",
                folder.work());
  folder.write_study(kSmallStudy);
  CHECK(folder.run({"--out", "new", "--resume"}) == whole);  // none was begun
}

TEST_CASE("SIGINT ends a study between runs, and --resume completes it") {
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const Left whole = folder.run({"--out", "whole"});
  folder.write_study(kSmallStudy);
  Child child({"study", "study.toml", "--out", "o", "--threads", "1"}, folder.work());
  const fs::path journal = folder.work().path() / "o" / "study.journal";
  REQUIRE(wait_until([&] { return size_of(journal) > 200 || !child.is_running(); }));
  child.send(SIGINT);
  const ChildEnded ended = child.wait();
  if (ended.status != 0) {  // it may have been done already
    CHECK(ended.status == 130);
    CHECK(ended.err.find("interrupted by SIGINT behind ") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.work().path() / "o" / "runs.csv"));
  }
  CHECK(folder.run({"--out", "o", "--resume"}) == whole);
}

TEST_CASE("a study killed at random times is resumed to the bytes of an unbroken one") {
  check_study_kills(3);
}

namespace {

/// A study file with one thing wrong, and what is said of it.
struct Wrong {
  std::string text, message;
};

const std::string kTop = "scenario = \"rotor.toml\"\ndesign = { kind = \"sobol\", runs = 4 }\n";
const std::string kGridTop = "scenario = \"rotor.toml\"\ndesign = { kind = \"grid\" }\n";
const std::string kParameter = "[[parameter]]\nkey = \"blade.length\"\nuniform = [2, 4]\n";
const std::string kResponse = "[[response]]\nsensor = \"hub.speed\"\nkind = \"max\"\n";

std::string with_parameter(const std::string& lines) {
  return kTop + "[[parameter]]\n" + lines + '\n' + kResponse;
}
std::string with_response(const std::string& lines) {
  return kTop + kParameter + "[[response]]\n" + lines + '\n';
}
std::string with_design(const std::string& design) {
  return "scenario = \"rotor.toml\"\ndesign = " + design + '\n' + kParameter + kResponse;
}

std::vector<Wrong> wrong_studies() {
  return {
      {"", "study.toml: is empty, expected a study file (TOML)"},
      {"scenario = ", "study.toml:1:12: not TOML: "},
      {"scenaro = \"rotor.toml\"\n",
       "study.toml:1:1: scenaro: unknown key, did you mean \"scenario\"?"},
      {"design = { kind = \"grid\" }\n",
       "study.toml:1:1: scenario: is missing, expected the name of a"},
      {"scenario = \"none.toml\"\ndesign = { kind = \"grid\" }\n", "none.toml: no such file"},
      {"scenario = \"rotor.toml\"\n",
       "study.toml:1:1: design: is missing, expected a table such as"},
      {kTop + kResponse,
       "study.toml:1:1: parameter: is missing, expected tables headed [[parameter]]"},
      {kTop + kParameter,
       "study.toml:1:1: response: is missing, expected tables headed [[response]]"},
      {with_design("3"), "study.toml:2:10: design: is 3, expected a table [design]"},
      {with_design("{ kind = \"sobl\" }"),
       "study.toml:2:19: design.kind: is \"sobl\", expected \"grid\""},
      {with_design("{ kind = \"sobol\" }"),
       "design.runs: is missing, expected a whole number from 1"},
      {with_design("{ kind = \"sobol\", runs = 1000000000000 }"),
       "study.toml:2:35: design.runs: is 1000000000000, expected a whole number from 1 to "
       "10000000"},
      {with_design("{ kind = \"sobol\", runs = 0 }"), "design.runs: is 0, expected a whole number"},
      {with_design("{ kind = \"sobol\", runs = 4, seed = -1 }"),
       "design.seed: is -1, expected a whole"},
      {with_design("{ kind = \"grid\", runs = 4 }"), "design.runs: does not go with \"grid\""},
      {with_design("{ kind = \"latin_hypercube\", runs = 4, points = 4 }"),
       "design.points: does not go with \"latin_hypercube\""},
      {with_design("{ kind = \"saltelli\", points = 4000000 }"),
       "design: makes 12000000 runs, 3 for each point, expected at most 10000000 runs"},
      {with_design("{ kind = \"table\" }"), "design.file: is missing, expected the name of a CSV"},
      {with_design("{ kind = \"table\", file = \"none.csv\" }"), "none.csv: no such file"},
      {with_design("{ kind = \"grid\" }"),
       "study.toml:5:11: parameter.1.uniform: does not go with a grid, expected \"values\""},
      {kGridTop +
           "[[parameter]]\nkey = \"blade.length\"\nrange = [1, 2, 10000]\n[[parameter]]\n"
           "key = \"blade.density\"\nrange = [1, 2, 10000]\n" +
           kResponse,
       "design: all combinations are more runs, expected at most 10000000 runs"},
      {with_parameter("values = [1]"), "parameter.1: has no key, expected the key of the scenario"},
      {with_parameter("key = \"blade.length\""), "parameter.1: has no values, expected one of"},
      {with_parameter("key = \"blade.lenght\"\nuniform = [2, 4]"),
       "study.toml:4:7: parameter.1.key: in run 1: blade.lenght: unknown key, did you mean "
       "\"length\"?"},
      {with_parameter("key = \"blade.length\"\nunifrm = [2, 4]"),
       "parameter.1.unifrm: unknown key, did you mean \"uniform\"?"},
      {with_parameter("key = \"blade.length\"\nuniform = [2, 4]\nvalues = [1]"),
       "parameter.1.uniform: stands beside values, expected one of the two"},
      {with_parameter("key = \"blade.length\"\nvalues = []"),
       "values: is an empty array, expected an array"},
      {with_parameter("key = \"blade.length\"\nvalues = [1, \"a\"]"),
       "values: mixes numbers with other"},
      {with_parameter("key = \"blade.length\"\nvalues = [[1]]"),
       "values.1: is an array (1), expected a number"},
      {with_parameter("key = \"blade.length\"\nuniform = [4, 4]"),
       "parameter.1.uniform.2: is 4, expected more than the first, 4"},
      {with_parameter("key = \"blade.length\"\nuniform = [2, nan]"),
       "uniform.2: is nan, expected a finite"},
      {with_parameter("key = \"blade.length\"\nuniform = [2, 4, 6]"),
       "expected an array of 2 numbers"},
      {with_parameter("key = \"blade.length\"\nrange = [2, 4, 1.5]"),
       "range.3: is 1.5, expected a whole"},
      {with_parameter("key = \"blade.length\"\nrange = [4, 2, 3]"),
       "range.2: is 2, expected more than"},
      {with_parameter("key = \"blade.length\"\nnormal = [2, 0]"),
       "normal.2: is 0, expected a deviation"},
      {with_parameter("key = \"blade.length\"\nlog_uniform = [0, 1]"),
       "log_uniform.1: is 0, expected a number"},
      {with_parameter("key = \"blade.length\"\nuniform = [-4, -2]"),
       "parameter.1.key: in run 1: blade.length: is -"},
      {with_parameter("key = \"blade.length\"\nexpression = \"2\""),
       "parameter: has expressions alone"},
      {kTop + kParameter +
           "[[parameter]]\nkey = \"blade.density\"\nexpression = \"2 * blade.lenth\"\n" + kResponse,
       "study.toml:8:14: parameter.2.expression: is \"2 * blade.lenth\", expected arithmetic: "
       "\"blade.lenth\" is no other parameter, did you mean \"blade.length\"? at character 5"},
      {kTop + kParameter +
           "[[parameter]]\nname = \"a\"\nexpression = \"b\"\n[[parameter]]\nname = \"b\"\n"
           "expression = \"a\"\n" +
           kResponse,
       "expression: needs itself, directly or by others"},
      {kTop + kParameter + kParameter + kResponse,
       "parameter.2.key: is \"blade.length\" a second time"},
      {with_response("sensor = \"hub.speed\""), "response.1.kind: is missing, expected \"min\""},
      {with_response("kind = \"max\""),
       "response.1.sensor: is missing, expected the name of a sensor"},
      {with_response("sensor = \"hub.sped\"\nkind = \"max\""),
       "study.toml:7:10: response.1.sensor: \"hub.sped\" is no sensor, did you mean "
       "\"hub.speed\"?"},
      {with_response("sensor = \"hub.speed\"\nkind = \"largest\""),
       "response.1.kind: is \"largest\", expected"},
      {with_response("sensor = \"hub.speed\"\nkind = \"at\""), "response.1.time: is missing"},
      {with_response("sensor = \"hub.speed\"\nkind = \"at\"\ntime = 99"),
       "looks at 99 s, expected a time within"},
      {with_response("sensor = \"hub.speed\"\nkind = \"max\"\nlevel = 1"),
       "level: does not go with \"max\""},
      {with_response("sensor = \"hub.speed\"\nkind = \"mean\"\nfrom = 3\nto = 2"),
       "to: ends the window before it begins"},
      {with_response("sensor = \"hub.speed\"\nkind = \"first_crossing\""),
       "response.1.level: is missing"},
      {with_response("kind = \"frequency\"\nmode = 0"),
       "response.1.mode: is 0, expected a whole number from 1"},
      {with_response("kind = \"frequency\"\nmode = \"lug 1\""),
       "study.toml:8:8: response.1.mode: there is no such mode, did you mean \"lag 1\"?"},
      {with_response("sensor = \"hub.speed\"\nkind = \"history\"\nname = \".\""),
       "study.toml:9:8: response.1.name: is named \".\", expected a name without comma"},
      {with_response("sensor = \"hub.speed\"\nkind = \"history\"\nname = \"a\\u0000b\""),
       "study.toml:9:8: response.1.name: is named \"a b\", expected a name without comma"},
      {with_response("sensor = \"hub.speed\"\nkind = \"max\"\nname = \"" +
                     std::string(70'000, 'x') + "\""),
       "response.1.name: makes the names of responses 70001 bytes long together, expected at most "
       "60000"},
      {"title = \"" + std::string(70'000, 'x') + "\"\n" + kTop + kParameter + kResponse,
       "study.toml:1:9: title: is 70000 bytes long, expected at most 60000"},
      {with_parameter("key = \"blade.length\"\nuniform = [2, 4]\nname = \"" +
                      std::string(70'000, 'x') + "\""),
       "parameter.1.name: makes the names of parameters 70001 bytes long together, expected"},
      {kTop + kParameter + kResponse + kResponse,
       "response.2: is named \"hub.speed.max\" as another"},
  };
}

}  // namespace

TEST_CASE("a bad study file is refused in one line with its place, and nothing is written") {
  const StudyFolder folder;
  const std::vector<Wrong> all = wrong_studies();
  CHECK(all.size() >= 50);
  for (const Wrong& wrong : all) {
    folder.write_study(wrong.text);
    check_refused({"study", "study.toml", "--out", "o"}, wrong.message, folder.work());
  }
}

TEST_CASE("a bad table of a study is refused with its place") {
  const StudyFolder folder;
  folder.write_study(
      "scenario = \"rotor.toml\"\ndesign = { kind = \"table\", file = \"t.csv\" }\n" + kResponse);
  const auto refused = [&](const std::string& table, const std::string& message) {
    folder.work().write("t.csv", table);
    check_refused({"study", "study.toml", "--out", "o"}, message, folder.work());
  };
  refused("blade.length\n", "t.csv: has no rows, expected a line of keys and lines of values");
  refused("blade.length,blade.density\n2,2700\n3\n",
          "t.csv:3:1: has 1 cell, expected 2 as in the head");
  refused("blade.length,\n2,3\n", "t.csv:1:14: a column has no head");
  refused("blade.length,blade.length\n2,3\n", "t.csv:1:14: is \"blade.length\" a second time");
  refused("blade.length\n2\nlong\n", "t.csv:3:1: blade.length: is \"long\", expected a number");
  refused("blade.length,blade.density\n2, nan\n",
          "t.csv:2:4: blade.density: is nan, expected a finite");
  refused("blade.length\n\"2\n", "t.csv:2:1: a quote is not closed");
  refused("blade.lenght\n2\n",
          "t.csv:1:1: in run 1: blade.lenght: unknown key, did you mean \"length\"?");
  folder.work().write("t.csv", "blade.length, blade.reference_frame\n2, chord\n3, \"clamped\"\n");
  const std::vector<std::string> rows = lines_of(folder.run({"--out", "o"}).at("runs.csv"));
  CHECK(rows.at(2).starts_with("2,done,3,clamped,"));
}

TEST_CASE("bad options of a study are refused") {
  check_refused({"study"}, "spoke study: STUDY is required (see spoke study --help)");
  check_refused({"study", "none.toml"}, "none.toml: no such file, expected a study file (TOML)");
  check_refused({"study", "x.toml", "--threads", "0"}, "--threads: Value 0 not in range");
  check_refused({"study", "x.toml", "--set", "a=1"}, "spoke study: unexpected argument --set");
  check_refused({"study", "x.toml", "--out", ""}, "--out: expected the name of a folder");
}
