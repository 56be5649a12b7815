// Commands that are programs of their own, beside spoke.

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

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

constexpr const char* kPrograms[] = {"study",  "import",  "export",
#ifdef SPOKE_HAS_FMU
                                     "fmu",
#endif
                                     "verify", "compare", "reproduce"};

/// The words of a run that takes no time.
std::vector<std::string> short_run(const std::string& out) {
  return {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1", "--out", out};
}

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
  CHECK(run_program(spoke.string(), {"run", "--help"}, folder).status == 0);
  CHECK(run_program(spoke.string(), short_run("o"), folder).status == 0);
}

TEST_CASE("spoke makes runs alone, and says before it writes which program it needs for others") {
  const WorkFolder folder;
  const fs::path spoke = fs::canonical(folder.path()) / "spoke";
  fs::copy_file(SPOKE_PROGRAM, spoke);
  const auto check_refused = [&](const std::vector<std::string>& words) {
    const Ended ended = run_program(spoke.string(), words, folder);
    CAPTURE(words[1]);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err == "spoke " + words[0] + ": cannot start " + spoke.string() +
                           "-whole: No such file or directory, expected the program spoke-whole "
                           "beside spoke (it is built by the target of this name)\n");
    CHECK(folder.entries() == 1);
  };
  check_refused({"static", shipped("wu_haug_rotor")});
  check_refused({"run", shipped("wu_haug_rotor"), "--set", "initial.state=equilibrium"});
  check_refused({"run", shipped("wu_haug_rotor"), "--set", "damping.ratios=[0.01]"});
  check_refused({"run", shipped("solid_bracket")});
  check_refused({"run", shipped("four_bar")});
  check_refused({"run", "/dev/stdin"});  // which can be read once only
}

TEST_CASE("the script that started spoke is asked to build the program that is missing") {
  const WorkFolder folder;
  const fs::path here = fs::canonical(folder.path()), spoke = here / "spoke";
  fs::copy_file(SPOKE_PROGRAM, spoke);
  const std::string script = folder.write(
      "script", "#!/bin/sh\necho \"$@\" >asked\ncp '" SPOKE_PROGRAM "-study' '" + here.string() +
                    "'\ncp '" SPOKE_PROGRAM "-whole' '" + here.string() + "'\n");
  fs::permissions(script, fs::perms::owner_all);
  const std::string before = "env SPOKE_SCRIPT='" + script + "'";
  CHECK(run_program(spoke.string(), short_run("o"), folder, before).status == 0);
  CHECK(!fs::exists(here / "asked"));
  CHECK(run_program(spoke.string(), {"check", shipped("wu_haug_rotor")}, folder, before).status ==
        0);
  CHECK(file_text(here / "asked") == "--build spoke-whole\n");
  CHECK(run_program(spoke.string(), {"study", "--help"}, folder, before).status == 0);
  CHECK(file_text(here / "asked") == "--build spoke-study\n");
  const Ended failed =
      run_program(spoke.string(), {"check", "x.toml"}, folder, "env SPOKE_SCRIPT=/bin/false");
  CHECK(failed.status == 2);
  CHECK(failed.err == "spoke check: spoke-whole could not be built\n");
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
