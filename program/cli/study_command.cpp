// Makes the runs of a study, and writes its files.

#include "program/cli/study_command.h"

#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "engine/output_file.h"
#include "graph/executor.h"
#include "models/count_text.h"
#include "models/error.h"
#include "program/cli/file_guard.h"
#include "program/cli/interruption.h"
#include "program/cli/progress.h"
#include "program/cli/report.h"
#include "program/cli/results_folder.h"
#include "program/cli/standard_streams.h"
#include "program/report/markup.h"
#include "program/study/analyse.h"
#include "program/study/files.h"
#include "program/study/hdf5_file.h"
#include "program/study/ranks.h"
#include "program/study/runner.h"
#include "program/study/study_reader.h"
#include "program/study_report/html_file.h"

namespace spoke::cli {
namespace {

namespace fs = std::filesystem;
using study::Analysis;
using study::Journal;
using study::LoadAnalysis;
using study::Response;
using study::ResponseKind;
using study::Sampling;
using study::Study;

constexpr std::size_t kMostLines = 12;  // printed responses

/// A finished journal, with the study and the sampling that its runs belong to.
struct Finished {
  const Study& study;
  const Sampling& sampling;
  const Journal& journal;

  void for_each(const study::Visitor& visit) const {
    for (std::int64_t run = 0; run < study.design.runs; ++run) visit(journal.read(run));
  }
};

/// Throws InputError if a file could not be written, while the files of an earlier study are still
/// there, or if the runs of an unfinished one would be lost.
void require_place(const fs::path& folder, bool resumes) {
  require_folder(folder, {"runs.csv", "histories.csv", "statistics.csv", "extremes.csv",
                          "lifetime.csv", "by_speed.csv", "study.json", "study.html", "study.h5"});
  if (resumes) return;
  require_places(folder, {"study.journal"});
  const std::string journal = (folder / "study.journal").string();
  const auto found = study::find_journal(journal);
  if (found && found->runs < found->planned)
    throw InputError(
        fmt::format("{}: has {} of {} runs of a study that was not ended, expected "
                    "--resume, or another folder (or remove the file)",
                    journal, found->runs, found->planned));
}

/// Makes the runs that the journal lacks. Returns false if a signal ended them early.
bool make_runs(const Study& study, const Sampling& sampling, int threads, Journal& journal,
               study::Ranks& ranks) {
  constexpr std::chrono::seconds kPause{5};  // between waits for the disk
  auto synced = std::chrono::steady_clock::now();
  StudyProgress progress(journal.count(), study.design.runs);
  study::JournalExchange exchange(journal, study.design.runs, [&](std::int64_t done) {
    progress.update(done);
    if (const auto now = std::chrono::steady_clock::now(); now - synced > kPause) {
      synced = now;
      journal.sync();
    }
    return Interruption::signal() == 0;
  });
  ranks.make_runs_together(study, sampling, threads, exchange);
  journal.sync();
  return journal.is_complete();
}

/// Writes a file that may be larger than memory.
template <class Write>
void replace_by(const fs::path& file, const Write& write) {
  constexpr std::size_t kBuffer = 1 << 20;
  ReplacedFile replaced(file.string());
  std::string waiting;
  write([&](std::string_view piece) {
    waiting += piece;
    if (waiting.size() < kBuffer) return;
    replaced.append(waiting);
    waiting.clear();
  });
  replaced.append(waiting);
  replaced.commit();
}

/// Writes a file where a study has it, and names it in `written`; otherwise removes that of an
/// earlier study.
template <class Write>
void replace_if(bool has_it, const fs::path& file, std::string& written, const Write& write) {
  if (has_it) {
    replace_by(file, write);
    written += ", " + file.filename().string();
  } else {
    std::error_code none;
    fs::remove(file, none);
  }
}

/// Writes the files of statistics.
void write_loads(const Study& study, const study::ForEachRun& for_each,
                 const std::optional<LoadAnalysis>& loads, const fs::path& folder,
                 std::string& written) {
  using study::Sink;
  replace_if(loads.has_value(), folder / "statistics.csv", written,
             [&](const Sink& sink) { study::write_statistics_csv(study, for_each, sink); });
  replace_if(loads.has_value(), folder / "extremes.csv", written,
             [&](const Sink& sink) { study::write_extremes_csv(study, *loads, sink); });
  replace_if(loads && loads->has_hours, folder / "lifetime.csv", written,
             [&](const Sink& sink) { study::write_lifetime_csv(study, *loads, sink); });
  replace_if(loads && !loads->groups.empty(), folder / "by_speed.csv", written,
             [&](const Sink& sink) { study::write_by_speed_csv(study, *loads, sink); });
}

std::string write_results(const Finished& all, const Analysis& analysis, const fs::path& folder) {
  const study::ForEachRun for_each = [&](const study::Visitor& visit) { all.for_each(visit); };
  std::optional<LoadAnalysis> loads;
  if (all.study.statistics) loads = study::analyse_loads(all.study, all.sampling, for_each);
  replace_by(folder / "runs.csv", [&](const study::Sink& sink) {
    study::write_runs_csv(all.study, all.sampling, for_each, sink);
  });
  std::string written = (folder / "runs.csv").string() + ", study.json, study.html";
  replace_file((folder / "study.json").string(),
               study::make_json(all.study, all.sampling, analysis));
  replace_file((folder / "study.html").string(),
               study_report::make_html(all.study, all.sampling, for_each, analysis, loads));
  replace_if(
      all.study.has_histories(), folder / "histories.csv", written,
      [&](const study::Sink& sink) { study::write_histories_csv(all.study, for_each, sink); });
  write_loads(all.study, for_each, loads, folder, written);
  std::error_code none;
  if (study::has_hdf5()) {
    study::write_hdf5((folder / "study.h5").string(), all.study, all.sampling, for_each);
    written += ", study.h5";
  } else {
    fs::remove(folder / "study.h5", none);  // belongs to an earlier study
  }
  return written;
}

std::string describe_design(const Study& study) {
  std::string text =
      fmt::format("{}, {}", study::name_of(study.design.kind), counted(study.design.runs, "run"));
  text += " of " + study.scenario_file;
  return text;
}

std::string describe_response(const Response& response, const study::Summary& summary) {
  if (summary.count == 0) return response.name + ": no run has it";
  const auto text = [&](double value) { return report::quantity(value, response.unit, 4); };
  return fmt::format("{}: {} (run {}) to {} (run {}), mean {}, deviation {}", response.name,
                     text(summary.min), summary.run_of_min + 1, text(summary.max),
                     summary.run_of_max + 1, text(summary.mean), text(summary.deviation));
}

void print_result(const Study& study, const Analysis& analysis, const std::string& written) {
  const study::RunCounts& counts = analysis.counts;
  std::string runs = fmt::format("{} done", counts.done);
  if (counts.doubtful > 0) runs += fmt::format(", {} doubtful", counts.doubtful);
  if (counts.diverged > 0) runs += fmt::format(", {} diverged", counts.diverged);
  if (counts.refused > 0) runs += fmt::format(", {} refused by the scenario", counts.refused);
  print_line("runs", runs);
  std::size_t lines = 0;
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    if (study.responses[k].kind == ResponseKind::history) continue;
    if (lines < kMostLines)
      print_line(lines == 0 ? "responses" : "",
                 describe_response(study.responses[k], analysis.responses[k].summary));
    ++lines;
  }
  if (lines > kMostLines)
    print_line("", fmt::format("{} more: see study.json", lines - kMostLines));
  print_line("written", written);
}

/// Makes runs for the first rank. Returns the exit status.
int help_first(const StudyArguments& own, int threads, study::Ranks& ranks) {
  const std::uint64_t announced = ranks.hear();
  if (announced == 0) return 0;
  const Interruption interruption;  // the first one ends the study in order
  Study study = study::read_study(own.study);
  if (study::fingerprint(study) != announced)
    throw InputError(own.study +
                     ": is not what the first rank reads, or the processor is of another kind; "
                     "expected the same files, and --instructions baseline on different ones");
  study::check_study(study);  // finds the sensors of statistics
  ranks.make_runs_for_first(study, Sampling(study), threads);
  return 0;
}

/// A study with its locked folder and its journal.
struct PreparedStudy {
  PreparedStudy(const Arguments& arguments, const StudyArguments& own)
      : study(read(own)),
        sampling(study),
        folder(arguments.out.empty() ? fs::path("results") / study.name : fs::path(arguments.out)) {
    require_place(folder, own.resumes);
    taken.emplace(folder);
    // A study that was killed before it had a journal has nothing to resume, and begins.
    const fs::path file = folder / "study.journal";
    std::error_code none;
    resumes = own.resumes && fs::exists(file, none);
    journal.emplace(file.string(), study, resumes ? Journal::Start::resumed : Journal::Start::anew);
  }

