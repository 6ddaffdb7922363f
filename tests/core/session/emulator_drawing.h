#pragma once
// A drawing, converted for a controller and drawn by its emulator in virtual time: where its tool has been.
#include <utility>
#include <vector>

#include "core/device/registry.h"
#include "core/session/conversion.h"

namespace hw {

struct EmulatorDrawing {
  explicit EmulatorDrawing(const char* model);

  /// Converts, writes and rehearses, in pieces where one program does not hold it; fails the test where that
  /// is not possible.
  void draw(const drawing::Drawing& drawing);
  /// Within one step, and with the tool down where it is more than a dot.
  void expect_every_vertex() const;
  /// With the tool down it stays within the tolerance and one step of the drawing.
  void expect_nothing_beside() const;
  [[nodiscard]] int output_number() const { return catalog.output_number(static_cast<std::size_t>(out)); }

  static constexpr double per_unit = 200;
  const DeviceType& type;
  const Catalog catalog;
  int out;  ///< of the tool, by its place in the catalog: the last one; a VME58 switches it within contours
  ConversionOptions o;
  Conversion made;
  Rehearsal rehearsal;

 private:
  void rehearse(const std::string& text, std::vector<std::int64_t> start_at);
  [[nodiscard]] drawing::Point at(std::size_t n) const;
  [[nodiscard]] bool down(std::size_t n) const { return (rehearsal.track[n].outputs >> out & 1u) != 0; }
  [[nodiscard]] double nearest_pass(drawing::Point to, bool dot) const;
  [[nodiscard]] std::vector<std::pair<drawing::Point, drawing::Point>> drawn_lines() const;
};

}  // namespace hw
