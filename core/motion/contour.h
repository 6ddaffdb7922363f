#pragma once
// A chain of lines and arcs, run at one speed, through its corners too. It is divided into fine steps of
// equal length (as a Path into pulses), so that a Profile of those steps gives the time of each, and each
// axis is on the count nearest to the true curve.
//
//   start o-----line-----o.
//                          `.  arc, about a centre in the plane of two axes
//                            o - - - ray, straight on from the last piece without end
//
// Offsets count from the start. Pieces are kept exactly: rounding at one end does not bend the next.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/motion/path.h"

namespace hw::motion {

class Contour {
 public:
  using Point = std::array<double, path_axes>;
  static constexpr std::int64_t steps_per_count = 64;

  explicit Contour(const Offsets& start);

  void line_to(const Point& to);
  /// Around `centre` in the plane of two axes; `sweep` positive: counter-clockwise with x to the right and y
  /// up.
  void arc(std::size_t x_axis, std::size_t y_axis, double centre_x, double centre_y, double sweep);
  /// Extends the last piece that has a length straight on. Must be the last call.
  void ray();

  /// End of the last piece.
  [[nodiscard]] const Point& end() const { return end_; }
  [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }
  /// In counts.
  [[nodiscard]] double length() const { return length_; }
  /// The first step at or after the end of a piece.
  [[nodiscard]] std::int64_t end_of(std::size_t piece) const;

  // As in Path.
  [[nodiscard]] std::int64_t steps() const;
  [[nodiscard]] std::int64_t offset(std::size_t axis, std::int64_t step) const;
  [[nodiscard]] double exact(std::size_t axis, double step) const;
  [[nodiscard]] bool moves(std::size_t axis) const;
  [[nodiscard]] int direction(std::size_t axis, std::int64_t step) const;
  [[nodiscard]] std::int64_t next_turn(std::int64_t step) const;
  [[nodiscard]] std::optional<std::int64_t> first_at(std::size_t axis, std::int64_t step,
                                                     std::int64_t offset) const;
  /// The axis' share of the path's speed at a step: -1 to 1.
  [[nodiscard]] double share(std::size_t axis, double step) const;

 private:
  struct Piece {
    double begin = 0, length = 0;  ///< counts along the contour
    Point from{}, way{};           ///< line: direction of length 1
    bool arc = false;
    std::size_t x = 0, y = 1;
    double centre_x = 0, centre_y = 0, radius = 0, angle = 0, sweep = 0;
    [[nodiscard]] double at(std::size_t axis, double s) const;
    [[nodiscard]] double share(std::size_t axis, double s) const;
    [[nodiscard]] double angle_at(double s) const { return angle + sweep * s / length; }
  };
  void add(Piece piece);
  [[nodiscard]] const Piece* piece_at(double s) const;
  [[nodiscard]] double along(std::int64_t step) const;

  Offsets start_;
  Point end_{};
  double length_ = 0;
  bool endless_ = false;
  std::vector<Piece> pieces_;
};

}  // namespace hw::motion
