#include "bench/compare/span.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace spoke;

namespace {

/// a -> b -> d and a -> c -> d.
graph::StepGraph diamond(std::vector<double>& data) {
  data.assign(4, 0.0);
  graph::StepGraphBuilder builder;
  std::vector<graph::PartId> parts;
  for (std::size_t k = 0; k < 4; ++k)
    parts.push_back(builder.add_part(std::string(k + 1, 'p'), {graph::bytes_of(data[k])}));
  const auto add = [&](std::size_t k, std::vector<graph::PartId> reads) {
    builder.add_node({std::string(k + 1, 'n')}, graph::Reads{std::move(reads)},
                     graph::Writes{{parts[k]}}, [&data, k]() noexcept { data[k] += 1.0; });
  };
  add(0, {});
  add(1, {parts[0]});
  add(2, {parts[0]});
  add(3, {parts[1], parts[2]});
  return builder.build();
}

}  // namespace

TEST_CASE("work is the sum, span the costliest path") {
  std::vector<double> data;
  const graph::StepGraph graph = diamond(data);
  const std::vector<double> costs{1.0, 5.0, 2.0, 3.0};
  const compare::WorkAndSpan result = compare::calc_work_and_span(graph, costs);
  CHECK(result.work == 11.0);
  CHECK(result.span == 9.0);
}
