#include "gui/model/step_response.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hw::gui {
namespace {

constexpr double settled_share = 0.02;
constexpr std::size_t usual_samples = 4096;

/// When `y` first reaches `level`, between samples; nothing: never. In any earlier gap it may have been there
/// and gone back.
std::optional<Measure> reaches(const StepRun& run, double level) {
  const auto t = run.t_ms(), y = run.encoder();
  std::optional<double> unseen_from;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (t[i] < 0) continue;
    if (!unseen_from && t[i] > 0 && run.gap_before(i)) unseen_from = t[i - 1];
    if (static_cast<double>(y[i]) < level) continue;
    if (run.gap_before(i)) return Measure(unseen_from.value_or(t[i - 1]), t[i]);  // so i > 0
    if (i == 0 || y[i] == y[i - 1]) return Measure(unseen_from.value_or(t[i]), t[i]);
    const double share = (level - static_cast<double>(y[i - 1])) / static_cast<double>(y[i] - y[i - 1]);
    const double at = static_cast<double>(t[i - 1]) + share * static_cast<double>(t[i] - t[i - 1]);
    return Measure(unseen_from.value_or(at), at);
  }
  return std::nullopt;
}

/// Time counts from the sample before the first that shows the step. In a gap between them it began later.
double origin_gap(const StepRun& run) {
  const auto t = run.t_ms();
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] > 0) return run.gap_before(i) ? static_cast<double>(t[i]) : 0.0;
  return 0;
}

void measure_rise(const StepRun& run, double target, StepMeasures& m) {
  const auto low = reaches(run, 0.1 * target), high = reaches(run, 0.9 * target);
  m.rose = low && high;
  if (m.rose) m.rise_ms = {std::max(0.0, high->low - low->high), high->high - low->low};
}

/// The encoder may have left the band again in any later gap of the step.
void measure_settling(const StepRun& run, double target, StepMeasures& m) {
  const auto t = run.t_ms(), y = run.encoder();
  std::size_t within = 0;  // the first of the final samples within the band
  for (std::size_t i = 0; i < y.size(); ++i)
    if (std::fabs(static_cast<double>(y[i]) - target) > m.band) within = i + 1;
  m.settled = !y.empty() && within < y.size();
  if (!m.settled) return;
  if (within > 0) {
    const double at = std::max(0.0f, t[within]);
    const double from = run.gap_before(within) ? std::max(0.0, static_cast<double>(t[within - 1])) : at;
    m.settling_ms = {std::max(0.0, from - origin_gap(run)), at};
  }
  if (run.cut_short()) m.settling_ms = Measure::at_least(m.settling_ms.low);
  for (std::size_t i = within + 1; i < y.size(); ++i)
    if (t[i] > 0 && run.gap_before(i) && !m.settling_ms.open()) m.settling_ms.high = t[i];
}

/// The mean of the last tenth, if it has no gap.
void measure_steady(const StepRun& run, StepMeasures& m) {
  const auto e = run.error();
  const std::size_t tail = std::max<std::size_t>(1, e.size() / 10);
  double sum = 0;
  m.steady_known = !run.cut_short();
  for (std::size_t i = e.size() - tail; i < e.size(); ++i) {
    sum += e[i];
    if (run.gap_before(i)) m.steady_known = false;
  }
  m.steady_error = sum / static_cast<double>(tail);
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
    // Time starts at the previous sample, the last one before anything happened.
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

void StepRun::end(double length_ms) {
  constexpr std::size_t enough = 8;
  constexpr float usual_jitter = 4;         // times the median spacing; of a few samples, times the least
  constexpr float share_joined = 1.0f / 3;  // of the step
  if (t_ms_.empty()) return;
  planned_end_ms_ = t_ms_.front() + static_cast<float>(length_ms);
  cut_short_ = length_ms > 0;
  if (t_ms_.size() < 2) return;
  std::vector<float> spacing;
  for (std::size_t i = 1; i < t_ms_.size(); ++i) spacing.push_back(t_ms_[i] - t_ms_[i - 1]);
  const std::size_t usual = t_ms_.size() < enough ? 0 : spacing.size() / 2;
  const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(usual);
  std::nth_element(spacing.begin(), middle, spacing.end());
  const float joined_ms = usual_jitter * *middle,
              joined = std::max(1.0f, share_joined * static_cast<float>(step()));
  cut_short_ = t_ms_.back() + joined_ms < planned_end_ms_;
  for (std::size_t i = 1; i < t_ms_.size(); ++i)
    if (t_ms_[i] - t_ms_[i - 1] > joined_ms || std::fabs(encoder_[i] - encoder_[i - 1]) > joined)
      gaps_.push_back(i);
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
  for (std::size_t i = 1; i < y.size(); ++i) m.gaps += run.gap_before(i) && run.t_ms()[i] > 0;
  m.gaps += run.cut_short();
  const auto as_seen = [&m](double value) { return m.gaps > 0 ? Measure::at_least(value) : Measure(value); };
  const auto highest = std::max_element(y.begin(), y.end());
  m.overshoot_percent = as_seen(std::max(0.0, (static_cast<double>(*highest) - target) / run.step() * 100));
  m.peak_ms = run.t_ms()[static_cast<std::size_t>(highest - y.begin())];
  measure_rise(run, target, m);
  measure_settling(run, target, m);
  m.crossings = as_seen(count_crossings(run, target));
  measure_steady(run, m);
  double largest = 0;
  for (const float v : e) largest = std::max(largest, std::fabs(static_cast<double>(v)));
  m.largest_error = as_seen(largest);
  return m;
}

void StepScatter::take(const StepMeasures& measures) {
  all_[static_cast<std::size_t>(taken_ % enough)] = measures;
  ++taken_;
}

std::optional<double> StepScatter::of(Of measure) const {
  if (!known()) return std::nullopt;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const StepMeasures& m : all_) {
    const auto value = measure(m);
    if (!value || !value->exact()) return std::nullopt;
    least = std::min(least, value->low), greatest = std::max(greatest, value->high);
  }
  return greatest - least;
}

}  // namespace hw::gui
