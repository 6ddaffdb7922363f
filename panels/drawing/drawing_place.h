#pragma once
// Where a drawing comes to lie: its unit, the axes that draw it and their scale, what lies at 0, 0, and the
// table. Ids: `drawing/unit`, `drawing/along_x`, `drawing/along_y`, `drawing/per_unit/AXIS`,
// `drawing/origin/...`, `drawing/swap`, `drawing/flip_x`, `drawing/flip_y`, `drawing/tolerance`,
// `drawing/join`, `drawing/table/left` (right, bottom, top).
#include <array>
#include <string_view>
#include <vector>

#include "core/session/conversion.h"
#include "core/session/kept_options.h"
#include "panels/drawing/option_fields.h"

namespace hw::panels {

/// Steps in a mm of an axis, as the units of the console have it; 100 where they are others.
double steps_in_mm(const gui::Frame& frame, int axis);
/// Its unit says how long a step is, and knows it better than a scale that was typed once.
bool counts_in_mm(const gui::Frame& frame, int axis);

class DrawingPlace {
 public:
  void begin(const gui::Frame& frame);
  /// `drawing` null: there is none yet. True: something of it is another now.
  bool draw(gui::Frame& frame, const drawing::Drawing* drawing);
  void put(const gui::Frame& frame, ConversionOptions& options) const;
  /// What belongs to the machine and not to the drawing. The tolerance of stairs is told anew for each.
  void keep(const gui::Frame& frame, KeptOptions& kept) const;
  void take(const gui::Frame& frame, const KeptOptions& kept);
  /// The first field that holds no number, as a sentence; empty: none.
  [[nodiscard]] std::string wrong() const;

  /// Another one may be in another unit.
  void forget_file() { unit_ = -1, set_origin({}); }
  /// A click shall say what lies at 0, 0.
  [[nodiscard]] bool wants_origin() const { return origin_ == 2; }
  /// A place of the drawing.
  void set_origin(drawing::Point of_drawing) { point_ = of_drawing; }
  /// The axes that go along its X and Y, by their place in the catalog.
  [[nodiscard]] const std::array<int, 2>& axes() const { return axes_; }

 private:
  void take_axis(const gui::Frame& frame, std::size_t direction, int axis);
  bool draw_unit(gui::Frame& frame, const drawing::Drawing* drawing);
  bool draw_axes(gui::Frame& frame);
  bool draw_table(gui::Frame& frame);
  [[nodiscard]] std::string_view said_of_table() const;

  int unit_ = -1;  ///< of a file that does not say it; -1: nobody has
  int origin_ = 0;
  std::array<int, 2> axes_{0, 1};
  std::array<NumberOption, 2> per_unit_;
  std::vector<double>
      scales_;  ///< as they were typed, of each axis, also while it does not draw; 0: none was
  std::vector<std::string_view> axis_names_;
  drawing::Point point_;  ///< of the drawing, at 0, 0
  bool swap_ = false, flip_x_ = false, flip_y_ = false;
  NumberOption tolerance_;
  NumberOption join_;
  std::array<NumberOption, 4> table_;  ///< left, right, bottom, top
};

}  // namespace hw::panels
