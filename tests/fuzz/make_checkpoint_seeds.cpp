// make_checkpoint_seeds FOLDER: writes small checkpoints, with and without the record of a run, for
// fuzz_checkpoint to begin with.

#include <cstdio>
#include <filesystem>

#include "engine/checkpoint.h"
#include "models/error.h"

using namespace spoke;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_checkpoint_seeds FOLDER\n", stderr);
    return 2;
  }
  SavedState state{std::make_shared<const std::string>("{\"model\": 1}"),
                   0.5,
                   100,
                   200,
                   1.0,
                   0.0,
                   {0.1, -0.2, 3.0}};
  RunRecord record;
  record.output_interval = 0.05;
  record.ranges.resize(2);
  record.tips.resize(2);
  record.rows = {1000, 1};
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    save_checkpoint(folder / "state", state);
    save_checkpoint(folder / "state_and_record", state, record);
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
