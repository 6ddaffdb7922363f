#include "core/drawing/dxf_places.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/number_text.h"

namespace hw::drawing {
namespace {

/// Reads a text by lines, forwards only.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  [[nodiscard]] int line() const { return line_; }  ///< number of the line that take() returns next, from 1
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  /// The next line, without blanks around it.
  std::string_view take() {
    constexpr std::string_view blanks = " \t\r";
    std::string_view taken = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(taken.size() + 1, rest_.size()));
    ++line_;
    taken.remove_prefix(std::min(taken.find_first_not_of(blanks), taken.size()));
    return taken.substr(0, taken.find_last_not_of(blanks) + 1);
  }
  void skip_to(int line) {
    while (line_ < line && !rest_.empty()) {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size() - 1) + 1);
      ++line_;
    }
  }

 private:
  std::string_view rest_;
  int line_ = 1;
};

std::optional<double> coordinate(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto number = whole_number<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Its points are those of the drawing only where it is seen from above: what lies mirrored, or askew, has
/// others.
bool lies_otherwise(int code, std::string_view value) {
  constexpr int extrusion_x = 210, extrusion_y = 220, extrusion_z = 230;
  if (code == extrusion_z) return !(coordinate(value).value_or(0) > 0);
  return (code == extrusion_x || code == extrusion_y) && coordinate(value) != 0.0;
}

/// Behind the line of its name: its first point. That of a hatch is how high it lies, and so is that of a
/// polyline, whose own ones are of its vertices.
std::optional<Point> first_point(Lines& lines, std::string_view entity) {
  constexpr int x_code = 10, y_code = 20;
  int points_before = entity == "HATCH" ? 1 : 0;
  bool in_header = entity == "POLYLINE", found = false;
  std::optional<double> x, y;
  while (!lines.empty()) {
    const int code = whole_number<int>(lines.take()).value_or(-1);
    const std::string_view value = lines.take();
    if (code == 0 && in_header && value == "VERTEX") {
      in_header = false;
      continue;
    }
    if (code <= 0) break;
    if (lies_otherwise(code, value)) return std::nullopt;
    if (in_header || found) continue;
    if (code == x_code) x = coordinate(value);
    if (code != y_code || points_before-- > 0) continue;
    y = coordinate(value);
    found = true;
  }
  return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

/// The line that names the section of the model; 0: there is none.
int line_of_model(std::string_view text) {
  std::string_view word, code;
  int model = 0;
  for (Lines lines(text); !lines.empty();) {
    const int line = lines.line();
    const std::string_view now = lines.take();
    if (now == "ENTITIES" && code == "2" && word == "SECTION") model = line;
    word = code, code = now;
  }
  return model;
}

}  // namespace

void find_places(std::string_view text, std::vector<LeftOut>& told) {
  if (told.empty()) return;
  const int model = line_of_model(text);
  if (model == 0) return;
  std::vector<LeftOut*> by_line;
  for (LeftOut& l : told)
    if (l.line > model) by_line.push_back(&l);
  std::stable_sort(by_line.begin(), by_line.end(),
                   [](const LeftOut* a, const LeftOut* b) { return a->line < b->line; });
  Lines lines(text);
  for (std::size_t i = 0; i < by_line.size(); ++i) {
    LeftOut& l = *by_line[i];
    if (i > 0 && by_line[i - 1]->line == l.line) {  // left out for two reasons
      l.at = by_line[i - 1]->at;
      continue;
    }
    lines.skip_to(l.line + 1);
    l.at = first_point(lines, l.what);
  }
}

}  // namespace hw::drawing
