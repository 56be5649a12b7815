#include "engine/checkpoint.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

#include "models/support/instructions.h"
#include "tests/checkpoint_checksum.h"
#include "tests/engine/rotors.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;
using namespace spoke;
using namespace spoke::test;

namespace {

Simulation make_simulation() {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 2), 0.01);
  scenario.integration.duration = 1.0;
  return Simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
}

RunRecord make_record() {
  RunRecord record{0.05, 7.0, 0.3, 1.25, {}, {}, {123456789012, 0xDEADBEEF}};
  record.ranges.push_back({-1.0, 0.1, 2.0, 0.2, std::numeric_limits<double>::quiet_NaN()});
  record.ranges.push_back({});
  record.tips = {{0.5, 0.25}, {-0.0, 0.0}, {1e-308, 3.0}};
  return record;
}

std::string refusal(const std::string& bytes) {
  return message_of([&] { parse_checkpoint(bytes, "c"); });
}

/// Returns the bytes with another format and a checksum that fits.
std::string with_format(std::string bytes, char format) {
  bytes[8] = format;
  return with_fitting_checksum(std::move(bytes));
}

}  // namespace

TEST_CASE("a checkpoint reads back what was written, to the last bit") {
  Simulation simulation = make_simulation();
  simulation.run_until(0.3);
  const SavedState state = simulation.save();
  const RunRecord record = make_record();
  const Checkpoint read = parse_checkpoint(make_checkpoint(state, record), "c");
  CHECK(read.program == SPOKE_VERSION);
  CHECK(read.instructions == instructions_in_use());
  CHECK(*read.state.model == *state.model);
  CHECK(read.state.time == 0.3);
  CHECK(read.state.steps == 30);
  CHECK(read.state.evaluations == state.evaluations);
  CHECK(read.state.work == state.work);
  CHECK(read.state.dissipated == state.dissipated);
  CHECK(read.state.values == state.values);
  REQUIRE(read.record.has_value());
  CHECK(read.record->output_interval == 0.05);
  CHECK(read.record->next_multiple == 7.0);
  CHECK(read.record->last_row == 0.3);
  CHECK(read.record->wall_time == 1.25);
  CHECK(read.record->rows.bytes == 123456789012);
  CHECK(read.record->rows.checksum == 0xDEADBEEF);
  REQUIRE(read.record->ranges.size() == 2);
  CHECK(read.record->ranges[0].max == 2.0);
  CHECK(std::isnan(read.record->ranges[0].final));
  CHECK(read.record->ranges[1].min == std::numeric_limits<double>::infinity());
  REQUIRE(read.record->tips.size() == 3);
  CHECK(std::signbit(read.record->tips[1].largest));
  CHECK(read.record->tips[2].largest == 1e-308);
  CHECK_FALSE(parse_checkpoint(make_checkpoint(state), "c").record.has_value());
}

TEST_CASE("a simulation goes on from a file with the same bits") {
  const TemporaryFolder folder;
  Simulation whole = make_simulation(), first = make_simulation(), second = make_simulation();
  whole.run_until(1.0);
  first.run_until(0.42);
  save_checkpoint(folder / "c", first.save());
  second.restore(load_checkpoint(folder / "c").state);
  second.run_until(1.0);
  CHECK(second.state_hash() == whole.state_hash());
  CHECK(second.evaluations() == whole.evaluations());
}

