#pragma once
// Contents of a drawing file, in its own unit: lines and arcs, grouped by entity, in the order of the file;
// and the entities that two axes cannot draw.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw::drawing {

struct Point {
  double x = 0, y = 0;
  bool operator==(const Point&) const = default;
};

/// A line, or an arc that stays one.
struct Curve {
  enum class Kind : std::uint8_t { line, arc };
  Kind kind = Kind::line;
  Point from, to;
  Point centre;        ///< of an arc
  double degrees = 0;  ///< of an arc: sweep, counterclockwise; 360: a circle
  [[nodiscard]] double length() const;
};

/// The connected curves of one entity. A point is a line of length 0.
struct Path {
  std::vector<Curve> curves;
  int entity = 0;  ///< number in the file, from 1
  int line = 0;    ///< line of the file where it begins
  int layer = 0;   ///< in Drawing::layers
  [[nodiscard]] bool closed() const;
};

struct Layer {
  std::string name;
  bool shown = true;    ///< neither frozen nor off
  bool frozen = false;  ///< false, if not shown: off
};
/// Whether two names of layers or blocks are equal, ignoring case.
bool is_same_name(std::string_view a, std::string_view b);

/// An entity that was left out, and why.
struct LeftOut {
  std::string what;  ///< "TEXT"
  std::string why;
  int entity = 0, line = 0;
  std::optional<Point> at = {};  ///< place in the model; none: unknown, or in a block
};

struct Box {
  Point low, high;
  bool empty = true;
  void add(Point p);
  void add(const Curve& curve);
};

struct Drawing {
  std::vector<Layer> layers;
  std::vector<Path> paths;
  std::vector<LeftOut> left_out;
  std::vector<LeftOut> understood;  ///< drawn in one of several possible ways, and why
  std::string unit;                 ///< "mm", "in" ..., see millimetres(); empty: the file does not say
  std::string version;              ///< "AC1009"
};

/// A layer that is not shown, and how many entities lie on it.
struct HiddenLayer {
  std::string name;
  int entities = 0;
};
/// How many entities lie on each layer.
std::vector<int> entities_by_layer(const Drawing& drawing);
/// The hidden layers that have entities.
std::vector<HiddenLayer> hidden_layers(const Drawing& drawing);
/// Bounds of the curves, not only of their ends.
Box box_of(const Drawing& drawing);
double length_of(const Drawing& drawing);

}  // namespace hw::drawing
