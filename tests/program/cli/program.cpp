#include "tests/program/cli/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + '\'';
}

}  // namespace

WorkFolder::WorkFolder() {
  std::string pattern = (fs::temp_directory_path() / "spoke_cli_tests_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make " + pattern);
  path_ = pattern;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

int WorkFolder::entries() const {
  return static_cast<int>(std::distance(fs::recursive_directory_iterator(path_), {}));
}

fs::path WorkFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

Ended run_spoke(const std::vector<std::string>& arguments, const WorkFolder& folder,
                const std::string& before, const std::string& input) {
  return run_program(SPOKE_PROGRAM, arguments, folder, before, input);
}

Ended run_program(const std::string& program, const std::vector<std::string>& arguments,
                  const WorkFolder& folder, const std::string& before, const std::string& input) {
  const WorkFolder texts;
  std::string command =
      "cd " + quoted(folder.path().string()) + " && " + before + ' ' + quoted(program);
  for (const std::string& argument : arguments) command += ' ' + quoted(argument);
  command += " >" + quoted((texts.path() / "out").string()) + " 2>" +
             quoted((texts.path() / "err").string()) + " <" + quoted(input);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_text(texts.path() / "out"),
          file_text(texts.path() / "err")};
}

std::string mpirun(int ranks) {
  // Open MPI refuses to run for the system's administrator, whom containers make of everybody,
  // unless told twice. And once in some hundred kills of a process mpirun waits for itself for
  // ever, when all others have ended (PMIx_server_finalize of PMIx 4.2): it is then killed, too.
  return "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
         "timeout --foreground --signal=KILL 60 mpirun --oversubscribe -n " +
         std::to_string(ranks) + ' ';
}

std::string shipped(const std::string& name) {
  return (fs::path(SPOKE_MODELS_DIR) / (name + ".toml")).string();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}
