#pragma once

// A folder with a study of a small rotor, and what its runs leave.

#include <map>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"

/// Twelve runs of milliseconds.
extern const char* const kSmallStudy;

/// Files of a study, by name, that must not depend on how it was made.
using Left = std::map<std::string, std::string>;

class StudyFolder {
 public:
  /// Has rotor.toml.
  StudyFolder();

  const WorkFolder& work() const { return work_; }
  void write_study(const std::string& text) const { work_.write("study.toml", text); }
  /// Runs study.toml with these options, the first two --out and its folder; demands success.
  Left run(const std::vector<std::string>& options) const;
  /// The files in a folder of results but the journal, which has runs as they ended.
  Left left_in(const std::string& out) const;

 private:
  WorkFolder work_;
};

/// Kills a study at random times, `kills` times in all, and resumes it, until it ends by itself;
/// checks that it then has the results of the unbroken one.
void check_study_kills(int kills);
