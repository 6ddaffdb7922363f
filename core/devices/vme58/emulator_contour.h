#pragma once
// A recorded contour: CD .. CE or CK. The firmware records it, the motion plays it (CX).
#include <array>
#include <cstdint>
#include <vector>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

struct RecordedPiece {
  enum class Kind : std::uint8_t { line, arc, outputs };
  Kind kind = Kind::line;
  /// line: where to, one absolute position for each axis of the contour, in axis order (decision M68).
  std::array<std::int64_t, most_axes> to{};
  /// arc: absolute centre on the first and second axis; angle in radians, positive counter-clockwise with the
  /// first axis to the right and the second up (decision M70).
  std::int64_t centre_first = 0, centre_second = 0;
  double angle = 0;
  /// outputs: these auxiliary outputs (bit = axis) go high or low when the path reaches this piece (decision
  /// M69).
  unsigned outputs = 0;
  bool high = false;
};

struct Contour {
  unsigned axes = 0;                            ///< axes of the contour, bit per axis
  std::array<std::int64_t, most_axes> start{};  ///< by axis index
  std::vector<RecordedPiece> pieces;
  bool kill = false;  ///< CK: stop dead at the end; CE: ramp down from there (decisions M73, M74)
  /// Closed by CE or CK without an error: CX may play it.
  bool complete = false;

  [[nodiscard]] bool has(int axis) const { return (axes >> axis & 1u) != 0; }
  [[nodiscard]] int axis_count() const { return __builtin_popcount(axes); }
};

/// The commands between CD and its end, and the rest of them for CX.
class ContourRecorder {
 public:
  /// CD: drops the contour before it.
  void begin() { *this = ContourRecorder(), on_ = true; }
  void goes(int axis, std::int64_t from) {
    contour_.axes |= 1u << axis;
    contour_.start[static_cast<std::size_t>(axis)] = from;
  }
  void add(const RecordedPiece& piece, int entries) {
    contour_.pieces.push_back(piece);
    entries_ += entries;
  }
  /// An error on the way: CX will refuse it.
  void spoil() { spoiled_ = true; }
  void end(bool kill) {
    on_ = false;
    contour_.kill = kill;
    contour_.complete = !spoiled_;
  }
  /// A selector ends it: without CE or CK it is not complete.
  void give_up() { on_ = false; }

  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] int entries() const { return entries_; }
  [[nodiscard]] const Contour& contour() const { return contour_; }

 private:
  Contour contour_;
  bool on_ = false, spoiled_ = false;
  int entries_ = 0;
};

}  // namespace hw::vme58
