#pragma once
// Shows the tool of a drawing: the axis that lowers it, the output that switches it, the time that this
// takes, and the speeds with it on and off; or the user's own routines. Ids: `drawing/tool`,
// `drawing/wait_on`, `drawing/wait_off`, `drawing/tool_axis`, `drawing/tool_axis/per_unit`,
// `drawing/tool_axis/down`, `drawing/tool_axis/up`, `drawing/own_routines`, `drawing/routine/on`,
// `drawing/routine/off`, `drawing/routine/wrong`, `drawing/tool/turned`, `drawing/cut_speed`,
// `drawing/travel_speed`, `drawing/low_speed`, `drawing/ramp`.
#include <array>
#include <string>
#include <vector>

#include "core/session/conversion.h"
#include "core/session/kept_options.h"
#include "core/session/tool_routine.h"
#include "panels/drawing/drawing_place.h"
#include "panels/drawing/option_fields.h"
#include "panels/drawing/scale_option.h"

namespace hw::panels {

class DrawingTool {
 public:
  void begin(const gui::Frame& frame);
  /// `drawing_axes` draw, so they cannot lower the tool. Returns true when an option has changed.
  bool draw(gui::Frame& frame, const std::array<int, 2>& drawing_axes, ScaleForm form);
  /// Call once a frame. A unit that the user has chosen at the positions since gives the scale and direction
  /// of the tool's axis. Returns true when they have changed.
  bool follow_units(const gui::Frame& frame);
  /// Adds the tool to the options. Its axis comes after those that draw.
  void put(const gui::Frame& frame, ConversionOptions& options);
  void keep(const gui::Frame& frame, KeptOptions& kept) const;
  void take(const gui::Frame& frame, const KeptOptions& kept);
  /// Why a routine of the user is not understood, or which field holds no number; empty: all are valid.
  [[nodiscard]] std::string wrong() const;

 private:
  /// The tool as typed, not inverted where its axis counts opposite to its steps.
  [[nodiscard]] PlainTool tool(const gui::Frame& frame) const;
  void put_choices(const gui::Frame& frame, ConversionOptions& options) const;
  void put_routines(const gui::Frame& frame, ConversionOptions& options);
  bool draw_choices(gui::Frame& frame);
  bool draw_speeds(gui::Frame& frame);
  /// A number that is kept, with its key.
  struct Named {
    const char* id;
    NumberOption DrawingTool::*option;
  };
  static const std::array<Named, 8> numbers;
  bool draw_routines(gui::Frame& frame);
  void begin_routines(const gui::Frame& frame, const std::array<int, 2>& drawing_axes);
  void list_axes(const gui::Frame& frame, const std::array<int, 2>& drawing_axes);
  bool draw_axis(gui::Frame& frame);
  void draw_turned(gui::Frame& frame) const;
  void describe_turned(const gui::Frame& frame, const ConversionOptions& options);

  int output_ = 0;  ///< index into the names of the outputs
  std::vector<std::string_view> output_names_;
  int axis_ = -1;          ///< index into the catalog; -1: none
  std::vector<int> axes_;  ///< possible tool axes, after "none"
  std::vector<std::string_view> axis_names_;
  std::vector<KeptScale> kept_;  ///< scale of each axis at the last look
  ScaleOption per_unit_;
  ScaleForm form_ = ScaleForm::steps_in_mm;
  NumberOption down_, up_;
  NumberOption wait_on_, wait_off_, cut_speed_, travel_speed_, low_speed_, ramp_;
  bool own_ = false;
  std::array<std::string, 2> routines_;  ///< on, off: see read_routine()
  std::string wrong_;                    ///< why the routines are not understood
  std::string turned_;                   ///< names the axes of the tool that count opposite to their steps
};

}  // namespace hw::panels
