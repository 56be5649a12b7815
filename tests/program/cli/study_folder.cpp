#include "tests/program/cli/study_folder.h"

#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>

#include "tests/program/cli/child.h"

namespace fs = std::filesystem;

const char* const kSmallStudy = R"(
scenario = "rotor.toml"
design = { kind = "grid" }

[[parameter]]
key = "blade.length"
range = [2, 4, 6]

[[parameter]]
key = "blade.bodies"
values = [1, 2]

[[parameter]]
key = "blade.density"
expression = "5400 / blade.length"

[[response]]
sensor = "blade1.tip.y"
kind = "min"

[[response]]
sensor = "hub.speed"
kind = "final"

[[response]]
sensor = "hub.angle"
kind = "history"
)";

namespace {

const char* const kRotor = R"(
[hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 0.5

[blade]
count = 2
length = 3.0
bodies = 1
elements = 3
density = 2700.0
area = 7.3e-5
second_moment = 8.2e-9
youngs_modulus = 6.9e10

[integration]
step = 0.005
duration = 0.25

[output]
interval = 0.05
)";

}  // namespace

StudyFolder::StudyFolder() { work_.write("rotor.toml", kRotor); }

Left StudyFolder::run(const std::vector<std::string>& options) const {
  std::vector<std::string> arguments = {"study", "study.toml", "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Ended ended = run_spoke(arguments, work_);
  CHECK(ended.err == "");
  CHECK(ended.out.empty());
  REQUIRE(ended.status == 0);
  return left_in(options.at(1));
}

Left StudyFolder::left_in(const std::string& out) const {
  Left left;
  for (const auto& entry : fs::directory_iterator(work_.path() / out))
    if (entry.path().filename() != "study.journal")
      left[entry.path().filename().string()] = file_text(entry.path());
  return left;
}

void check_study_kills(int kills) {
  const StudyFolder folder;
  std::string text = kSmallStudy;
  text.replace(text.find("[2, 4, 6]"), 9, "[2, 4, 80]");
  text += "\n[statistics]\nsensors = [\"blade1.*\"]\n";
  folder.write_study(text);
  const auto start = std::chrono::steady_clock::now();
  const Left whole = folder.run({"--out", "whole", "--threads", "2"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0.0, took.count());
  for (int killed = 0, number = 0; killed < kills; ++number) {
    REQUIRE(number < 100 * kills);
    Child child(
        {"study", "study.toml", "--out", "o", "--resume", "--threads", number % 2 == 0 ? "1" : "3"},
        folder.work());
    sleep_seconds(moment(random));
    child.send(SIGKILL);
    const ChildEnded ended = child.wait();
    if (ended.signal == SIGKILL) {
      ++killed;
      continue;
    }
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(folder.left_in("o") == whole);
    fs::remove_all(folder.work().path() / "o");
  }
  CHECK(folder.run({"--out", "o", "--resume"}) == whole);
}
