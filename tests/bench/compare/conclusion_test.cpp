#include "bench/compare/conclusion.h"

#include <doctest/doctest.h>

#include "graph/machine/duration_text.h"
#include "tests/bench/compare/samples.h"

using namespace spoke;
using namespace spoke::compare;

namespace {

const Measurement kTen = measurement_of(kSerial, 1, {10e-6, 10e-6, 10e-6, 10e-6});

void check_says(const Comparison& comparison, const std::vector<std::string>& parts) {
  const std::string text = make_conclusion(comparison);
  CAPTURE(text);
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
  CHECK(text.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("the best is named with its gain, and who equals it") {
  check_says(comparison_of({kTen, measurement_of(kFlow, 1, {11e-6, 11e-6}),
                            measurement_of(kFlow, 2, {5.5e-6, 5.6e-6}),
                            measurement_of(kFlow, 3, {5.5e-6, 5.65e-6})}),
             {"structured: flow_graph 2 is best with 5.55 us a step, 1.80 times serial's speed",
              "1.11 of the bound", "not told from it: flow_graph 3", "same bits as serial",
              "1 of 4 has more threads than processors: it shows what",
              "Of flow_graph and openmp_scheme1 no more threads work than",
              "Some processor, 2 processors", "load average 0.10 before and 1.00 after"});
}

TEST_CASE("where serial wins or nothing is told, it says so") {
  check_says(comparison_of({kTen, measurement_of(kFlow, 2, {20e-6, 20e-6})}),
             {"structured: serial wins with 10 us a step; the next, flow_graph 2, has 0.50 times"});
  check_says(comparison_of({kTen, measurement_of(kFlow, 2, {9.9e-6, 9.8e-6})}),
             {"nothing is clearly faster than serial"});
  check_says(comparison_of({kTen}),
             {"serial takes 10 us a step; nothing else was measured with its bits"});
}

TEST_CASE("nothing is said of bits where serial is alone") {
  const auto says_bits = [](std::vector<Measurement> measurements) {
    return make_conclusion(comparison_of(std::move(measurements))).find("same bits") !=
           std::string::npos;
  };
  Measurement failed = measurement_of(kFlow, 2, {});
  failed.hashes.clear();
  failed.status = Status::failed;
  CHECK_FALSE(says_bits({kTen}));
  CHECK_FALSE(says_bits({kTen, failed}));
  CHECK(says_bits({kTen, failed, measurement_of(kFlow, 3, {9e-6})}));
}

TEST_CASE("what cannot be is no verdict") {
  check_says(comparison_of({kTen, measurement_of(kFlow, 2, {3e-6, 3e-6})}),
             {"structured: no verdict", "more than work and span allow"});
}

TEST_CASE("faults are counted") {
  Measurement other = measurement_of(kFlow, 2, {4e-6});
  other.hashes.back() = 99;
  Measurement silent = measurement_of(kFlow, 3, {});
  silent.status = Status::no_answer;
  Measurement slow = measurement_of(kFlow, 4, {500e-6, 500e-6});
  slow.status = Status::slow;
  check_says(comparison_of({kTen, other, silent, slow}),
             {"1 of 4 ended in bits other than serial's", "1 of 4 gave no answer in time",
              "1 of 4 was so slow", "serial wins"});
}

TEST_CASE("a busy machine makes everything doubtful, first of all") {
  Comparison comparison = comparison_of({kTen});
  comparison.loads.before = 5.5;
  CHECK(make_conclusion(comparison).starts_with("Other work was running (load average 5.50"));
  comparison.loads.before = 1.1;  // more than half of two processors
  CHECK(make_conclusion(comparison).starts_with("Other work was running"));
  comparison.loads.before = 0.9;
  CHECK(make_conclusion(comparison).starts_with("structured: "));
  comparison.loads.before = -1.0;
  check_says(comparison, {"its load is not known"});
}

TEST_CASE("times for people") {
  CHECK(graph::duration_text(13.4e-6) == "13.4 us");
  CHECK(graph::duration_text(2.04e-3) == "2.04 ms");
  CHECK(graph::duration_text(1.5) == "1.5 s");
}
