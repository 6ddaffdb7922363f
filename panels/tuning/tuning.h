#pragma once
// The step response of a servo axis: makes and records a step, draws it over the previous run, and measures
// it; gains are edited beside it. Ids: `tuning/record`, `tuning/repeat`, `tuning/scatter`, `tuning/axis`,
// `tuning/step`, `tuning/length`, `tuning/compare`, `tuning/plot`, `tuning/error`, `tuning/output`,
// `tuning/KPX`, `tuning/send`, `tuning/measure/overshoot` (`/before`, `/change`).
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "gui/model/step_response.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/plot.h"

namespace hw::panels {

class Tuning final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;
  /// Takes a sample of the recording under way; drops others.
  void take(const AxisSample& sample);

 private:
  enum class Stage : std::uint8_t {
    idle,
    arming,     ///< the recording is requested; the step follows its first sample
    recording,  ///< the step is made
    pausing     ///< between two steps of Repeat
  };
  void make(const gui::Frame& frame);
  void follow(gui::Frame& frame);
  [[nodiscard]] bool was_away(const gui::Frame& frame);
  [[nodiscard]] std::string_view interruption(const gui::Frame& frame, bool away) const;
  void finish(gui::Frame& frame);
  bool ended_early(gui::Frame& frame);
  void measure_before();
  void begin_repeat(gui::Frame& frame, int steps);
  void end_repeat(gui::Frame& frame, std::string why);
  void end_where_it_began(gui::Frame& frame);
  void learn_scatter(gui::Frame& frame);
  void record(gui::Frame& frame);
  void make_step(gui::Frame& frame);
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame);
  [[nodiscard]] bool asked_by_others(const gui::Frame& frame) const;

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

  [[nodiscard]] const gui::StepRun* latest() const { return runs_.empty() ? nullptr : &runs_.back(); }
  [[nodiscard]] bool shows_output() const;
  /// The run that the latest is compared with; null: none.
  [[nodiscard]] const gui::StepRun* before() const;
  [[nodiscard]] AxisId axis() const { return axes_[static_cast<std::size_t>(chosen_)]; }

  bool made_ = false;
  std::vector<AxisId> axes_;  ///< with gains
  std::vector<std::string_view> names_;
  std::vector<std::size_t> gains_;           ///< of the chosen axis: indexes into Catalog::params
  std::vector<gui::NumberField> fields_;     ///< by parameter
  std::vector<std::string_view> run_names_;  ///< into `run_texts_`
  std::vector<std::string> run_texts_;
  int chosen_ = 0, compare_ = 0;  ///< compare_: number of a run; 0: the previous one
  gui::NumberField step_, length_;

  Stage stage_ = Stage::idle;
  struct Repeat {
    bool on = false;
    int steps_left =
        0;  ///< even, so that the axis returns to its start; negative: until Repeat is pressed again
    bool learns_scatter = false;
  };
  Repeat repeat_;
  int sign_ = 1, number_ = 0;
  Steps step_now_{};  ///< of the run under way, with its sign
  double since_s_ = 0, length_ms_ = 0, drawn_s_ = 0;
  Instant first_at_{}, last_at_{};
  bool any_sample_ = false;
  int drawn_frame_ = 0;
  std::uint64_t timeouts_ = 0;      ///< of the link, when the latest step was requested
  std::uint32_t restarts_ = 0;      ///< of the controller, likewise
  IntentId move_ = 0, newest_ = 0;  ///< newest_: the latest move sent by this panel
  std::deque<gui::StepRun> runs_;   ///< oldest first
  // Of the latest complete run, and of the run it is compared with; number 0: none.
  gui::StepMeasures now_, was_;
  gui::StepScatter scatter_;  ///< of this axis, step and length
  int now_number_ = 0, was_number_ = 0;
  gui::PlotCursor cursor_;
};

/// Recorded milliseconds unless the user types another number.
inline constexpr double usual_length_ms = 230;

/// The controller has servo axes with gains.
bool can_tune(const Catalog& catalog);

}  // namespace hw::panels
