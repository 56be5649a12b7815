#include "program/report/page.h"

#include <doctest/doctest.h>

#include "tests/program/report/xml.h"

using namespace spoke::report;

namespace {

/// Returns the part of the page that is XML as well.
std::string main_of(const Page& page) {
  const std::string html = page.html();
  const auto begin = html.find("<main>");
  return html.substr(begin, html.find("</body>") - begin);
}

}  // namespace

TEST_CASE("a page escapes every text") {
  Page page("<Title> & co", "a<b");
  page.add_heading("<h>");
  page.add_paragraph("1 < 2");
  page.add_note("\"x\"", Tone::bad);
  page.add_notes({"first", "<second>"});
  page.add_facts({{"<label>", "<text>"}});
  page.add_table({"<caption>", {{"<column>"}}, {{{"<cell>"}}}});
  page.add_figure("<svg></svg>", "<figure>");
  const std::string html = page.html();
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(html.find("<title>&lt;Title&gt; &amp; co</title>") != std::string::npos);
  for (const char* text : {"&lt;h&gt;", "1 &lt; 2", "&quot;x&quot;", "&lt;label&gt;",
                           "&lt;text&gt;", "&lt;caption&gt;", "&lt;column&gt;", "&lt;cell&gt;",
                           "&lt;figure&gt;", "&lt;second&gt;", "a&lt;b", "<svg></svg>"}) {
    CAPTURE(text);
    CHECK(html.find(text) != std::string::npos);
  }
  CHECK(xml_fault(main_of(page)) == "");
}

TEST_CASE("a page needs nothing from elsewhere") {
  Page page("Title");
  page.add_paragraph("text");
  const std::string html = page.html();
  for (const char* part : {"<script", "<link", "@import", "url(", "src=", "http:", "https:"}) {
    CAPTURE(part);
    CHECK(html.find(part) == std::string::npos);
  }
  CHECK(html.find("prefers-color-scheme: dark") != std::string::npos);
  CHECK(html.find("@media print") != std::string::npos);
}

TEST_CASE("tables align numbers, mark rows, and fill what is missing") {
  Page page("Title");
  page.add_table({"", {{"name"}, {"time", Align::number}}, {{{"a", "1.5"}, Tone::good}, {{"b"}}}});
  const std::string text = main_of(page);
  CHECK(text.find("<th scope=\"col\" class=\"number\">time</th>") != std::string::npos);
  CHECK(text.find("<tr class=\"good\"><td>a</td><td class=\"number\">1.5</td></tr>") !=
        std::string::npos);
  CHECK(text.find("<tr><td>b</td><td class=\"number\"></td></tr>") != std::string::npos);
  CHECK(xml_fault(text) == "");
}

TEST_CASE("a table without rows says so") {
  Page page("Title");
  page.add_table({"caption", {{"a"}, {"b"}}, {}});
  CHECK(main_of(page).find("<td colspan=\"2\">no rows</td>") != std::string::npos);
}

TEST_CASE("tiles and groups of facts are escaped") {
  Page page("Title");
  page.add_tiles({{"<label>", "<value>", "<detail>", Tone::warning}});
  page.add_fact_groups({{"<group>", {{"<fact>", "<text>"}}}});
  page.widen();
  const std::string text = page.html();
  for (const char* part :
       {"<li class=\"warning\">", "&lt;label&gt;", "&lt;value&gt;", "&lt;detail&gt;",
        "<h3>&lt;group&gt;</h3>", "&lt;fact&gt;", "&lt;text&gt;", "<main class=\"wide\">"}) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("no data can end the element that holds them") {
  Page page("Title");
  page.add_data("numbers", R"({"title": "</script><b>"})");
  page.add_script("const a = 1 < 2;\n");
  const std::string html = page.html();
  CHECK(
      html.find(
          R"(<script type="application/json" id="numbers">{"title": "\u003c/script>\u003cb>"}</script>)") !=
      std::string::npos);
  CHECK(html.find("<script type=\"module\">\nconst a = 1 < 2;\n</script>") != std::string::npos);
  CHECK(html.find("</main>") < html.find("<script"));
}
