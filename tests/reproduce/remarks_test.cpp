#include "engine/reproduce/remarks.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/reproduce/samples.h"

using namespace spoke;
using namespace spoke::reproduce;

namespace {

constexpr const char* kNothing = "Too little could be measured to say anything.";

void check_says(const std::string& text, const std::vector<std::string>& parts) {
  CAPTURE(text);
  for (const std::string& part : parts) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

void check_silent(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CHECK(text.find(part) == std::string::npos);
}

/// The dense serial step of 100 us, and both schemes on two and three threads [us].
Reproduction subsystem_threads(double one_2, double one_3, double two_2, double two_3) {
  return reproduction_of(Work::steps, {{serial(Formulation::subsystem), 100e-6},
                                       {scheme(1, 2), one_2 * 1e-6},
                                       {scheme(1, 3), one_3 * 1e-6},
                                       {scheme(2, 2), two_2 * 1e-6},
                                       {scheme(2, 3), two_3 * 1e-6}});
}

/// Both schemes on 3x1, 3x2 and 3x4, of steps or of the inverse part [us].
Times layers(double one_2, double one_4, double two_2, double two_4) {
  return {{scheme(1, {3, 1}), 50e-6},        {scheme(1, {3, 2}), one_2 * 1e-6},
          {scheme(1, {3, 4}), one_4 * 1e-6}, {scheme(2, {3, 1}), 50e-6},
          {scheme(2, {3, 2}), two_2 * 1e-6}, {scheme(2, {3, 4}), two_4 * 1e-6}};
}

/// The methods of Table 3, and Spoke's own [us].
Reproduction methods(double conventional, double parallel, double structured, double chosen) {
  return reproduction_of(Work::steps, {{serial(Formulation::augmented), conventional * 1e-6},
                                       {serial(Formulation::subsystem), 100e-6},
                                       {scheme(1, 3), parallel * 1e-6},
                                       {scheme(1, {3, 2}), 25e-6},
                                       {serial(Formulation::structured), structured * 1e-6},
                                       {automatic(Formulation::structured), chosen * 1e-6}});
}

}  // namespace

TEST_CASE("two schemes on threads for the subsystems: equal, or which is the faster") {
  if (!has_schemes()) return;
  check_says(remark_on_subsystem_threads(subsystem_threads(50, 40, 52, 41)),
             {"scheme 1 gains 2.00 on two threads and 2.50 on three, scheme 2 1.92 and 2.44",
              "the schemes are about equal, as in the paper", "Three blades on 2 processors"});
  check_says(remark_on_subsystem_threads(subsystem_threads(50, 40, 80, 70)),
             {"scheme 1 is clearly the faster, where the paper sees little difference"});
  check_says(remark_on_subsystem_threads(subsystem_threads(80, 70, 50, 40)),
             {"scheme 2 is clearly the faster, unlike in the paper"});
}

TEST_CASE("inner threads gain, or they do not, and scheme 2 suffers more, or it does not") {
  if (!has_schemes()) return;
  check_says(remark_on_layers(reproduction_of(Work::steps, layers(25, 60, 40, 90))),
             {"two inner threads gain over one, as in the paper",
              "scheme 1 takes 0.50 times its 3x1 on 3x2 and 1.20 times on 3x4, scheme 2 0.80 and "
              "1.80 times",
              "As in the paper, scheme 2 suffers more from more threads.", "GCC's OpenMP"});
  check_says(remark_on_layers(reproduction_of(Work::steps, layers(55, 90, 40, 60))),
             {"inner threads gain nothing over 3x1, unlike in the paper",
              "Unlike in the paper, scheme 2 does not suffer more."});
}

TEST_CASE("the inverse part falls with both schemes, or it does not") {
  Reproduction all = reproduction_of(Work::inverse, layers(30, 25, 30, 40));
  all.inverse_share = 0.621;
  check_says(remark_on_inverse(all), {"62 % of a step's work"});
  if (!has_schemes()) return;
  check_says(remark_on_inverse(all),
             {"3x4 takes 0.50 times what 3x1 takes with scheme 1, 0.80 times with scheme 2: it "
              "falls, as in the paper."});
  check_says(remark_on_inverse(reproduction_of(Work::inverse, layers(30, 25, 30, 60))),
             {"it does not fall with both, unlike in the paper"});
}

TEST_CASE("what is confirmed of the methods, and what is not") {
  const std::string good = remark_on_methods(methods(360, 40, 20, 12));
  check_says(good, {"The algorithm's gain is confirmed: conventional to subsystem is 3.6 in the "
                    "paper and 3.6 here",
                    "5.0 times faster than the subsystem one",
                    "auto takes 0.60 times that time, with threads."});
  const std::string bad = remark_on_methods(methods(140, 60, 20, 20));
  check_says(bad, {"The algorithm's gain is not confirmed", "1.4 here",
                   "steps of microseconds are best left to one thread."});
  check_silent(bad, "simulates the 20 s");
  if (!has_schemes()) return;
  check_says(good, {"The gain of threads is confirmed: subsystem to parallel is 2.77 there and "
                    "2.50 here on 2 processors, parallel to layered 3.6 there and 1.60 here."});
  check_says(bad, {"The gain of threads is not confirmed"});
}

TEST_CASE("the implicit run is told of where there is one") {
  Reproduction all = methods(360, 40, 20, 12);
  all.implicit = {.step = 0.05, .lag = 0.5, .error = 0.0012};
  add_times(Work::run, {{serial(Formulation::structured), 30e-6}}, all);
  check_says(remark_on_methods(all), {"An implicit step of 0.05 s simulates the 20 s in 12 ms; its "
                                      "largest lag differs by 0.12 % from"});
}

TEST_CASE("where too little was measured nothing is said") {
  const Reproduction none = reproduction_of(Work::steps, {});
  CHECK(remark_on_drive(none) == kNothing);
  CHECK(remark_on_methods(none) == kNothing);
  if (!has_schemes()) {
    CHECK(remark_on_layers(none).starts_with("This build is without OpenMP"));
    return;
  }
  CHECK(remark_on_subsystem_threads(none) == kNothing);
  CHECK(remark_on_layers(none) == kNothing);
  check_silent(remark_on_inverse(none), "as in the paper");
}

TEST_CASE("a busy machine is told of wherever threads are judged") {
  if (!has_schemes()) return;
  Reproduction all = subsystem_threads(50, 40, 52, 41);
  check_silent(remark_on_subsystem_threads(all), "The machine was busy meanwhile");
  all.loads.before = 1.1;  // more than half of two processors
  check_says(remark_on_subsystem_threads(all), {"The machine was busy meanwhile"});
}

TEST_CASE("where the rounds disagree there is no verdict") {
  if (!has_schemes()) return;
  // One round of three was as in the paper; its own 3x1 is 50 us.
  const auto times = [](double usual, double odd) {
    return std::vector{usual * 1e-6, odd * 1e-6, usual * 1e-6, odd * 1e-6};
  };
  const std::vector<double> flat = times(50, 50);
  const auto layers_of = [&](Work work) {
    return reproduction_of_rounds(work, {{scheme(1, {3, 1}), flat},
                                         {scheme(1, {3, 2}), times(30, 90)},
                                         {scheme(1, {3, 4}), times(30, 90)},
                                         {scheme(2, {3, 1}), flat},
                                         {scheme(2, {3, 2}), times(30, 90)},
                                         {scheme(2, {3, 4}), times(40, 80)}});
  };
  const std::string layers = remark_on_layers(layers_of(Work::steps));
  check_says(layers, {"whether inner threads gain is not to be told, for the times vary too much",
                      "Which scheme suffers more from more threads is not to be told."});
  check_silent(layers, "in the paper:");
  check_silent(layers, "as in the paper");
  check_says(remark_on_inverse(layers_of(Work::inverse)), {"whether it falls is not to be told"});
  CHECK(doubts_of(layers_of(Work::steps)) ==
        std::vector<std::string>{"Of 6 times, 4 have quartiles more than a factor of 1.5 apart: "
                                 "there is no verdict where that leaves it open."});

  const auto threads = [&](const std::vector<double>& one_2) {
    return reproduction_of_rounds(Work::steps, {{serial(Formulation::subsystem), times(100, 100)},
                                                {scheme(1, 2), one_2},
                                                {scheme(1, 3), flat},
                                                {scheme(2, 2), flat},
                                                {scheme(2, 3), flat}});
  };
  check_says(remark_on_subsystem_threads(threads(times(40, 70))),
             {"which scheme is faster is not to be told"});
  check_says(remark_on_subsystem_threads(threads({25e-6, 25e-6})),  // too few rounds
             {"which scheme is faster is not to be told"});
}

TEST_CASE("of a busy machine there is no verdict on threads, whatever was measured") {
  if (!has_schemes()) return;
  Reproduction all = methods(360, 40, 20, 12);
  all.loads.before = 1.1;
  const std::string text = remark_on_methods(all);
  check_says(text, {"The algorithm's gain is confirmed", "The gain of threads is not to be told",
                    "auto takes 0.60 times that time."});
  CHECK(doubts_of(all).size() == 1);
  CHECK(doubts_of(methods(360, 40, 20, 12)).empty());
}

TEST_CASE("a small ratio is never written as zero") {
  if (!has_schemes()) return;
  const Reproduction all = subsystem_threads(50, 40, 5e4, 7e4);  // scheme 2 waits for processors
  check_says(remark_on_subsystem_threads(all), {"scheme 2 0.0020 and 0.0014"});
  check_silent(remark_on_subsystem_threads(all), "0.00 ");
}
