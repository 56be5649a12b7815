#include "program/study/sampling.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "program/study/random_bits.h"
#include "program/study/sobol_sequence.h"
#include "tests/program/study/studies.h"

using namespace spoke::study;
using spoke::test::make_study;

TEST_CASE("the first Sobol points are those that Joe and Kuo publish with their program") {
  constexpr std::array<std::array<double, 3>, 10> published = {{{0.0, 0.0, 0.0},
                                                                {0.5, 0.5, 0.5},
                                                                {0.75, 0.25, 0.25},
                                                                {0.25, 0.75, 0.75},
                                                                {0.375, 0.375, 0.625},
                                                                {0.875, 0.875, 0.125},
                                                                {0.625, 0.125, 0.875},
                                                                {0.125, 0.625, 0.375},
                                                                {0.1875, 0.3125, 0.9375},
                                                                {0.6875, 0.8125, 0.4375}}};
  const SobolSequence sequence(3);
  for (std::size_t i = 0; i < published.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      CHECK(sequence.coordinate(i, static_cast<int>(d)) * 0x1p-32 == published[i][d]);
}

TEST_CASE("every coordinate of 2^k Sobol points takes every multiple of 2^-k once") {
  const SobolSequence sequence(kMostSobolDimensions);
  for (int d = 0; d < kMostSobolDimensions; ++d) {
    std::set<std::uint32_t> parts;
    for (std::uint64_t i = 0; i < 256; ++i) parts.insert(sequence.coordinate(i, d) >> 24);
    CHECK(parts.size() == 256);
  }
}

TEST_CASE("no two dimensions of the Sobol sequence are alike") {
  const SobolSequence sequence(kMostSobolDimensions);
  std::set<std::uint64_t> seen;
  for (int d = 0; d < kMostSobolDimensions; ++d) {
    std::uint64_t bits = 0;
    for (std::uint64_t i = 0; i < 64; ++i) bits = bits * 31 + sequence.coordinate(i * 37 + 5, d);
    CHECK(seen.insert(bits).second);
  }
}

TEST_CASE("permutations are permutations, and differ by seed and stream") {
  for (const std::uint64_t count : {1U, 2U, 3U, 16U, 17U, 100U, 1000U}) {
    std::set<std::uint64_t> images;
    for (std::uint64_t i = 0; i < count; ++i) images.insert(permuted(3, 4, i, count));
    CHECK(images.size() == count);
    CHECK(*images.rbegin() == count - 1);
  }
  int same_stream = 0, same_seed = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    same_stream += permuted(3, 4, i, 1000) == permuted(3, 5, i, 1000) ? 1 : 0;
    same_seed += permuted(3, 4, i, 1000) == permuted(4, 4, i, 1000) ? 1 : 0;
  }
  CHECK(same_stream < 10);
  CHECK(same_seed < 10);
}

TEST_CASE("a latin hypercube has a run in each part of each parameter") {
  const Study study = make_study(DesignKind::latin_hypercube, 3, 10.0, 20.0, 100);
  const Sampling sampling(study);
  std::array<std::set<int>, 3> parts;
  for (std::int64_t run = 0; run < 100; ++run) {
    const std::vector<double> values = sampling.values(run);
    for (std::size_t d = 0; d < 3; ++d)
      parts[d].insert(static_cast<int>(std::floor((values[d] - 10.0) * 10.0)));
  }
  for (const std::set<int>& part : parts) {
    CHECK(part.size() == 100);
    CHECK(*part.rbegin() == 99);
  }
  Study other = study;
  other.design.seed = 6;
  CHECK(Sampling(other).values(0) != sampling.values(0));
  CHECK(Sampling(study).values(17) == sampling.values(17));
}

TEST_CASE("a grid has all combinations, the last parameter changing first") {
  Study study = make_study(DesignKind::grid, 2, 0.0, 0.0, 6);
  study.parameters[0].levels = {{1.0, {}}, {2.0, {}}};
  study.parameters[1].levels = {{0.0, "\"a\""}, {1.0, "\"b, c\""}, {2.0, "true"}};
  const Sampling sampling(study);
  CHECK(sampling.values(0) == std::vector<double>{1.0, 0.0});
  CHECK(sampling.values(2) == std::vector<double>{1.0, 2.0});
  CHECK(sampling.values(5) == std::vector<double>{2.0, 2.0});
  CHECK(make_overrides(study, sampling.values(4)) == spoke::Overrides{"x1=2", "x2=\"b, c\""});
  CHECK(plain_text(study.parameters[1], 1.0) == "b, c");
  CHECK(plain_text(study.parameters[1], 2.0) == "true");
}

TEST_CASE("the runs of a Saltelli point are A, B and A with each coordinate of B") {
  const Study study = make_study(DesignKind::saltelli, 3, 0.0, 1.0, 4);
  const Sampling sampling(study);
  for (std::int64_t point = 0; point < 4; ++point) {
    const std::vector<double> a = sampling.values(5 * point), b = sampling.values(5 * point + 1);
    for (std::size_t d = 0; d < 3; ++d) {
      std::vector<double> mixed = a;
      mixed[d] = b[d];
      CHECK(sampling.values(5 * point + 2 + static_cast<std::int64_t>(d)) == mixed);
      CHECK(a[d] != b[d]);
    }
  }
}

TEST_CASE("distributions have their moments, expressions their arguments") {
  Study study = make_study(DesignKind::sobol, 2, 0.0, 0.0, 4096);
  study.parameters[0].kind = ParameterKind::normal;
  study.parameters[0].low = 5.0;
  study.parameters[0].high = 2.0;
  study.parameters[1].kind = ParameterKind::log_uniform;
  study.parameters[1].low = 0.01;
  study.parameters[1].high = 100.0;
  Parameter product;
  product.name = "p";
  product.kind = ParameterKind::expression;
  product.expression = Expression("2 * x1 + log(x2)", std::vector<std::string>{"x1", "x2"});
  study.parameters.push_back(product);
  const Sampling sampling(study);
  double mean = 0.0, square = 0.0, logs = 0.0;
  for (std::int64_t run = 0; run < 4096; ++run) {
    const std::vector<double> values = sampling.values(run);
    CHECK(std::abs(values[2] - (2.0 * values[0] + std::log(values[1]))) < 1e-12);
    mean += values[0] / 4096.0;
    square += (values[0] - 5.0) * (values[0] - 5.0) / 4096.0;
    logs += std::log10(values[1]) / 4096.0;
    CHECK(values[1] > 0.01);
    CHECK(values[1] < 100.0);
  }
  CHECK(std::abs(mean - 5.0) < 0.01);
  CHECK(std::abs(std::sqrt(square) - 2.0) < 0.01);
  CHECK(std::abs(logs) < 0.01);
}

TEST_CASE("numbers are written so that they read back equal, whole ones without a point") {
  const Parameter parameter;
  CHECK(toml_text(parameter, 6.0) == "6");
  CHECK(toml_text(parameter, 6e10) == "60000000000");
  CHECK(toml_text(parameter, 0.1) == "0.1");
  CHECK(toml_text(parameter, -0.0) == "-0");
  CHECK(toml_text(parameter, 1e300) == "1e+300");
}
