#include "bench/reproduce/inverse_part.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "bench/reproduce/timings.h"
#include "models/paper_rotor.h"

using namespace spoke;
using namespace spoke::reproduce;

namespace {

double seconds_of(const Scenario& scenario, std::int64_t steps) {
  InversePart part(scenario, {Formulation::subsystem, ExecutorKind::serial, 1});
  part.run(1);
  const auto begin = std::chrono::steady_clock::now();
  part.run(steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("the inverse part has a node for each body and its nodes work") {
  const InversePart part(paper_rotor(), {Formulation::subsystem, ExecutorKind::serial, 1});
  CHECK(part.nodes() == 12);
  const double share =
      measure_inverse_share(paper_rotor({"integration.step=8e-5"}), Formulation::subsystem);
  CHECK(share > 0.4);
  CHECK(share < 1.0);
  // Nodes that had nothing to do would take as long whatever the size of their blocks.
  CHECK(seconds_of(paper_rotor({"blade.elements=32"}), 20) > 5.0 * seconds_of(paper_rotor(), 20));
}

TEST_CASE("the inverse part runs on nested teams") {
  if (!has_schemes()) return;
  for (const int number : {1, 2}) {
    const compare::Configuration which = scheme(number, {3, 2});
    InversePart part(paper_rotor(), {which.formulation, which.executor, which.threads});
    part.run(2);
  }
}

TEST_CASE("every kind of work has a serial reference, and ratios are taken by rounds") {
  for (const Work work : {Work::steps, Work::inverse, Work::run}) {
    const auto list = configurations_of(work);
    CHECK(std::any_of(list.begin(), list.end(), [](const compare::Configuration& c) {
      return c.executor == ExecutorKind::serial;
    }));
  }
  Timings timings;
  compare::Measurement slow{.configuration = serial(Formulation::subsystem)};
  slow.step_times = {2.0, 4.0, 6.0};
  compare::Measurement fast{.configuration = scheme(1, 2)};
  fast.step_times = {1.0, 1.0};
  timings.set(Work::steps, {slow, fast});
  CHECK(timings.find(Work::steps, scheme(1, 2))->rounds == 2);
  CHECK(timings.ratio(Work::steps, serial(Formulation::subsystem), scheme(1, 2))->median == 3.0);
  CHECK_FALSE(timings.find(Work::steps, scheme(1, 3)));
  CHECK_FALSE(timings.find(Work::inverse, scheme(1, 2)));
}
