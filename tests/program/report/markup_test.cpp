#include "program/report/markup.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace spoke::report;

TEST_CASE("escape() makes text safe in content and attributes") {
  CHECK(escape("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  CHECK(escape("</title><script>") == "&lt;/title&gt;&lt;script&gt;");
  CHECK(escape(std::string("a\0b\x1b[1m\x7f", 8)) == "a b [1m ");
  CHECK(escape("line\n\tline") == "line\n\tline");
  CHECK(escape("µs, blåd") == "µs, blåd");
  CHECK(escape("").empty());
}

TEST_CASE("coordinates are short and never in exponents") {
  CHECK(coordinate(12.0) == "12");
  CHECK(coordinate(12.345) == "12.35");
  CHECK(coordinate(-0.001) == "0");
  CHECK(coordinate(1e-7) == "0");
  CHECK(coordinate(100.0) == "100");
}

TEST_CASE("quantities have SI prefixes") {
  CHECK(quantity(-5611377.0, "N m", 4) == "-5.611 MN m");
  CHECK(quantity(12345.0, "N m") == "12.3 kN m");
  CHECK(quantity(999.4, "J") == "999 J");
  CHECK(quantity(1000.4, "J") == "1.00 kJ");
  CHECK(quantity(1.0, "J") == "1.00 J");
  CHECK(quantity(0.0, "J") == "0 J");
  CHECK(quantity(8.08e-5, "J") == "80.8 \u00b5J");
  CHECK(quantity(-2.5e-3, "N") == "-2.50 mN");
  CHECK(quantity(4.1e-20, "J") == "4.1e-20 J");
  CHECK(quantity(3e17, "J") == "3e+17 J");
  CHECK(quantity(std::nan(""), "J") == "- J");
}

TEST_CASE("figures have three significant digits") {
  CHECK(figure(1.8449) == "1.84");
  CHECK(figure(0.021349) == "0.0213");
  CHECK(figure(12345.0) == "12345");
  CHECK(figure(0.0) == "0");
  CHECK(figure(-2.5) == "-2.50");
  CHECK(figure(4.1e-7) == "4.1e-07");
  CHECK(figure(1.23456, 5) == "1.2346");
  CHECK(figure(std::nan("")) == "-");
  CHECK(figure(INFINITY) == "inf");
}

TEST_CASE("ratios have two decimals, and no small one reads as zero") {
  CHECK(ratio_text(1.0) == "1.00");
  CHECK(ratio_text(2.774) == "2.77");
  CHECK(ratio_text(36.57) == "36.57");
  CHECK(ratio_text(0.1) == "0.10");
  CHECK(ratio_text(0.0632) == "0.063");
  CHECK(ratio_text(0.0018) == "0.0018");
  CHECK(ratio_text(0.0) == "0.00");
  CHECK(ratio_text(std::nan("")) == "-");
}
