#pragma once

// A drawing as SVG.

#include <string>
#include <string_view>

namespace spoke::report {

struct Point2 {
  double x = 0.0, y = 0.0;  ///< distances to the right, and down
};

struct Box {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

/// Collects the elements of one inline SVG drawing, which scales to the width of its page. `css`
/// are names of classes of report/page_style.h; texts are escaped here.
class Svg {
 public:
  /// A screen reader says `label`.
  Svg(double width, double height, std::string_view label);

  void line(Point2 from, Point2 to, std::string_view css);
  void box(const Box& box, std::string_view css);
  void path(std::string_view commands, std::string_view css);
  void text(Point2 at, std::string_view text, std::string_view css);
  /// Adds text that reads upwards.
  void upward_text(Point2 at, std::string_view text, std::string_view css);
  /// Elements up to end_group() share the classes and show the tooltip, if there is one.
  void begin_group(std::string_view css, std::string_view tooltip = {});
  void end_group();

  /// Returns the markup. Precondition: all groups are ended.
  std::string markup() const;

 private:
  std::string text_;
  int open_groups_ = 0;
};

/// Returns a text cut to the number of characters, the last one then an ellipsis.
std::string shortened(std::string_view text, std::size_t most);
/// Returns about how wide a text of a chart is.
double width_of(std::string_view text);

/// Returns one command of a path: a letter such as M (move there) or L (a line to there), and the
/// point.
std::string command(char letter, Point2 at);
/// Returns the path commands of a marker of the k-th shape, to tell series apart without colour.
std::string marker(Point2 at, std::size_t shape);

}  // namespace spoke::report
