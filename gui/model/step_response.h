#pragma once
// One recorded step of an axis: where it was sent, where it went, and what that says of its gains. Pure.
#include <span>
#include <vector>

#include "core/device/snapshot.h"

namespace hw::gui {

/// Positions count from where the axis stood, in the direction of the step: a step of 400 goes from 0 to 400,
/// whichever way it moved. Times count from the first change of the command.
class StepRun {
 public:
  StepRun() = default;
  StepRun(int number, AxisId axis, Steps step);

  void take(const AxisSample& sample);

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
  /// In percent of what the output can give; empty unless it was known all the time.
  [[nodiscard]] std::span<const float> output() const {
    return output_.size() == t_ms_.size() ? std::span<const float>(output_) : std::span<const float>();
  }
  /// The largest of it, without sign.
  [[nodiscard]] float largest_output() const;

 private:
  int number_ = 0;
  AxisId axis_{};
  Steps step_{};
  bool began_ = false;
  Instant first_at_{};
  Steps from_command_{}, from_encoder_{};
  float origin_ms_ = 0;
  std::vector<float> t_ms_, command_, encoder_, error_, output_;
};

struct StepMeasures {
  bool any = false;
  double overshoot_percent = 0;
  double peak_ms = 0;
  bool rose = false;
  double rise_ms = 0;  ///< from 10 to 90 % of the step
  bool settled = false;
  double settling_ms = 0;    ///< after the step, within `band` from then on
  double band = 0;           ///< 2 % of the step, at least one count
  double steady_error = 0;   ///< command minus encoder, mean of the last tenth
  double largest_error = 0;  ///< while it went there
  int crossings = 0;         ///< how often the encoder passed its target
};
StepMeasures measure(const StepRun& run);

}  // namespace hw::gui
