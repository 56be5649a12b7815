// Runs cases whose results are known, prints how they came out and writes verify.html, verify.csv,
// verify.json and the scenarios.

#include "program/cli/verify_command.h"

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <filesystem>

#include "engine/output_file.h"
#include "graph/executor.h"
#include "program/cli/file_guard.h"
#include "program/cli/interruption.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"
#include "program/verify/run_cases.h"
#include "program/verify/verify_files.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using verify::Case;
using verify::CaseFile;
using verify::CaseResult;
using verify::Tally;

void list_cases(const std::vector<Case>& cases) {
  report::Table table{.columns = {{"case"}, {"group"}, {"what"}}};
  for (const Case& one : cases) table.rows.push_back({{one.name, one.group, one.title}});
  print_table(table);
}

/// Writes the scenarios of cases to a folder.
void write_scenarios(const std::vector<CaseFile>& files, const fs::path& folder) {
  for (const CaseFile& file : files) {
    const fs::path place = (folder / file.path).parent_path();
    require_folder(place);
    fs::create_directories(place);
    require_places(folder, {file.path});
  }
  for (const CaseFile& file : files) replace_file((folder / file.path).string(), file.text);
}

void print(const std::vector<CaseResult>& results, const Tally& tally, double seconds,
           const fs::path& folder) {
  print_table(verify::make_table(results, false));
  print_line("verified", verify::describe(tally));
  for (const CaseResult& result : results)
    if (!result.failure.empty()) print_error(result.of.name + ": " + result.failure);
  print_line("took", fmt::format("{:.3g} s", seconds));
  print_line("written", (folder / "verify.html").string() +
                            ", verify.csv, verify.json; scenarios/ to run by hand");
}

}  // namespace

int verify(const Arguments& arguments, const VerifyArguments& own) {
  const std::vector<CaseFile> files =
      own.folder.empty() ? verify::copy_shipped_files() : verify::read_files(own.folder);
  const std::vector<Case> cases = verify::choose_cases(verify::read_all_cases(files), own.names);
  if (own.lists) {
    list_cases(cases);
    return 0;
  }
  const std::vector<CaseFile> needed = verify::find_needed_files(cases, files);
  const std::vector<std::string> names = {"verify.html", "verify.csv", "verify.json"};
  const fs::path folder =
      arguments.out.empty() ? fs::path("results") / "verify" : fs::path(arguments.out);
  require_folder(folder, names);
  const ResultsFolder taken(folder);
  write_scenarios(needed, folder / "scenarios");
  const int asked = arguments.options.threads.outer;
  const auto start = std::chrono::steady_clock::now();
  const CountProgress progress(cases.size(), "cases");
  const std::vector<CaseResult> results =
      verify::run_cases(cases, folder / "scenarios", asked > 0 ? asked : graph::available_threads(),
                        [&](std::size_t done) { progress.show(done); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  require_places(folder, names);
  write_together([&] {
    replace_file((folder / "verify.csv").string(), verify::make_csv(results));
    replace_file((folder / "verify.json").string(), verify::make_json(results));
    replace_file((folder / "verify.html").string(), verify::make_html(results));
  });
  const Tally tally = verify::count(results);
  if (arguments.prints_markdown)
    cli::print(verify::make_markdown(results));
  else
    print(results, tally, took.count(), folder);
  constexpr int kOff = 3;  // as of a run that diverged
  return tally.all_hold() ? 0 : kOff;
}

}  // namespace spoke::cli
