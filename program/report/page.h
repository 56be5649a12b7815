#pragma once

// Self-contained HTML pages: one file, no network, no font of its own, no script unless one is
// added. They follow the reader's light or dark theme and print in black on white.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spoke::report {

enum class Align {
  text,    ///< aligned left
  number,  ///< aligned right, in digits of equal width
};

/// The emphasis of a note or a row of a table.
enum class Tone { plain, good, warning, bad, muted };

struct Column {
  std::string title = {};
  Align align = Align::text;
};

struct Row {
  std::vector<std::string> cells = {};  ///< cells, one for each column; missing ones are empty
  Tone tone = Tone::plain;
};

struct Table {
  std::string caption = {};
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
};

/// A label and its value, for lists of facts.
using Fact = std::pair<std::string, std::string>;

/// A figure that sums up a result, to be seen first.
struct Tile {
  std::string label = {};
  std::string value = {};
  std::string detail = {};  ///< smaller text below
  Tone tone = Tone::plain;
};

/// A list of facts under a heading of its own.
struct FactGroup {
  std::string title = {};
  std::vector<Fact> facts = {};
};

/// Collects a page from top to bottom. All texts are plain text and are escaped here.
class Page {
 public:
  explicit Page(std::string title, std::string subtitle = {});

  void add_heading(std::string_view text);
  void add_paragraph(std::string_view text);
  /// Adds a paragraph set apart in a frame, or several in one frame.
  void add_note(std::string_view text, Tone tone = Tone::plain);
  void add_notes(const std::vector<std::string>& paragraphs, Tone tone = Tone::plain);
  void add_facts(const std::vector<Fact>& facts);
  /// Adds groups side by side, where the page is wide enough.
  void add_fact_groups(const std::vector<FactGroup>& groups);
  void add_tiles(const std::vector<Tile>& tiles);
  /// Adds a table; one without rows says so.
  void add_table(const Table& table);
  /// Adds a picture. `svg` is markup, as by render() of report/chart.h, and is not escaped.
  void add_figure(std::string_view svg, std::string_view caption = {});

  /// Adds markup unchanged.
  void add_markup(std::string_view markup);
  /// Adds data in JSON, in an element with the id, for scripts to read.
  void add_data(std::string_view id, std::string_view json);
  /// Adds a script (a module) to the end of the page. It must not contain "</script".
  void add_script(std::string_view script);
  /// Lets the page be as wide as a large screen, for plots side by side.
  void widen() { is_wide_ = true; }

  /// Returns the whole document.
  std::string html() const;

 private:
  std::string title_;
  std::string subtitle_;
  std::string body_;
  std::string scripts_;
  bool is_wide_ = false;
};

}  // namespace spoke::report
