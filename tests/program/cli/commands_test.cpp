// Commands that are programs of their own, beside spoke.

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "tests/program/cli/child.h"
#include "tests/program/cli/program.h"

namespace fs = std::filesystem;

namespace {

// The thread sanitizer puts off signals that arrive while the program waits.
#ifdef SPOKE_THREAD_SANITIZER
constexpr bool kPutsOffSignals = true;
#else
constexpr bool kPutsOffSignals = false;
#endif

constexpr const char* kPrograms[] = {"study",   "import",  "export",
#ifdef SPOKE_HAS_FMU
                                     "fmu",
#endif
                                     "compare", "predict", "reproduce"};

std::string program_of(const std::string& command) {
  return std::string(SPOKE_PROGRAM) + '-' + command;
}

}  // namespace

TEST_CASE("a command whose program is missing says which, and spoke alone does the others") {
  const WorkFolder folder;
  const fs::path spoke = fs::canonical(folder.path()) / "spoke";
  fs::copy_file(SPOKE_PROGRAM, spoke);
  for (const std::string command : kPrograms) {
    const Ended ended = run_program(spoke.string(), {command, "--help"}, folder);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err == "spoke " + command + ": cannot start " + spoke.string() + '-' + command +
                           ": No such file or directory, expected the program spoke-" + command +
                           " beside spoke (it is built by the target of this name)\n");
  }
  CHECK(run_program(spoke.string(), {"check", shipped("wu_haug_rotor")}, folder).status == 0);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a command's own program has its help, its version and its refusals") {
  const WorkFolder folder;
  const std::string version = run_spoke({"--version"}, folder).out;
  for (const std::string command : kPrograms) {
    CAPTURE(command);
    const Ended told = run_program(program_of(command), {"--version"}, folder);
    CHECK(told.status == 0);
    CHECK(told.out == version);
    const Ended help = run_program(program_of(command), {"--help"}, folder);
    CHECK(help.status == 0);
    CHECK(help.out == run_spoke({command, "--help"}, folder).out);
    CHECK(help.out.find("Usage: spoke " + command) != std::string::npos);
    const Ended refused = run_program(program_of(command), {"--odd"}, folder);
    CHECK(refused.status == 2);
    CHECK(refused.err == run_spoke({command, "--odd"}, folder).err);
  }
}

TEST_CASE("a signal to spoke ends the program of its command" * doctest::skip(kPutsOffSignals)) {
  const WorkFolder folder;
  const std::string pipe = (folder.path() / "s.toml").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    Child child({"compare", "s.toml"}, folder);
    // The pipe can be opened for writing once the program reads its scenario from it, in vain.
    int writer = -1;
    REQUIRE(wait_until([&] {
      writer = open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
      return writer >= 0;
    }));
    child.send(signal);
    CHECK(child.wait().signal == signal);
    close(writer);
  }
}
