#pragma once
// The step response of a servo axis: makes and records a step, draws it over the previous run, and measures
// it. The gains are edited beside it. Ids: `tuning/record`, `tuning/repeat`, `tuning/scatter`, `tuning/axis`,
// `tuning/step`, `tuning/length`, `tuning/compare`, `tuning/plot`, `tuning/error`, `tuning/output`,
// `tuning/KPX`, `tuning/send`, `tuning/measure/overshoot` (`/before`, `/change`).
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "gui/model/step_recorder.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/plot.h"

namespace hw::panels {

class Tuning final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void make(const gui::Frame& frame);
  void follow(gui::Frame& frame);
  void name_runs();
  void measure_before();
  void choose_axis(gui::Frame& frame, int axis);
  /// The plan in the fields. Call only while why_not() is empty.
  [[nodiscard]] gui::StepRecorder::Plan plan() const;
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame) const;
  /// The same for a step that cannot be made while Repeat is on.
  [[nodiscard]] std::string_view why_not_beside_repeat(const gui::Frame& frame) const;

  void draw_toolbar(gui::Frame& frame);
  void draw_fields(gui::Frame& frame);
  void draw_compare(gui::Frame& frame, float right, float top);
  void draw_work(gui::Frame& frame, float width, float height);
  void draw_plots(gui::Frame& frame, float width, float height);
  void draw_error(gui::Frame& frame, float width, float height, bool lowest);
  void draw_output(gui::Frame& frame, float height);
  void draw_side(gui::Frame& frame, float width);
  void draw_scatter(gui::Frame& frame, float width);
  void draw_gain(gui::Frame& frame, std::size_t param, float width);
  void send_gains(gui::Frame& frame);

  [[nodiscard]] const gui::StepRun* latest() const {
    return recorder_->runs().empty() ? nullptr : &recorder_->runs().back();
  }
  [[nodiscard]] bool shows_output() const;
  /// The run with which the latest run is compared; null: none.
  [[nodiscard]] const gui::StepRun* before() const;
  [[nodiscard]] AxisId axis() const { return axes_[static_cast<std::size_t>(chosen_)]; }

  gui::StepRecorder* recorder_ = nullptr;  ///< of the desk
  std::vector<AxisId> axes_;               ///< axes with gains
  std::vector<std::string_view> names_;
  std::vector<std::size_t> gains_;        ///< gains of the chosen axis: indexes into Catalog::params
  std::vector<gui::NumberField> fields_;  ///< by parameter
  int chosen_ = 0;
  gui::NumberField step_, length_;
  /// The run with which the latest run is compared.
  struct Compared {
    int wanted = 0;  ///< number of a run; 0: the previous one
    int latest = 0;  ///< number of the run for which it was found
    int number = 0;  ///< 0: none
    gui::StepMeasures measures;
    std::vector<std::string> texts;       ///< the runs to choose from
    std::vector<std::string_view> names;  ///< into `texts`
  };
  Compared compared_;
  gui::PlotCursor cursor_;
};

/// Whether the controller has servo axes with gains.
bool can_tune(const Catalog& catalog);

}  // namespace hw::panels
