// Writes the elements of a drawing.

#include "program/report/svg.h"

#include <algorithm>
#include <cassert>

#include "program/report/markup.h"

namespace spoke::report {
namespace {

std::string attribute(std::string_view name, double value) {
  return ' ' + std::string(name) + "=\"" + coordinate(value) + '"';
}

std::string attribute(std::string_view name, std::string_view text) {
  return text.empty() ? "" : ' ' + std::string(name) + "=\"" + escape(text) + '"';
}

/// Whether a byte goes on with a character of UTF-8.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t characters_of(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

std::string polygon(std::initializer_list<Point2> corners) {
  std::string commands;
  for (const Point2 corner : corners) commands += command(commands.empty() ? 'M' : 'L', corner);
  return commands + 'Z';
}

}  // namespace

Svg::Svg(double width, double height, std::string_view label) {
  text_ = "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"" +
          attribute("aria-label", label) + " viewBox=\"0 0 " + coordinate(width) + ' ' +
          coordinate(height) + "\">\n";
}

void Svg::line(Point2 from, Point2 to, std::string_view css) {
  text_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
           attribute("y2", to.y) + attribute("class", css) + "/>\n";
}

void Svg::box(const Box& box, std::string_view css) {
  text_ += "<rect" + attribute("x", box.x) + attribute("y", box.y) + attribute("width", box.width) +
           attribute("height", box.height) + " rx=\"1.5\"" + attribute("class", css) + "/>\n";
}

void Svg::path(std::string_view commands, std::string_view css) {
  text_ += "<path" + attribute("d", commands) + attribute("class", css) + "/>\n";
}

void Svg::text(Point2 at, std::string_view text, std::string_view css) {
  text_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("class", css) + '>' +
           escape(text) + "</text>\n";
}

void Svg::upward_text(Point2 at, std::string_view text, std::string_view css) {
  text_ += "<text transform=\"translate(" + coordinate(at.x) + ' ' + coordinate(at.y) +
           ") rotate(-90)\"" + attribute("class", css) + '>' + escape(text) + "</text>\n";
}

void Svg::begin_group(std::string_view css, std::string_view tooltip) {
  text_ += "<g" + attribute("class", css) + '>';
  if (!tooltip.empty()) text_ += "<title>" + escape(tooltip) + "</title>";
  text_ += '\n';
  ++open_groups_;
}

void Svg::end_group() {
  text_ += "</g>\n";
  --open_groups_;
}

std::string Svg::markup() const {
  assert(open_groups_ == 0);
  return text_ + "</svg>\n";
}

std::string shortened(std::string_view text, std::size_t most) {
  if (characters_of(text) <= most) return std::string(text);
  std::size_t bytes = 0;
  for (std::size_t seen = 0; bytes < text.size(); ++bytes) {
    if (!continues(text[bytes]) && ++seen == most) break;
  }
  return std::string(text.substr(0, bytes)) + "\u2026";
}

double width_of(std::string_view text) { return 7.7 * static_cast<double>(characters_of(text)); }

std::string command(char letter, Point2 at) {
  std::string text(1, letter);
  text += coordinate(at.x);
  text += ' ';
  return text += coordinate(at.y);
}

std::string marker(Point2 at, std::size_t shape) {
  const auto [x, y] = at;
  constexpr double r = 4.2;
  switch (shape % 5) {
    case 0:
      return command('M', {x - r, y}) + "a4.2 4.2 0 1 0 8.4 0a4.2 4.2 0 1 0 -8.4 0Z";
    case 1:
      return polygon({{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}});
    case 2:
      return polygon({{x, y - 1.3 * r}, {x + 1.2 * r, y + r}, {x - 1.2 * r, y + r}});
    case 3:
      return polygon({{x, y - 1.4 * r}, {x + 1.4 * r, y}, {x, y + 1.4 * r}, {x - 1.4 * r, y}});
    default:
      return polygon({{x, y + 1.3 * r}, {x + 1.2 * r, y - r}, {x - 1.2 * r, y - r}});
  }
}

}  // namespace spoke::report
