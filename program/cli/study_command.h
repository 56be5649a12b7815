#pragma once

// The command of the program `spoke-study`.

#include <string>

#include "program/cli/arguments.h"

namespace spoke::cli {

/// Options of the command besides Arguments.
struct StudyArguments {
  std::string study;     ///< study file
  bool resumes = false;  ///< goes on from the journal in the folder
  bool lists = false;    ///< prints the table of the runs, and makes none
};

/// Makes the runs of a study and writes its files. Returns the exit status. Throws InputError.
int study(const Arguments& arguments, const StudyArguments& own);

}  // namespace spoke::cli
