// Tables of figures: for spreadsheets, programs, pages and the documentation.

#include "program/verify/verify_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "engine/support/csv_cell.h"
#include "models/count_text.h"
#include "models/support/json.h"

namespace spoke::verify {
namespace {

using report::Align;
using report::Tone;

/// Returns a value in as many digits as show where it differs from the exact one.
std::string value_text(const Figure& figure, double value) {
  constexpr int kLeast = 4, kMost = 9;
  const double error = std::max(error_of(figure, value), 1e-12);
  const int digits = static_cast<int>(std::ceil(-std::log10(error))) + 2;
  return fmt::format("{:.{}g}", value, std::clamp(digits, kLeast, kMost));
}

std::string exact_text(const Figure& figure) { return fmt::format("{:.10g}", figure.exact); }

std::string error_text(double error) { return fmt::format("{:.1e}", error); }

std::string verdict(const CaseResult& result, std::size_t figure) {
  if (result.values.empty()) return "failed";
  return holds(result.of.figures[figure], result.values[figure]) ? "holds" : "off";
}

std::string with_unit(const Figure& figure) {
  return figure.unit.empty() ? figure.name : figure.name + " [" + figure.unit + ']';
}

double total_seconds(const std::vector<CaseResult>& results) {
  double sum = 0.0;
  for (const CaseResult& result : results) sum += result.seconds;
  return sum;
}

std::string seconds_text(double seconds) {
  return seconds < 0.095 ? fmt::format("{:.0f} ms", std::max(1.0, 1e3 * seconds))
                         : fmt::format("{:.1f} s", seconds);
}

/// Calls `visit` with each group's name and its results.
template <class Visit>
void for_each_group(const std::vector<CaseResult>& results, const Visit& visit) {
  for (auto begin = results.begin(); begin != results.end();) {
    const auto end = std::find_if(begin, results.end(), [&](const CaseResult& result) {
      return result.of.group != begin->of.group;
    });
    visit(begin->of.group, std::vector<CaseResult>(begin, end));
    begin = end;
  }
}

Json describe_figure(const CaseResult& result, std::size_t k) {
  const Figure& figure = result.of.figures[k];
  Json json = {{"name", figure.name},
               {"unit", figure.unit},
               {"exact", figure.exact},
               {"allowed_error", figure.error},
               {"error_by", figure.scale}};
  const bool has_value = !result.values.empty();
  json.set("value", has_value ? Json(result.values[k]) : Json());
  json.set("error", has_value ? Json(error_of(figure, result.values[k])) : Json());
  json.set("verdict", verdict(result, k));
  return json;
}

/// Returns a text as a cell of a table in Markdown.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char letter : text) {
    if (letter == '|') cell += '\\';
    cell += letter;
  }
  return cell;
}

std::string markdown_rows(const CaseResult& result) {
  std::string rows;
  for (std::size_t k = 0; k < result.of.figures.size(); ++k) {
    const Figure& figure = result.of.figures[k];
    const bool has_value = !result.values.empty();
    const double error = has_value ? error_of(figure, result.values[k]) : 0.0;
    rows += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", k == 0 ? "`" + result.of.name + "`" : "",
        markdown_cell(with_unit(figure)), exact_text(figure),
        has_value ? value_text(figure, result.values[k]) : "failed",
        has_value ? error_text(error) + (holds(figure, result.values[k]) ? "" : " **off**") : "",
        error_text(figure.error), k == 0 ? seconds_text(result.seconds) : "");
  }
  return rows;
}

std::string markdown_group(const std::string& group, const std::vector<CaseResult>& results) {
  std::string text = "\n## " + group + "\n\n";
  for (const CaseResult& result : results)
    text += fmt::format("- `{}`: {} Value: {} Source: {}.\n", result.of.name, result.of.title,
                        result.of.by, result.of.source);
  text +=
      "\n| case | figure | exact | Spoke | error | allowed | time |\n"
      "|---|---|---:|---:|---:|---:|---:|\n";
  for (const CaseResult& result : results) text += markdown_rows(result);
  return text;
}

}  // namespace

std::string describe(const Tally& tally) {
  std::string text = counted(static_cast<std::int64_t>(tally.cases), "case") + ", " +
                     counted(static_cast<std::int64_t>(tally.figures), "figure") + ", ";
  if (tally.all_hold()) return text + "all within their stated errors";
  return text + fmt::format("{} not within their stated errors", tally.figures - tally.held);
}

