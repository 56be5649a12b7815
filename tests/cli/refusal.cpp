#include "tests/cli/refusal.h"

#include <doctest/doctest.h>

void check_refused(const std::vector<std::string>& arguments, const std::string& message,
                   const WorkFolder& folder) {
  const int before = folder.entries();
  const Ended ended = run_spoke(arguments, folder);
  CAPTURE(message);
  CAPTURE(ended.err);
  CHECK(ended.status == 2);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find(message) != std::string::npos);
  CHECK(folder.entries() == before);
}

void check_refused(const std::vector<std::string>& arguments, const std::string& message) {
  check_refused(arguments, message, WorkFolder());
}
