#pragma once
// What is wanted of a drawing: its unit, place and layers, the tool and its speeds. Ids: `drawing/unit`,
// `drawing/along_x`, `drawing/along_y`, `drawing/per_unit/AXIS`, `drawing/origin/...`, `drawing/swap`,
// `drawing/flip_x`, `drawing/flip_y`, `drawing/table/left` (right, bottom, top), `drawing/tolerance`,
// `drawing/tool`, `drawing/wait_on`, `drawing/wait_off`, `drawing/cut_speed`, `drawing/travel_speed`,
// `drawing/keep_order`, `drawing/layer/NAME`.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/conversion.h"
#include "gui/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class DrawingOptions {
 public:
  /// At ImGui's cursor; `drawing` null: there is none yet, so no layers.
  void draw(gui::Frame& frame, const drawing::Drawing* drawing);
  /// Once a frame: what was chosen since becomes what is wanted.
  void settle(const gui::Frame& frame, const drawing::Drawing* drawing);
  /// As the controller and the units of its axes suggest, before anybody has chosen.
  void begin(const gui::Frame& frame);
  /// Of another file.
  void forget_file() { left_out_.clear(), point_ = {}, changed_ = true; }
  /// A click shall say what lies at 0, 0.
  [[nodiscard]] bool wants_origin() const { return origin_ == 2; }
  /// A place of the drawing.
  void set_origin(drawing::Point of_drawing) { point_ = of_drawing, changed_ = true; }
  /// The axes that go along its X and Y, by their place in the catalog.
  [[nodiscard]] const std::array<int, 2>& axes() const { return axes_; }
  [[nodiscard]] const ConversionOptions& wanted() const { return wanted_; }
  /// Changes with wanted().
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  enum Number : std::size_t {
    per_unit_x,
    per_unit_y,
    table_left,
    table_right,
    table_bottom,
    table_top,
    tolerance,
    wait_on,
    wait_off,
    cut_speed,
    travel_speed,
    numbers
  };
  void draw_place(gui::Frame& frame, const drawing::Drawing* drawing);
  void draw_tool(gui::Frame& frame);
  void draw_layers(gui::Frame& frame, const drawing::Drawing& drawing);
  void draw_axes(gui::Frame& frame);
  void draw_table(gui::Frame& frame);
  void take_scale(const gui::Frame& frame, std::size_t direction);
  void number(gui::Frame& frame, Number which, std::string_view id, std::string_view label, double least,
              std::string_view unit);
  void toggle(gui::Frame& frame, const char* id, const char* label, bool& value);
  void build(const gui::Frame& frame, const drawing::Drawing* drawing);
  void set(Number which, double value, int decimals);

  bool begun_ = false, changed_ = true;
  std::array<gui::NumberField, numbers> fields_;
  std::array<double, numbers>
      values_{};  ///< the last of each that was a number; 0: none, or the controller's own
  int unit_ = 0, origin_ = 0, tool_ = 0;
  std::array<int, 2> axes_{0, 1};
  drawing::Point point_;  ///< of the drawing, at 0, 0
  bool swap_ = false, flip_x_ = false, flip_y_ = false, keep_order_ = false;
  std::vector<std::string> left_out_;  ///< layers
  std::vector<std::string_view> tool_names_, axis_names_;
  ConversionOptions wanted_;
  std::uint64_t version_ = 1;
};

}  // namespace hw::panels
