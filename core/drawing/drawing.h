#pragma once
// What a drawing file shows, in the file's own unit: lines and arcs, those of one entity together, in the
// order of the file; and what it shows that cannot be drawn by two axes.
#include <cstdint>
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
  double degrees = 0;  ///< of an arc: how far it goes round, counterclockwise; 360: a circle
  [[nodiscard]] double length() const;
};

/// One entity: connected curves. A point is a line that ends where it begins.
struct Path {
  std::vector<Curve> curves;
  int entity = 0;  ///< the how manieth of the file, from 1
  int line = 0;    ///< of the file, where it begins
  int layer = 0;   ///< in Drawing::layers
  [[nodiscard]] bool closed() const;
};

struct Layer {
  std::string name;
  bool shown = true;    ///< neither frozen nor off
  bool frozen = false;  ///< else it is off, where it is not shown
};
/// Of layers and blocks: the same in capitals and in small letters.
bool is_same_name(std::string_view a, std::string_view b);

/// What was not taken, and why.
struct LeftOut {
  std::string what;  ///< "TEXT"
  std::string why;
  int entity = 0, line = 0;
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
  std::vector<LeftOut> understood;  ///< drawn in a way that the file leaves open, and why
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
/// Those that have any.
std::vector<HiddenLayer> hidden_layers(const Drawing& drawing);
/// Of the curves themselves, not only of their ends.
Box box_of(const Drawing& drawing);
double length_of(const Drawing& drawing);

}  // namespace hw::drawing
