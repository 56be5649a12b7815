#pragma once

// Self-contained HTML pages: one file, no network, no script, no font of its own. They follow the
// reader's light or dark theme and print in black on white.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spoke::report {

enum class Align {
  text,    ///< to the left
  number,  ///< to the right, in digits of equal width
};

/// What a note or a row of a table is to catch the eye as.
enum class Tone { plain, good, warning, bad, muted };

struct Column {
  std::string title = {};
  Align align = Align::text;
};

struct Row {
  std::vector<std::string> cells = {};  ///< one for each column; missing ones are empty
  Tone tone = Tone::plain;
};

struct Table {
  std::string caption = {};
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
};

/// A label and what it stands for, for lists of facts.
using Fact = std::pair<std::string, std::string>;

/// Collects a page from top to bottom. All texts are plain text and are escaped here.
class Page {
 public:
  explicit Page(std::string title, std::string subtitle = {});

  void add_heading(std::string_view text);
  void add_paragraph(std::string_view text);
  /// A paragraph set apart in a frame, or several in one frame.
  void add_note(std::string_view text, Tone tone = Tone::plain);
  void add_notes(const std::vector<std::string>& paragraphs, Tone tone = Tone::plain);
  void add_facts(const std::vector<Fact>& facts);
  /// A table without rows says so.
  void add_table(const Table& table);
  /// Adds a picture. `svg` is markup, as by render() of report/chart.h, and is not escaped.
  void add_figure(std::string_view svg, std::string_view caption = {});

  /// The whole document.
  std::string html() const;

 private:
  std::string title_;
  std::string subtitle_;
  std::string body_;
};

}  // namespace spoke::report
