#include "tests/program/study/studies.h"

#include <string>

#include "program/study/analyse.h"

namespace spoke::test {

using namespace spoke::study;

Study make_study(DesignKind kind, int parameters, double low, double high,
                 std::int64_t runs_or_points) {
  Study study;
  study.design.kind = kind;
  study.design.seed = 5;
  const bool is_saltelli = kind == DesignKind::saltelli;
  study.design.points = is_saltelli ? runs_or_points : 0;
  study.design.runs = runs_or_points * (is_saltelli ? parameters + 2 : 1);
  for (int i = 1; i <= parameters; ++i) {
    Parameter parameter;
    parameter.name = parameter.key = "x" + std::to_string(i);
    parameter.kind = ParameterKind::uniform;
    parameter.low = low;
    parameter.high = high;
    study.parameters.push_back(parameter);
  }
  study.responses.emplace_back();
  study.responses.back().name = "y";
  return study;
}

Analysis analyse_function(const Study& study,
                          const std::function<double(const std::vector<double>&)>& function) {
  const Sampling sampling(study);
  return analyse(study, sampling, [&](const Visitor& visit) {
    for (std::int64_t run = 0; run < study.design.runs; ++run) {
      RunResult result;
      result.run = run;
      result.responses = {function(sampling.values(run))};
      visit(result);
    }
  });
}

}  // namespace spoke::test
