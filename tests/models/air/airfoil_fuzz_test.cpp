// Whatever the bytes of an aerofoil file, they are an aerofoil or refused in one line.

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "models/air/airfoil_check.h"
#include "models/air/airfoil_reader.h"
#include "models/error.h"
#include "tests/models/air/airfoil_texts.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// Reads and checks a text; returns whether it is an aerofoil.
bool is_airfoil(const std::string& text) {
  try {
    air::check_airfoil(air::parse_airfoil(text, "f", "a"));
    return true;
  } catch (const InputError& error) {
    const std::string message = error.what();
    REQUIRE(message.starts_with("f"));
    REQUIRE(message.find('\n') == std::string::npos);
    REQUIRE(message.find("expected") != std::string::npos);
    return false;
  }
}

}  // namespace

TEST_CASE("aerofoil files cut short anywhere are refused or aerofoils") {
  for (const std::string& text : {kPlainAirfoil, kAerodynAirfoil}) {
    CHECK(is_airfoil(text));
    int good = 0;
    for (std::size_t length = 0; length < text.size(); ++length)
      good += is_airfoil(text.substr(0, length));
    CHECK(good < 12);  // those that lack no more than digits of the last line
  }
}

TEST_CASE("aerofoil files with bytes or words changed at random are aerofoils or refused") {
  std::mt19937 random(41);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> words{"-1", "1e999", "nan",     "inf", ",",  "\n",
                                       "!",  "#",     "NumAlf ", "Re ", "-",  "99999999999",
                                       "0",  "\r",    "NumTabs", "1e-", "\t", std::string(1, '\0')};
  for (const std::string& text : {kPlainAirfoil, kAerodynAirfoil})
    for (int run = 0; run < 1500; ++run) {
      std::string changed = text;
      for (std::size_t k = 0; k <= below(3); ++k) {
        const std::size_t at = below(changed.size());
        if (below(2) == 0)
          changed[at] = static_cast<char>(below(256));
        else
          changed.replace(at, std::min(below(4), changed.size() - at), words[below(words.size())]);
      }
      is_airfoil(changed);
    }
}