  static Study read(const StudyArguments& own) {
    Study study = study::read_study(own.study);
    study::check_study(study);
    return study;
  }

  Study study;
  Sampling sampling;
  fs::path folder;
  std::optional<ResultsFolder> taken;
  std::optional<Journal> journal;
  bool resumes = false;
};

void print_plan(const PreparedStudy& prepared) {
  print_title(prepared.study.title);
  print_line("study", describe_design(prepared.study));
  if (prepared.resumes)
    print_line("resumed", "behind " + counted(prepared.journal->count(), "run"));
  flush_output();
}

void print_time(std::int64_t runs, double seconds, int threads, int ranks) {
  std::string text = fmt::format("{:.3g} s, {:.3g} runs a second on {}", seconds,
                                 static_cast<double>(runs) / seconds, counted(threads, "thread"));
  if (ranks > 1) text += fmt::format(" of each of {} ranks", ranks);
  print_line("took", text);
}

/// Makes the runs and writes the study's files. Returns the exit status.
int complete(PreparedStudy& prepared, bool quiet, int threads, study::Ranks& ranks) {
  const Study& study = prepared.study;
  Journal& journal = *prepared.journal;
  if (!quiet) print_plan(prepared);
  const Interruption interruption;
  const auto start = std::chrono::steady_clock::now();
  const std::int64_t before = journal.count();
  if (!make_runs(study, prepared.sampling, threads, journal, ranks)) {
    print_error(fmt::format("interrupted by {} behind {} of {} runs; go on with --resume",
                            name_of_signal(Interruption::signal()), journal.count(),
                            study.design.runs));
    return 128 + Interruption::signal();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (!quiet && journal.count() > before)
    print_time(journal.count() - before, took.count(), threads, ranks.count());
  const Finished all{study, prepared.sampling, journal};
  const Analysis analysis = study::analyse(
      study, prepared.sampling, [&](const study::Visitor& visit) { all.for_each(visit); });
  const std::string written = write_results(all, analysis, prepared.folder);
  if (!quiet) print_result(study, analysis, written);
  return 0;
}

/// Prints the runs of a study as a table.
int list(const StudyArguments& own) {
  const Study study = study::read_study(own.study);
  study::write_table(study, Sampling(study), [](std::string_view line) { print(line); });
  return 0;
}

}  // namespace

int study(const Arguments& arguments, const StudyArguments& own) {
  if (own.lists) return list(own);
  const int asked = arguments.options.threads.outer;
  const int threads = asked > 0 ? asked : graph::available_threads();
  study::Ranks ranks;
  if (!ranks.is_first()) return help_first(own, threads, ranks);
  std::optional<PreparedStudy> prepared;
  try {
    prepared.emplace(arguments, own);
  } catch (...) {
    ranks.announce(0);
    throw;
  }
  ranks.announce(study::fingerprint(prepared->study));
  return complete(*prepared, arguments.quiet, threads, ranks);
}

}  // namespace spoke::cli
