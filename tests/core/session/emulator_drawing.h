#pragma once
// A drawing, converted for a controller and drawn by its emulator in virtual time: where its tool has been.
#include <string>
#include <vector>

#include "core/device/registry.h"
#include "drawn_track.h"

namespace hw {

struct EmulatorDrawing : DrawnTrack {
  /// Its tool is the last output; a VME58 switches that within contours.
  explicit EmulatorDrawing(const char* model);

  /// Converts, writes and rehearses, in pieces where one program does not hold it; fails the test where that
  /// is not possible.
  void draw(const drawing::Drawing& drawing);
  [[nodiscard]] int output_number() const { return catalog.output_number(static_cast<std::size_t>(out)); }

  const DeviceType& type;
  const Catalog catalog;
  ConversionOptions o;

 private:
  void rehearse(const std::string& text, std::vector<std::int64_t> start_at);
};

}  // namespace hw
