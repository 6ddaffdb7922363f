#include "core/drawing/dxf_places.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/number_text.h"
#include "core/drawing/space.h"

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

/// The extrusion direction and the first point of an entity, as in the file.
struct EntityPlace {
  std::optional<double> x, y, height;
  Point3 up{0, 0, 1};
};

/// Whether the file has its points in its own plane, turned as `up` is, and not in space.
bool lies_in_own_plane(std::string_view entity, int flags) {
  constexpr int in_space = 8 | 16 | 64;  // a line, a mesh or faces of points in space
  constexpr std::array<std::string_view, 10> all{"CIRCLE", "ARC",   "TEXT",   "ATTRIB", "SOLID",
                                                 "TRACE",  "SHAPE", "INSERT", "HATCH",  "LWPOLYLINE"};
  if (entity == "POLYLINE") return (flags & in_space) == 0;
  return std::find(all.begin(), all.end(), entity) != all.end();
}

Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 of_length_1(Point3 v) { return v * (1 / length(v)); }

/// Seen from above. A plane's own X follows from where it points to: the format's arbitrary axis algorithm.
std::optional<Point> seen_from_above(const EntityPlace& lying) {
  constexpr double nearly_up = 1.0 / 64;
  if (!lying.x || !lying.y || !(length(lying.up) > 0)) return std::nullopt;
  const Point3 up = of_length_1(lying.up);
  const bool steep = std::fabs(up.x) < nearly_up && std::fabs(up.y) < nearly_up;
  const Point3 own_x = of_length_1(cross(steep ? Point3(0, 1, 0) : Point3(0, 0, 1), up));
  const Point3 at = own_x * *lying.x + cross(up, own_x) * *lying.y + up * lying.height.value_or(0);
  return Point{at.x, at.y};
}

/// The first point, after the line of the name. For a hatch and a polyline it gives only the height; the
/// points of a polyline are its vertices.
std::optional<Point> first_point(Lines& lines, std::string_view entity) {
  constexpr int x_code = 10, y_code = 20, z_code = 30, height_code = 38, flags_code = 70, up_code = 210;
  int points_before = entity == "HATCH" ? 1 : 0, flags = 0;
  bool in_header = entity == "POLYLINE", found = false;
  EntityPlace lying;
  while (!lines.empty()) {
    const int code = whole_number<int>(lines.take()).value_or(-1);
    const std::string_view value = lines.take();
    if (code == 0 && in_header && value == "VERTEX") {
      in_header = false;
      continue;
    }
    if (code <= 0) break;
    const std::optional<double> number = coordinate(value);
    if (code == up_code) lying.up.x = number.value_or(0);
    if (code == up_code + 10) lying.up.y = number.value_or(0);
    if (code == up_code + 20) lying.up.z = number.value_or(0);
    if (code == flags_code && in_header) flags = whole_number<int>(value).value_or(0);
    if (!lying.height && (code == height_code || code == z_code)) lying.height = number;
    if (in_header || found) continue;
    if (code == x_code) lying.x = number;
    if (code != y_code || points_before-- > 0) continue;
    lying.y = number;
    found = true;
  }
  if (lies_in_own_plane(entity, flags)) return seen_from_above(lying);
  return lying.x && lying.y ? std::optional(Point{*lying.x, *lying.y}) : std::nullopt;
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

void find_places(std::string_view text, std::vector<LeftOut>& left_out) {
  if (left_out.empty()) return;
  const int model = line_of_model(text);
  if (model == 0) return;
  std::vector<LeftOut*> by_line;
  for (LeftOut& l : left_out)
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
