// The stop time of an importer: FMI 2.0 (fmi2SetupExperiment) and FMI 3.0
// (fmi3EnterInitializationMode) want an error for a step beyond it.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/fmu/go_on.h"
#include "tests/program/fmu/importer.h"
#include "tests/program/fmu/importer_2.h"
#include "tests/program/fmu/unpacked_fmu.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Goes to the stop time, 10.06 s, by steps of `step` from 10 s on, and asks for more.
template <class Instance>
void go_to_stop(Instance& instance, Instance& unbound, Instance& late, const std::string& version) {
  const double step = 0.02;
  CHECK(instance.initialize(10.0, 10.06) == kOk);
  CHECK(unbound.initialize(10.0) == kOk);
  // What is left is less than the step: nothing of it is made.
  CHECK(instance.step(10.0, 4 * step) == kError);
  CHECK(instance.messages.back().category == "logStatusError");
  CHECK(contains(instance.last(), version + "DoStep: "));
  CHECK(contains(instance.last(), "goes to 10.08 s"));
  CHECK(contains(instance.last(), "the stop time, 10.06 s"));
  // The sums of steps reach the stop time by round-off only.
  CHECK(go_on(instance, 10.0, step, 3) == go_on(unbound, 10.0, step, 3));
  const std::vector<double> last = instance.outputs();
  CHECK(instance.step(10.06, step) == kError);
  CHECK(instance.outputs() == last);
  CHECK(unbound.step(10.06, step) == kOk);
  // It is part of the state, by way of bytes too, and a reset takes it away.
  void* state = nullptr;
  CHECK(instance.get_state(&state) == kOk);
  void* read = nullptr;
  CHECK(late.deserialize(instance.serialize(state), &read) == kOk);
  CHECK(late.set_state(read) == kOk);
  CHECK(late.step(10.06, step) == kError);
  CHECK(contains(late.last(), "the stop time, 10.06 s"));
  CHECK(instance.call((version + "Reset").c_str()) == kOk);
  CHECK(instance.initialize(10.0) == kOk);
  go_on(instance, 10.0, step, 3);
  CHECK(instance.step(10.06, step) == kOk);
  CHECK(instance.outputs() == unbound.outputs());
}

}  // namespace

TEST_CASE(
    "a step beyond the stop time is an error with a sentence, and without one there is none") {
  {
    const UnpackedFmu unpacked(kPitchedRotor);
    const LoadedFmu fmu(unpacked.folder());
    FmuInstance instance(fmu), unbound(fmu), late(fmu);
    go_to_stop(instance, unbound, late, "fmi3");
  }
  const UnpackedFmu unpacked(kPitchedRotor, {}, {}, {}, fmu::FmiVersion::two);
  const LoadedFmu fmu(unpacked.folder());
  Fmu2Instance instance(fmu), unbound(fmu), late(fmu);
  go_to_stop(instance, unbound, late, "fmi2");
}
