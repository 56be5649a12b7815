// spoke doctor: what is there and what is missing.

#include <doctest/doctest.h>

#include <string>

#include "tests/contains.h"
#include "tests/program/cli/program.h"

using spoke::test::contains;

TEST_CASE("spoke doctor says what is installed, and what is missing with its package") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"doctor"}, folder);
  CHECK(ended.err.empty());
  REQUIRE(ended.status == 0);
  for (const char* part : {"arithmetic", "OpenMP", "libzip", "HDF5", "MPI", "esbuild", "commands",
                           "study", "cache", "results"})
    CHECK(contains(ended.out, part));
  const std::string version = run_spoke({"--version"}, folder).out;
  const std::size_t begin = version.find('(');
  if (begin != std::string::npos)
    CHECK(
        contains(ended.out, "commit " + version.substr(begin + 1, version.find(')') - begin - 1)));
  CHECK(folder.entries() == 0);
}

TEST_CASE("spoke doctor names programs that are not there") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"doctor"}, folder, "env PATH=/nowhere");
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "dot is missing: no pictures of graph.dot"));
  CHECK(contains(ended.out, "(Debian: graphviz)"));
}
