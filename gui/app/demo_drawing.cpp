#include "gui/app/demo_drawing.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>

#include <fmt/core.h>

namespace hw::app {
namespace {

constexpr double width = 100, height = 60, corner = 10;

class Drawing {
 public:
  Drawing() : text_("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n") {}
  void line(std::string_view layer, double x, double y, double to_x, double to_y) {
    add("0\nLINE\n8\n{}\n10\n{:.4f}\n20\n{:.4f}\n11\n{:.4f}\n21\n{:.4f}\n", layer, x, y, to_x, to_y);
  }
  void arc(double x, double y, double radius, double from, double to) {
    add("0\nARC\n8\nedge\n10\n{}\n20\n{}\n40\n{}\n50\n{}\n51\n{}\n", x, y, radius, from, to);
  }
  void circle(double x, double y, double radius) {
    add("0\nCIRCLE\n8\nholes\n10\n{}\n20\n{}\n40\n{}\n", x, y, radius);
  }
  std::string finish() && { return std::move(text_) + "0\nENDSEC\n0\nEOF\n"; }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }
  std::string text_;
};

void draw_edge(Drawing& d) {
  d.line("edge", corner, 0, width - corner, 0);
  d.arc(width - corner, corner, corner, 270, 0);
  d.line("edge", width, corner, width, height - corner);
  d.arc(width - corner, height - corner, corner, 0, 90);
  d.line("edge", width - corner, height, corner, height);
  d.arc(corner, height - corner, corner, 90, 180);
  d.line("edge", 0, height - corner, 0, corner);
  d.arc(corner, corner, corner, 180, 270);
}

void draw_star(Drawing& d) {
  constexpr int points = 10;
  const auto x = [](int n) { return width / 2 + (n % 2 == 0 ? 22 : 9) * std::sin(n * std::numbers::pi / 5); };
  const auto y = [](int n) {
    return height / 2 + (n % 2 == 0 ? 22 : 9) * std::cos(n * std::numbers::pi / 5);
  };
  for (int n = 0; n < points; ++n) d.line("star", x(n), y(n), x(n + 1), y(n + 1));
}

}  // namespace

std::string demo_drawing() {
  Drawing d;
  draw_edge(d);
  for (const double x : {15.0, width - 15})
    for (const double y : {12.0, height - 12}) d.circle(x, y, 5);
  draw_star(d);
  return std::move(d).finish();
}

}  // namespace hw::app
