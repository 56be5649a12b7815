// Puts a page together: its parts as HTML elements.

#include "program/report/page.h"

#include <utility>

#include "program/report/markup.h"
#include "program/report/page_style.h"

namespace spoke::report {
namespace {

std::string_view name_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::warning:
      return "warning";
    case Tone::bad:
      return "bad";
    case Tone::muted:
      return "muted";
    case Tone::plain:
      break;
  }
  return "";
}

std::string_view css_of(Align align) { return align == Align::number ? "number" : ""; }

/// Returns `attribute="value"` behind a space; empty without a value.
std::string attribute(std::string_view name, std::string_view value) {
  std::string markup;
  if (!value.empty()) markup.append(" ").append(name).append("=\"").append(value).append("\"");
  return markup;
}

std::string element(std::string_view name, std::string_view text, std::string_view css = {}) {
  std::string markup;
  markup.append("<").append(name).append(attribute("class", css)).append(">");
  return markup.append(escape(text)).append("</").append(name).append(">");
}

std::string fact_list(const std::vector<Fact>& facts) {
  std::string markup = "<dl>\n";
  for (const auto& [label, text] : facts)
    markup += element("dt", label) + element("dd", text) + '\n';
  return markup + "</dl>\n";
}

std::string table_head(const Table& table) {
  std::string head = "<thead><tr>";
  for (const Column& column : table.columns) {
    head += "<th scope=\"col\"" + attribute("class", css_of(column.align)) + '>';
    head += escape(column.title) + "</th>";
  }
  return head + "</tr></thead>\n";
}

std::string table_row(const Table& table, const Row& row) {
  std::string markup = "<tr" + attribute("class", name_of(row.tone)) + '>';
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string_view text = c < row.cells.size() ? std::string_view(row.cells[c]) : "";
    markup += element("td", text, css_of(table.columns[c].align));
  }
  return markup + "</tr>\n";
}

}  // namespace

Page::Page(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void Page::add_heading(std::string_view text) { body_ += element("h2", text) + '\n'; }

void Page::add_paragraph(std::string_view text) { body_ += element("p", text) + '\n'; }

void Page::add_note(std::string_view text, Tone tone) { add_notes({std::string(text)}, tone); }

void Page::add_notes(const std::vector<std::string>& paragraphs, Tone tone) {
  std::string css = "note";
  if (tone != Tone::plain) css.append(" ").append(name_of(tone));
  body_ += "<div" + attribute("class", css) + ">\n";
  for (const std::string& paragraph : paragraphs) body_ += element("p", paragraph) + '\n';
  body_ += "</div>\n";
}

void Page::add_facts(const std::vector<Fact>& facts) {
  if (facts.empty()) return;
  body_ += fact_list(facts);
}

void Page::add_fact_groups(const std::vector<FactGroup>& groups) {
  body_ += "<div class=\"groups\">\n";
  for (const FactGroup& group : groups)
    body_ += "<section>" + element("h3", group.title) + fact_list(group.facts) + "</section>\n";
  body_ += "</div>\n";
}

void Page::add_tiles(const std::vector<Tile>& tiles) {
  body_ += "<ul class=\"tiles\">\n";
  for (const Tile& tile : tiles) {
    body_ += "<li" + attribute("class", name_of(tile.tone)) + '>';
    body_ += element("span", tile.label) + element("strong", tile.value);
    body_ += element("small", tile.detail) + "</li>\n";
  }
  body_ += "</ul>\n";
}

void Page::add_table(const Table& table) {
  // Elements that scroll are reached by the keyboard.
  body_ += "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" +
           (table.caption.empty() ? "table" : escape(table.caption)) + "\"><table>\n";
  if (!table.caption.empty())
    body_ += "<caption>" + element("span", table.caption) + "</caption>\n";
  body_ += table_head(table) + "<tbody>\n";
  for (const Row& row : table.rows) body_ += table_row(table, row);
  if (table.rows.empty()) {
    body_ += "<tr class=\"muted\"><td colspan=\"" + std::to_string(table.columns.size()) +
             "\">no rows</td></tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void Page::add_figure(std::string_view svg, std::string_view caption) {
  body_ += "<figure><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"chart\">" +
           std::string(svg) + "</div>\n";
  if (!caption.empty()) body_ += element("figcaption", caption) + '\n';
  body_ += "</figure>\n";
}

void Page::add_markup(std::string_view markup) { body_ += markup; }

void Page::add_data(std::string_view id, std::string_view json) {
  scripts_.reserve(scripts_.size() + json.size() + 1000);
  scripts_.append("<script type=\"application/json\"").append(attribute("id", id)).append(">");
  for (std::size_t at = json.find('<'); at != json.npos; at = json.find('<')) {
    // No text in it can end the element so.
    scripts_.append(json.substr(0, at)).append("\\u003c");
    json.remove_prefix(at + 1);
  }
  scripts_.append(json).append("</script>\n");
}

void Page::add_script(std::string_view script) {
  scripts_.append("<script type=\"module\">\n").append(script).append("</script>\n");
}

std::string Page::html() const {
  std::string text;
  text.reserve(page_style().size() + body_.size() + scripts_.size() + 1000);
  text +=
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  text += element("title", title_) + "\n<style>" + std::string(page_style()) + "</style>\n";
  text += "</head>\n<body>\n<main" + attribute("class", is_wide_ ? "wide" : "") + ">\n<header>";
  text += element("h1", title_);
  if (!subtitle_.empty()) text += element("p", subtitle_);
  text.append("</header>\n").append(body_).append("</main>\n").append(scripts_);
  text += "</body>\n</html>\n";
  return text;
}

}  // namespace spoke::report
