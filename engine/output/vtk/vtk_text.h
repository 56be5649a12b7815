#pragma once

// The text of VTK's XML files.

#include <Eigen/Core>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "models/vectors.h"

namespace spoke {

/// Builds the elements of a VTK file in XML. Numbers are written so that they read back equal.
class VtkText {
 public:
  void line(std::string_view text) { text_.append(text).append("\n"); }

  template <class Number>
  void add(Number number) {
    std::array<char, 32> buffer;
    if constexpr (std::is_floating_point_v<Number>) number += Number{0};  // no "-0"
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    text_.append(buffer.data(), static_cast<std::size_t>(end - buffer.data())).append(" ");
  }
  void add(const Position& v) {
    add(v.x());
    add(v.y());
    add(0);
  }
  void add(const Eigen::Vector3d& v) {
    for (const double x : v) add(x);
  }
  /// Adds an array; `fill` adds its numbers.
  template <class Fill>
  void array(std::string_view type, std::string_view name, std::string_view attributes, Fill fill) {
    text_.append("<DataArray type=\"").append(type).append("\" Name=\"").append(name).append("\"");
    if (!attributes.empty()) text_.append(" ").append(attributes);
    text_.append(" format=\"ascii\">\n");
    fill();
    text_.append("\n</DataArray>\n");
  }
  /// Adds a text as VTK stores it: the codes of its letters and a zero.
  void text_array(std::string_view name, std::string_view text) {
    text_.append("<Array type=\"String\" Name=\"").append(name);
    text_.append("\" NumberOfTuples=\"1\" format=\"ascii\">\n");
    for (const unsigned char c : text) add(int{c});
    text_.append("0\n</Array>\n");
  }
  void number_array(std::string_view name, double value) {
    array("Float64", name, "NumberOfTuples=\"1\"", [&] { add(value); });
  }
  /// Begins the data of the whole file, with those that every file has: time [s], version of Spoke,
  /// title of the scenario, and units of the arrays.
  void begin_field_data(double time, std::string_view title, std::string_view units) {
    line("<FieldData>");
    number_array("TimeValue", time);
    text_array("spoke_version", SPOKE_VERSION);
    text_array("scenario", title);
    text_array("units", units);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace spoke
