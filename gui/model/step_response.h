#pragma once
// One recorded step of an axis: its command, its path, and measures for tuning its gains. Pure.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/device/snapshot.h"

namespace hw::gui {

/// Positions count from the start, in the direction of the step: a step of 400 goes from 0 to 400, whichever
/// way it moved. Times count from the first change of the command.
class StepRun {
 public:
  StepRun() = default;
  StepRun(int number, AxisId axis, Steps step);

  void take(const AxisSample& sample);
  /// All samples have been taken: an unusually long interval counts as a gap from now on, and so does the
  /// missing end of a recording of `length_ms`; 0: none.
  void end(double length_ms = 0);

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] AxisId axis() const { return axis_; }
  [[nodiscard]] double step() const {
    return static_cast<double>(step_.value < 0 ? -step_.value : step_.value);
  }
  [[nodiscard]] bool moved() const { return began_; }
  [[nodiscard]] bool empty() const { return t_ms_.empty(); }
  [[nodiscard]] std::span<const float> t_ms() const { return t_ms_; }
  [[nodiscard]] std::span<const float> command() const { return command_; }
  [[nodiscard]] std::span<const float> encoder() const { return encoder_; }
  [[nodiscard]] std::span<const float> error() const { return error_; }
  /// In percent of the full output; empty unless known throughout.
  [[nodiscard]] std::span<const float> output() const {
    return output_.size() == t_ms_.size() ? std::span<const float>(output_) : std::span<const float>();
  }
  /// The samples with a gap before them, in order: the course in between is unknown, since they are unusually
  /// far apart, or the axis moved by more than a third of the step. None before end().
  [[nodiscard]] std::span<const std::size_t> gaps() const { return gaps_; }
  [[nodiscard]] bool gap_before(std::size_t sample) const {
    return std::binary_search(gaps_.begin(), gaps_.end(), sample);
  }
  /// Its last samples are missing.
  [[nodiscard]] bool cut_short() const { return cut_short_; }
  /// When it would have ended.
  [[nodiscard]] float planned_end_ms() const { return planned_end_ms_; }
  /// The largest magnitude of the output.
  [[nodiscard]] float largest_output() const;

 private:
  int number_ = 0;
  AxisId axis_{};
  Steps step_{};
  bool began_ = false, cut_short_ = false;
  Instant first_at_{};
  Steps from_command_{}, from_encoder_{};
  float origin_ms_ = 0, planned_end_ms_ = 0;
  std::vector<float> t_ms_, command_, encoder_, error_, output_;
  std::vector<std::size_t> gaps_;
};

/// A value between two bounds: the course within a gap of the samples is unknown.
struct Measure {
  double low = 0, high = 0;
  Measure() = default;
  Measure(double exact) : low(exact), high(exact) {}  // NOLINT: converts on purpose
  Measure(double from, double to) : low(from), high(to) {}
  static Measure at_least(double value) { return {value, std::numeric_limits<double>::infinity()}; }
  [[nodiscard]] bool exact() const { return low == high; }
  [[nodiscard]] bool open() const { return std::isinf(high); }
};

struct StepMeasures {
  bool any = false;
  int gaps = 0;  ///< after the step had begun; a missing end is one of them
  Measure overshoot_percent;
  double peak_ms = 0;
  bool rose = false;
  Measure rise_ms;  ///< from 10 to 90 % of the step
  bool settled = false;
  Measure settling_ms;        ///< after the step, within `band` from then on
  double band = 0;            ///< 2 % of the step, at least one count
  bool steady_known = false;  ///< no gap in it
  Measure steady_error;       ///< command minus encoder, mean of the last tenth
  Measure largest_error;      ///< in the whole recording
  Measure crossings;          ///< how often the encoder passed its target
};
StepMeasures measure(const StepRun& run);

/// The scatter of the measures of the same step while nothing is changed.
class StepScatter {
 public:
  static constexpr int enough = 3;
  void take(const StepMeasures& measures);
  [[nodiscard]] bool known() const { return taken_ >= enough; }
  /// Greatest minus least of the selected measure; nothing: one of them is not exact.
  using Of = std::optional<Measure> (*)(const StepMeasures&);
  [[nodiscard]] std::optional<double> of(Of measure) const;

 private:
  int taken_ = 0;
  std::array<StepMeasures, enough> all_{};
};

}  // namespace hw::gui
