#pragma once

// Runs the program spoke as a user would: arguments in, exit status and texts out.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/file_text.h"

using spoke::test::file_text;

/// An empty folder that is removed at the end.
class WorkFolder {
 public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Number of files and folders in it, at any depth.
  int entries() const;
  /// Writes a file and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

struct Ended {
  int status = -1;  ///< exit status; -1 if it did not exit
  std::string out;
  std::string err;
};

/// Runs spoke with the folder as working directory. Its outputs are no terminals. `before`: what
/// the shell reads before the program's name, such as "env A=b" or "ulimit -v 1000000;"; `input`:
/// the file on its standard input.
Ended run_spoke(const std::vector<std::string>& arguments, const WorkFolder& folder,
                const std::string& before = "", const std::string& input = "/dev/null");

/// Runs another program as run_spoke() does.
Ended run_program(const std::string& program, const std::vector<std::string>& arguments,
                  const WorkFolder& folder, const std::string& before = "",
                  const std::string& input = "/dev/null");

/// Returns the words before the program that run it in so many processes.
std::string mpirun(int ranks);

/// The path of a shipped scenario.
std::string shipped(const std::string& name);

std::vector<std::string> lines_of(const std::string& text);
