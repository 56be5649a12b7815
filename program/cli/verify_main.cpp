// The program "spoke-verify", which `spoke verify` starts.

#include <CLI/CLI.hpp>

#include "graph/executor.h"
#include "program/cli/help_texts.h"
#include "program/cli/program.h"
#include "program/cli/shared_options.h"
#include "program/cli/verify_command.h"

namespace {

using namespace spoke;
using cli::Arguments;
using cli::VerifyArguments;

const char* const kVerifyText =
    R"(Each case is a scenario, an analysis of it, and figures with published or exact values and the error
that is allowed. Each is computed on one thread, as many at once as there are threads.

Output files, in the folder of --out:
  verify.html   the cases by group, with sources; needs no network
  verify.csv    a row per figure
  verify.json   the same, with the commands that make the cases by hand
  scenarios/    the scenarios of these commands

Examples:
  spoke verify
  spoke verify --list
  spoke verify beck_column "Rotating beams"
)";

const char* const kVerifyStatusText = R"(Exit status:
  0  all figures are within their stated errors
  1  a fault in spoke itself
  2  bad command line, or output that cannot be written
  3  a figure is not within its stated error, or a case failed
)";

void add_options(CLI::App& command, Arguments& arguments, VerifyArguments& own) {
  command.add_option("NAME", own.names, "Cases, or groups of cases [all]")->type_name("");
  cli::add_out(command, arguments, "results/verify");
  command
      .add_option("--threads", arguments.options.threads.outer,
                  "Cases at once, each on a thread [the cores available]")
      ->check(CLI::Range(1, graph::kMostThreads))
      ->type_name("N");
  cli::add_path(command, "--cases", own.folder,
                "Take the cases of this folder in place of Spoke's: cases/*.toml, scenarios/*.toml",
                "DIR");
  CLI::Option* const list = command.add_flag("--list", own.lists, "Print the cases, and run none");
  command
      .add_flag("--markdown", arguments.prints_markdown,
                "Print the results as a page in Markdown, as docs/verification.md is made")
      ->excludes(list);
  cli::add_instructions(command, arguments);
  command.add_flag("-v,--verbose", arguments.verbosity, "Log to stderr; -vv logs more");
  command.footer(std::string(kVerifyText) + '\n' + kVerifyStatusText);
}

}  // namespace

int main(int argc, char** argv) {
  VerifyArguments own;
  return cli::run_program(
      {.name = "verify",
       .summary = cli::kVerifySummary,
       .add_options = [&](CLI::App& command,
                          Arguments& arguments) { add_options(command, arguments, own); },
       .execute = [&](const Arguments& arguments) { return cli::verify(arguments, own); }},
      argc, argv);
}
