#pragma once
// Shows the placement of a drawing: its unit, the drawing axes and their scale, the point at 0, 0, and the
// table. Ids: `drawing/unit`, `drawing/times`, `drawing/along_x`, `drawing/along_y`, `drawing/per_unit/AXIS`,
// `drawing/origin/...`, `drawing/swap`, `drawing/flip_x`, `drawing/flip_y`, `drawing/tolerance`,
// `drawing/mirrored/AXIS`, `drawing/join`, `drawing/table/left` (right, bottom, top).
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/conversion.h"
#include "core/session/kept_options.h"
#include "panels/drawing/option_fields.h"
#include "panels/drawing/scale_option.h"

namespace hw::panels {

/// The scale that follows from the unit kept for an axis, whether it is shown now or not.
struct KeptScale {
  double steps_in_mm = 0;  ///< takes precedence over a scale typed earlier; 0: the unit is not a length
  bool opposite = false;   ///< the unit counts opposite to the steps
  bool operator==(const KeptScale&) const = default;
};
KeptScale kept_scale(const gui::Frame& frame, int axis);
/// The steps in a mm; 100 if the kept unit is not a length.
double steps_in_mm(const gui::Frame& frame, int axis);

class DrawingPlace {
 public:
  void begin(const gui::Frame& frame);
  /// `drawing` is null while none is open. Returns true when an option has changed.
  bool draw(gui::Frame& frame, const drawing::Drawing* drawing);
  /// Call once a frame. A unit that the user has chosen at the positions since gives the scale. Returns true
  /// when it does.
  bool follow_units(const gui::Frame& frame);
  void put(const gui::Frame& frame, ConversionOptions& options) const;
  /// Keeps the options of the machine, not those of the drawing. The user gives the tolerance of stairs for
  /// each drawing.
  void keep(const gui::Frame& frame, KeptOptions& kept) const;
  void take(const gui::Frame& frame, const KeptOptions& kept);
  /// The sentence about the first field that holds no number; empty: none.
  [[nodiscard]] std::string wrong() const;

  /// Call when another file is opened, because it may have another unit.
  void forget_file() { unit_ = -1, times_.set(1, 3), set_origin({}); }
  /// Whether the next click sets the point at 0, 0.
  [[nodiscard]] bool wants_origin() const { return origin_ == 2; }
  /// `of_drawing`: a point of the drawing.
  void set_origin(drawing::Point of_drawing) { point_ = of_drawing; }
  /// The axes along its X and Y, as indexes into the catalog.
  [[nodiscard]] const std::array<int, 2>& axes() const { return axes_; }
  /// The form in which all scales are shown.
  [[nodiscard]] ScaleForm form() const { return form_; }

 private:
  void take_axis(const gui::Frame& frame, std::size_t direction, int axis);
  bool draw_unit(gui::Frame& frame, const drawing::Drawing* drawing);
  bool draw_axes(gui::Frame& frame);
  bool draw_scale_form(gui::Frame& frame);
  static void draw_mirrored(gui::Frame& frame, std::string_view axis);
  bool draw_table(gui::Frame& frame);
  [[nodiscard]] std::string_view table_in_words() const;

  int unit_ = -1;             ///< overrides the file's unit; -1: as in the file
  std::string unit_of_file_;  ///< "mm, by the file"; empty: the file names no unit
  std::vector<std::string_view> units_;
  NumberOption times_;
  int origin_ = 0;
  std::array<int, 2> axes_{0, 1};
  std::array<ScaleOption, 2> per_unit_;
  ScaleForm form_ = ScaleForm::steps_in_mm;
  std::vector<std::string_view> form_names_;
  std::vector<Path> form_words_;
  std::vector<double> scales_;  ///< typed scales by axis, also for axes that do not draw; 0: none typed
  std::vector<double> kept_;    ///< kept_scale() of each axis at the last look
  std::vector<std::string_view> axis_names_;
  drawing::Point point_;  ///< point of the drawing at 0, 0
  bool swap_ = false, flip_x_ = false, flip_y_ = false;
  NumberOption tolerance_;
  NumberOption join_;
  std::array<NumberOption, 4> table_;  ///< left, right, bottom, top
};

}  // namespace hw::panels