report::Table make_table(const std::vector<CaseResult>& results, bool only_off) {
  report::Table table;
  table.columns = {{"case"},
                   {"figure"},
                   {"exact", Align::number},
                   {"Spoke", Align::number},
                   {"error", Align::number},
                   {"allowed", Align::number},
                   {"time", Align::number}};
  for (const CaseResult& result : results)
    for (std::size_t k = 0; k < result.of.figures.size(); ++k) {
      const Figure& figure = result.of.figures[k];
      const bool has_value = !result.values.empty();
      const bool good = has_value && holds(figure, result.values[k]);
      if (only_off && good) continue;
      table.rows.push_back(
          {{k == 0 || only_off ? result.of.name : "", with_unit(figure), exact_text(figure),
            has_value ? value_text(figure, result.values[k]) : "failed",
            has_value ? error_text(error_of(figure, result.values[k])) : "",
            error_text(figure.error), k == 0 ? seconds_text(result.seconds) : ""},
           good ? Tone::plain : Tone::bad});
    }
  return table;
}

std::string make_csv(const std::vector<CaseResult>& results) {
  std::string text =
      "case,figure,unit,exact,value,error,allowed_error,verdict,seconds,group,source\n";
  for (const CaseResult& result : results)
    for (std::size_t k = 0; k < result.of.figures.size(); ++k) {
      const Figure& figure = result.of.figures[k];
      const bool has_value = !result.values.empty();
      text += fmt::format("{},{},{},{},{},{},{},{},{:.3f},{},{}\n", csv_cell(result.of.name),
                          csv_cell(figure.name), csv_cell(figure.unit), figure.exact,
                          has_value ? fmt::format("{}", result.values[k]) : "",
                          has_value ? fmt::format("{}", error_of(figure, result.values[k])) : "",
                          figure.error, verdict(result, k), result.seconds,
                          csv_cell(result.of.group), csv_cell(result.of.source));
    }
  return text;
}

std::string make_json(const std::vector<CaseResult>& results) {
  const Tally tally = count(results);
  Json cases = Json::array();
  for (const CaseResult& result : results) {
    Json figures = Json::array();
    for (std::size_t k = 0; k < result.of.figures.size(); ++k)
      figures.push_back(describe_figure(result, k));
    Json one = {{"name", result.of.name},   {"group", result.of.group},
                {"title", result.of.title}, {"source", result.of.source},
                {"by", result.of.by},       {"command", command_of(result.of, "scenarios/")},
                {"seconds", result.seconds}};
    one.set("failure", result.failure.empty() ? Json() : Json(result.failure));
    one.set("figures", figures);
    cases.push_back(one);
  }
  return Json({{"figures", tally.figures},
               {"held", tally.held},
               {"seconds", total_seconds(results)},
               {"cases", cases}})
      .dump_lines();
}

std::string make_html(const std::vector<CaseResult>& results) {
  const Tally tally = count(results);
  report::Page page("Verification of Spoke", describe(tally));
  page.widen();
  page.add_tiles(
      {{"cases", std::to_string(tally.cases), ""},
       {"figures within their errors", fmt::format("{} of {}", tally.held, tally.figures), "",
        tally.all_hold() ? Tone::good : Tone::bad},
       {"time", fmt::format("{:.3g} s", total_seconds(results)), "sum over cases"}});
  page.add_paragraph(
      "Errors are shares of the exact value, or of the scale that verify.json names as error_by. "
      "An exact value is published, or follows from a closed form or an independent computation; "
      "none is Spoke's own.");
  for_each_group(results, [&](const std::string& group, const std::vector<CaseResult>& members) {
    page.add_heading(group);
    page.add_table(make_table(members, false));
    report::Table sources{.columns = {{"case"}, {"what"}, {"value"}, {"source"}, {"by hand"}}};
    for (const CaseResult& result : members) {
      sources.rows.push_back({{result.of.name, result.of.title, result.of.by, result.of.source,
                               command_of(result.of, "scenarios/")}});
      if (!result.failure.empty()) page.add_note(result.of.name + ": " + result.failure, Tone::bad);
    }
    page.add_table(sources);
  });
  return page.html();
}

std::string make_markdown(const std::vector<CaseResult>& results) {
  const Tally tally = count(results);
  std::string text = fmt::format(
      "# Verification\n\n"
      "[`spoke verify`](verify.md) computes problems whose answers are known, and compares: {}.\n"
      "This page is what `spoke verify --markdown` prints.\n\n"
      "An exact value is published, or follows from a closed form or an independent computation;\n"
      "none is Spoke's own. Those that can be are computed anew by a test,\n"
      "`tests/program/verify/exact_values.py`. Errors are shares of the exact value, or of the\n"
      "scale that `verify.json` names. Times are wall times of a case on one thread, with the\n"
      "reading of its scenario, on a machine with other work on it: {:.0f} s in all.\n\n"
      "How long other programs take on the same problems, where that was measured side by side,\n"
      "is in [peers.md](peers.md).\n",
      describe(tally), total_seconds(results));
  for_each_group(results, [&](const std::string& group, const std::vector<CaseResult>& members) {
    text += markdown_group(group, members);
  });
  return text;
}

}  // namespace spoke::verify
