// The program "spoke-study", which `spoke study` starts.

#include <CLI/CLI.hpp>
#include <filesystem>

#include "graph/executor.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"
#include "program/cli/study_command.h"
#include "program/study/journal.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::StudyArguments;

const char* const kStudyText =
    R"(A study names a scenario, parameters of it, the design that says which values they take together,
and responses. Each run is made on one thread, as many at once as there are threads; results do not
depend on their number. A run that diverges is a row that says why.

Output files, in the folder of --out:
  runs.csv        a row per run: status, parameters, responses, diagnosis
  histories.csv   a row per run and time, if the study asks for histories
  study.json      extremes, means, main effects and Sobol indices of the responses
  study.html      the runs to look at: points, parallel coordinates, effects; needs no network
  statistics.csv  a row per run and sensor, if the study asks for statistics; extremes.csv has the
                  extremes with what is measured at the same time, lifetime.csv damage-equivalent
                  loads over the hours of a lifetime, by_speed.csv statistics by wind speed
  study.h5        parameters, responses and histories as HDF5, if the program was built with it
  study.journal   the runs as they ended: what --resume goes on from, whenever the study was killed

The first Ctrl-C (SIGINT), SIGTERM or SIGHUP completes the runs that have begun, and ends; a second
one ends at once.

Example:
  spoke study models/studies/blade_stiffness.toml --threads 2
)";

const char* const kStudyStatusText = R"(Exit status:
  0  done; runs that diverged are rows
  1  a fault in spoke itself
  2  bad command line, study or scenario, or output that cannot be written;
     the message on stderr says file:line:column, key, what is wrong and what is expected
  129, 130, 143  SIGHUP, SIGINT or SIGTERM ended it; go on with --resume
)";

void add_options(CLI::App& command, Arguments& arguments, StudyArguments& own) {
  command.add_option("STUDY", own.study, "Study file (TOML; see docs/studies.md)")
      ->required()
      ->type_name("FILE");
  cli::add_out(command, arguments, "results/<name of the study>");
  command
      .add_option("--threads", arguments.options.threads.outer,
                  "Runs at once, each on a thread [the cores available]")
      ->check(CLI::Range(1, graph::kMostThreads))
      ->type_name("N");
  command.add_flag("--resume", own.resumes,
                   "Go on with the study that was begun in the folder, if one was");
  command.add_flag("--list", own.lists,
                   "Print the runs as a table (CSV), which a design takes, and make none");
  cli::add_instructions(command, arguments);
  command.add_flag("--quiet", arguments.quiet, "Print nothing but warnings and errors");
  command.add_flag("-v,--verbose", arguments.verbosity, "Log to stderr; -vv logs more");
  command.footer(std::string(kStudyText) + '\n' + kStudyStatusText);
}

/// Returns the path of the journal that is resumed, as study_command.cpp has it: in a folder named
/// after the study's file.
std::filesystem::path journal_of(const Arguments& arguments, const StudyArguments& own) {
  const std::filesystem::path folder = arguments.out.empty()
                                           ? "results" / std::filesystem::path(own.study).stem()
                                           : std::filesystem::path(arguments.out);
  return folder / "study.journal";
}

std::string instructions_before(const Arguments& arguments, const StudyArguments& own) {
  if (!own.resumes) return {};
  const auto journal = study::find_journal(journal_of(arguments, own).string());
  return journal ? journal->instructions : std::string();
}

}  // namespace

int main(int argc, char** argv) {
  StudyArguments own;
  return cli::run_program(
      {.name = "study",
       .summary = cli::kStudySummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::study(arguments, own); },
       .instructions_before =
           [&](const Arguments& arguments) { return instructions_before(arguments, own); }},
      argc, argv);
}
