#include "tests/program/cli/run_ranks.h"

#include "tests/program/cli/program.h"

using nlohmann::json;

json figures_in(const std::filesystem::path& folder) {
  json summary = json::parse(file_text(folder / "summary.json"));
  for (const char* field : {"wall_time_s", "threads", "processes", "machine", "executor_choice"})
    summary.erase(field);
  return summary;
}

std::vector<std::string> run_of(const std::string& scenario, const std::string& duration,
                                const std::vector<std::string>& further) {
  std::vector<std::string> words{
      "run", shipped(scenario), "--quiet", "--set", "integration.duration=" + duration, "--threads",
      "1"};
  words.insert(words.end(), further.begin(), further.end());
  return words;
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}
