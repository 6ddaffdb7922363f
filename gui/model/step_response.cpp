#include "gui/model/step_response.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hw::gui {
namespace {

constexpr double settled_share = 0.02;
constexpr std::size_t usual_samples = 4096;

/// When `y` first reaches `level`, between samples; negative: never.
double reaches(const StepRun& run, double level) {
  const auto t = run.t_ms(), y = run.encoder();
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (t[i] < 0 || static_cast<double>(y[i]) < level) continue;
    if (i == 0 || y[i] == y[i - 1]) return t[i];
    const double share = (level - static_cast<double>(y[i - 1])) / static_cast<double>(y[i] - y[i - 1]);
    return static_cast<double>(t[i - 1]) + share * static_cast<double>(t[i] - t[i - 1]);
  }
  return -1;
}

void measure_settling(const StepRun& run, double target, StepMeasures& m) {
  const auto t = run.t_ms(), y = run.encoder();
  std::size_t last_outside = 0;
  bool any_outside = false;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (std::fabs(static_cast<double>(y[i]) - target) > m.band) last_outside = i, any_outside = true;
  m.settled = !y.empty() && (!any_outside || last_outside + 1 < y.size());
  if (m.settled && any_outside) m.settling_ms = std::max(0.0f, t[last_outside + 1]);
}

int count_crossings(const StepRun& run, double target) {
  int crossings = 0, side = -1;
  for (const float y : run.encoder()) {
    const double off = static_cast<double>(y) - target;
    const int now = off > 0.5 ? 1 : off < -0.5 ? -1 : 0;
    if (now == 0 || now == side) continue;
    side = now;
    ++crossings;
  }
  return crossings;
}

}  // namespace

StepRun::StepRun(int number, AxisId axis, Steps step) : number_(number), axis_(axis), step_(step) {
  for (auto* v : {&t_ms_, &command_, &encoder_, &error_, &output_}) v->reserve(usual_samples);
}

void StepRun::take(const AxisSample& s) {
  if (s.axis != axis_.index) return;
  if (t_ms_.empty()) first_at_ = s.at, from_command_ = s.command, from_encoder_ = s.encoder;
  const float sign = step_.value < 0 ? -1.0f : 1.0f;
  const float command = sign * static_cast<float>((s.command - from_command_).value);
  const float encoder = sign * static_cast<float>((s.encoder - from_encoder_).value);
  const float ms = std::chrono::duration<float, std::milli>(s.at - first_at_).count();
  if (!began_ && command != 0) {
    // The sample before is the last at which nothing had happened: time starts there.
    began_ = true;
    origin_ms_ = t_ms_.back();
    for (float& t : t_ms_) t -= origin_ms_;
  }
  t_ms_.push_back(ms - origin_ms_);
  command_.push_back(command);
  encoder_.push_back(encoder);
  error_.push_back(command - encoder);
  if (s.output_known) output_.push_back(sign * s.output_percent);
}

float StepRun::largest_output() const {
  float largest = 0;
  for (const float v : output()) largest = std::max(largest, std::fabs(v));
  return largest;
}

StepMeasures measure(const StepRun& run) {
  StepMeasures m;
  if (!run.moved() || run.step() == 0) return m;
  m.any = true;
  const auto y = run.encoder(), e = run.error();
  const double target = static_cast<double>(run.command().back());
  m.band = std::max(1.0, settled_share * run.step());
  const auto highest = std::max_element(y.begin(), y.end());
  m.overshoot_percent = std::max(0.0, (static_cast<double>(*highest) - target) / run.step() * 100);
  m.peak_ms = run.t_ms()[static_cast<std::size_t>(highest - y.begin())];
  const double low = reaches(run, 0.1 * target), high = reaches(run, 0.9 * target);
  m.rose = low >= 0 && high >= 0;
  if (m.rose) m.rise_ms = high - low;
  measure_settling(run, target, m);
  m.crossings = count_crossings(run, target);
  const std::size_t tail = std::max<std::size_t>(1, e.size() / 10);
  double sum = 0;
  for (const float v : e.last(tail)) sum += v;
  m.steady_error = sum / static_cast<double>(tail);
  for (const float v : e) m.largest_error = std::max(m.largest_error, std::fabs(static_cast<double>(v)));
  return m;
}

}  // namespace hw::gui
