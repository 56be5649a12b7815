#include "tests/program/cli/refusal.h"

#include <doctest/doctest.h>

void check_refused(const std::vector<std::string>& arguments, const std::string& message,
                   const WorkFolder& folder, const std::string& before) {
  const int entries = folder.entries();
  const Ended ended = run_spoke(arguments, folder, before);
  CAPTURE(message);
  CAPTURE(ended.err);
  CHECK(ended.status == 2);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find(message) != std::string::npos);
  CHECK(folder.entries() == entries);
}

void check_refused(const std::vector<std::string>& arguments, const std::string& message) {
  check_refused(arguments, message, WorkFolder());
}
