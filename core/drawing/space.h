#pragma once
// Points and boxes of three axes. Those of two lie in the plane z = 0.
#include "core/drawing/drawing.h"

namespace hw::drawing {

struct Point3 {
  double x = 0, y = 0, z = 0;
  constexpr Point3() = default;
  constexpr Point3(double right, double up, double third = 0) : x(right), y(up), z(third) {}
  constexpr Point3(Point p) : x(p.x), y(p.y) {}  // NOLINT: converts on purpose
  bool operator==(const Point3&) const = default;
};
constexpr Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point3 operator*(Point3 a, double k) { return {a.x * k, a.y * k, a.z * k}; }
constexpr double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Point3 p);

struct Box3 {
  Point3 low, high;
  bool empty = true;
  Box3() = default;
  Box3(const Box& flat)  // NOLINT: converts on purpose
      : low(flat.low), high(flat.high), empty(flat.empty) {}
  void add(Point3 p);
  void add(const Box3& box);
  [[nodiscard]] Point3 centre() const { return (low + high) * 0.5; }
  [[nodiscard]] Point3 size() const { return high - low; }
  /// Corner `n`, 0 to 7: each bit chooses low or high of an axis.
  [[nodiscard]] Point3 corner(int n) const {
    return {(n & 1 ? high : low).x, (n & 2 ? high : low).y, (n & 4 ? high : low).z};
  }
};

}  // namespace hw::drawing
