// Reads the shipped cases, and runs them on threads that take one after another.

#include "program/verify/run_cases.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "models/error.h"
#include "models/scenario.h"
#include "models/support/nearest_name.h"
#include "models/text_file.h"
#include "program/verify/case_reader.h"
#include "program/verify/evaluate.h"
#include "program/verify/shipped_files.h"

namespace spoke::verify {
namespace {

const std::string kCases = "cases/", kScenarios = "scenarios/", kMeshes = "meshes/";

const std::string& find_text(const std::string& path, const Case& one,
                             const std::vector<CaseFile>& files) {
  for (const CaseFile& file : files)
    if (file.path == path) return file.text;
  throw InputError("case \"" + one.name + "\": there is no file \"" + path + '"');
}

/// Appends the files of a folder whose names have this ending; their paths begin with `below`.
void append_files(const std::filesystem::path& folder, const std::string& below,
                  const std::string& ending, std::vector<CaseFile>& files) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ending) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const std::filesystem::path& path : paths)
    files.push_back({below + path.filename().string(), read_text(path)});
}

CaseResult run_case(const Case& one, const std::filesystem::path& folder) {
  CaseResult result{.of = one};
  const auto start = std::chrono::steady_clock::now();
  try {
    const std::string file = (folder / (one.scenario + ".toml")).string();
    result.values = evaluate(one, read_scenario(file, one.overrides));
  } catch (const std::exception& error) {  // a fault of one case is no reason to lose the others
    result.failure = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

std::vector<CaseFile> copy_shipped_files() {
  std::vector<CaseFile> files;
  for (const ShippedFile& file : shipped_files())
    files.push_back({std::string(file.path), std::string(file.text)});
  return files;
}

std::vector<CaseFile> read_files(const std::filesystem::path& folder) {
  std::vector<CaseFile> files;
  append_files(folder / kCases, kCases, ".toml", files);
  if (files.empty())
    throw InputError(folder.string() + ": has no cases, expected files cases/*.toml");
  append_files(folder / kScenarios, kScenarios, ".toml", files);
  append_files(folder / kScenarios / kMeshes, kMeshes, ".inp", files);
  for (CaseFile& file : copy_shipped_files())
    if (!file.path.starts_with(kCases)) files.push_back(std::move(file));
  return files;
}

std::vector<Case> read_all_cases(const std::vector<CaseFile>& files) {
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const CaseFile& file : files) {
    if (!file.path.starts_with(kCases)) continue;
    for (Case& one : read_cases(file.text, file.path)) {
      if (!names.insert(one.name).second)
        throw InputError(file.path + ": there are two cases \"" + one.name + '"');
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

std::vector<Case> choose_cases(const std::vector<Case>& cases,
                               const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  for (const Case& one : cases) known.insert(known.end(), {one.name, one.group});
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const auto nearest = nearest_name(name, known);
      throw InputError("there is no case or group \"" + name + "\", " +
                       (nearest ? "did you mean \"" + std::string(*nearest) + "\"?"
                                : "expected one of those that --list prints"));
    }
  std::vector<Case> chosen;
  for (const Case& one : cases)
    if (names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
          return name == one.name || name == one.group;
        }))
      chosen.push_back(one);
  return chosen;
}

std::vector<CaseFile> find_needed_files(const std::vector<Case>& cases,
                                        const std::vector<CaseFile>& files) {
  std::vector<CaseFile> needed;
  std::set<std::string> seen;
  std::string texts;
  for (const Case& one : cases) {
    const std::string name = one.scenario + ".toml";
    if (!seen.insert(name).second) continue;
    const std::string& text = find_text(kScenarios + name, one, files);
    texts += text;
    needed.push_back({name, "# A scenario of spoke verify.\n" + text});
  }
  for (const CaseFile& file : files) {
    const bool is_read = !file.path.starts_with(kCases) && !file.path.starts_with(kScenarios);
    if (!is_read || texts.find(file.path) == std::string::npos) continue;
    const bool is_mesh = file.path.starts_with(kMeshes);
    needed.push_back(
        {file.path,
         (is_mesh ? "** A mesh of spoke verify.\n" : "# A polar of spoke verify.\n") + file.text});
  }
  return needed;
}

bool CaseResult::holds() const {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!verify::holds(of.figures[k], values[k])) return false;
  return !values.empty();
}

double error_of(const Figure& figure, double value) {
  return std::abs(value - figure.exact) / figure.scale;
}

bool holds(const Figure& figure, double value) { return error_of(figure, value) <= figure.error; }

std::vector<CaseResult> run_cases(const std::vector<Case>& cases,
                                  const std::filesystem::path& folder, int threads,
                                  const std::function<void(std::size_t)>& progress) {
  std::vector<CaseResult> results(cases.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // of progress
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < cases.size(); k = next++) {
      results[k] = run_case(cases[k], folder);
      const std::lock_guard lock(mutex);
      progress(++done);
    }
  };
  std::vector<std::jthread> others;
  for (int k = 1; k < threads; ++k) others.emplace_back(work);
  work();
  others.clear();
  return results;
}

Tally count(const std::vector<CaseResult>& results) {
  Tally tally{.cases = results.size()};
  for (const CaseResult& result : results) {
    tally.figures += result.of.figures.size();
    for (std::size_t k = 0; k < result.values.size(); ++k)
      if (holds(result.of.figures[k], result.values[k])) ++tally.held;
  }
  return tally;
}

}  // namespace spoke::verify