TEST_CASE("the bytes begin as documented") {
  SavedState state{std::make_shared<const std::string>("{}"), 0.5, 258, 3, 0.0, 0.0, {1.0}};
  const std::string bytes = make_checkpoint(state);
  CHECK(bytes.substr(0, 8) == "SPOKECKP");
  CHECK(bytes.substr(8, 4) == std::string("\11\0\0\0", 4));
  CHECK(static_cast<unsigned char>(bytes[12]) == bytes.size() - 24);
  const std::size_t program = 20 + 8 + std::string(SPOKE_VERSION).size();
  const std::string instructions(instructions_in_use());
  CHECK(static_cast<std::size_t>(bytes[program]) == instructions.size());
  CHECK(bytes.substr(program + 8, instructions.size()) == instructions);
  const std::size_t state_at = program + 8 + instructions.size();
  CHECK(bytes.substr(state_at, 10) == std::string("\2\0\0\0\0\0\0\0{}", 10));
  CHECK(bytes.substr(state_at + 10, 8) == std::string("\0\0\0\0\0\0\xE0\x3F", 8));
  CHECK(bytes.substr(state_at + 18, 8) == std::string("\2\1\0\0\0\0\0\0", 8));
  CHECK(with_format(bytes, 9) == bytes);
}

TEST_CASE("every truncation of a checkpoint is refused as such") {
  const std::string bytes = make_checkpoint(make_simulation().save(), make_record());
  CHECK(refusal("") == "c: is empty, expected a checkpoint");
  for (std::size_t size = 1; size < bytes.size(); size += size < 100 ? 1 : 61) {
    CAPTURE(size);
    CHECK(refusal(bytes.substr(0, size)).find("c: is truncated: has ") == 0);
  }
  CHECK(refusal(bytes + 'x') == "c: is damaged: has bytes behind its end");
}

TEST_CASE("every flipped bit is noticed") {
  const std::string bytes = make_checkpoint(make_simulation().save(), make_record());
  CHECK(refusal(bytes) == "no error");
  for (std::size_t at = 0; at < bytes.size(); at += at < 200 ? 1 : 37) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    CAPTURE(at);
    CHECK(refusal(damaged).find("c: is ") == 0);
  }
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  CHECK(refusal(damaged).find("c: is damaged: its checksum is ") == 0);
}

TEST_CASE("foreign files and newer formats are refused as such") {
  CHECK(refusal("t,blade1.tip.x\n0,0\n") == "c: is no checkpoint of Spoke");
  CHECK(message_of([] { load_checkpoint("/dev/zero"); }) ==  // which has no end
        "/dev/zero: is no checkpoint of Spoke");
  const std::string bytes = make_checkpoint(make_simulation().save());
  for (const char other : {8, 10})
    CHECK(refusal(with_format(bytes, other))
              .find("c: is of format " + std::to_string(other) + ", this version of Spoke (") == 0);
}

TEST_CASE("counts beyond the content are refused before memory is asked for") {
  SavedState state{std::make_shared<const std::string>("{}"), 0.0, 0, 0, 0.0, 0.0, {1.0}};
  std::string bytes = make_checkpoint(state);
  const std::size_t count = bytes.size() - 4 - 1 - 1 - 8 - 8;
  bytes[count + 7] = '\x7F';
  CHECK(refusal(with_format(bytes, 9)) == "c: is damaged: its parts do not fit");
}

TEST_CASE("files that cannot be read or written say why, and the old one stays") {
  const TemporaryFolder folder;
  const SavedState state = make_simulation().save();
  const std::string missing = (folder / "none").string();
  CHECK(message_of([&] { load_checkpoint(missing); }) ==
        missing + ": cannot be read: No such file or directory");
  CHECK(message_of([&] { load_checkpoint(folder.path()); }) ==
        folder.path().string() + ": is a directory, expected a checkpoint");
  const std::string below = (folder / "none" / "c").string();
  CHECK(message_of([&] { save_checkpoint(below, state); }) ==
        below + ": cannot be written: No such file or directory");
  // A folder stands in the place of the temporary file: the checkpoint stays as it is.
  save_checkpoint(folder / "c", state);
  fs::create_directory(folder / "c.tmp");
  CHECK(message_of([&] { save_checkpoint(folder / "c", state); }) ==
        (folder / "c").string() + ": cannot be written: Is a directory");
  CHECK(load_checkpoint(folder / "c").state.values == state.values);
}
