// A Twin in miniature.
#include "core/emulation/emulator.h"

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/base/split.h"
#include "core/emulation/plant_bench.h"
#include "core/motion/step_axis.h"
#include "tests/example/facts.h"
#include "tests/example/twin.h"

namespace hw::twin {
namespace {

using motion::Profile, motion::Ramp, motion::StepAxis;

class TwinEmulator final : public Emulator {
 public:
  TwinEmulator() { switch_power(true); }
  void receive(std::string_view bytes) override {
    if (!powered_) return;
    for (const char c : bytes) {
      if (c != '\n') {
        if (line_.size() < longest_line) line_ += c;
        continue;
      }
      const std::string line = std::exchange(line_, {});
      const auto end = line.find(' ') + 1;
      if (end == 0) continue;  // no number
      const std::string text = line.substr(0, end) + answer(std::string_view(line).substr(end));
      out_ += fmt::format("{}*{:04X}\n", text, check_sum(text));
    }
  }
  void take_output(std::string& sink) override { sink += std::exchange(out_, {}); }
  [[nodiscard]] std::optional<Instant> next_event() const override { return next_event_of(axes_); }
  void advance_to(Instant now) override {
    now_ = now;
    for (StepAxis& axis : axes_) axis.advance(now);
  }
  Result<> operate(const BenchCommand& command) override {
    const auto plant_of = [this](AxisId a) { return a.index < axes ? &axes_[a.index].plant : nullptr; };
    const auto changed = [this](AxisId a) { axes_[a.index].plant_changed(), advance_to(now_); };
    return act_on_plants(command, plant_of, changed, [this](bool on) { switch_power(on); });
  }
  void look(BenchView& view) const override {
    view = BenchView(), view.present = true, view.powered = powered_;
    int a = 0;
    for (const StepAxis& axis : axes_) show_plant(view, a++, SeenPlant(axis.plant));
  }
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  [[nodiscard]] int rate() const override { return baud; }
  [[nodiscard]] std::string save_memory() const override { return fmt::format("{}\n", starts_); }
  Result<> load_memory(std::string_view text) override {
    const auto starts = whole_number<std::int64_t>(split(text, '\n').front());
    if (!starts) return fail(FaultKind::text, "This is not the memory of a Twin.");
    return starts_ = *starts, Result<>();
  }
  [[nodiscard]] std::uint64_t memory_version() const override { return static_cast<std::uint64_t>(starts_); }
  std::unique_ptr<Emulator> clone() const override { return std::make_unique<TwinEmulator>(*this); }

 private:
  static constexpr std::size_t longest_line = 80;
  void switch_power(bool on) {
    if (std::exchange(powered_, on) == on) return;
    if (on) ++starts_;
    line_.clear(), out_.clear();
    for (StepAxis& axis : axes_) axis.kill(), axis.position = Steps(0);
    for (std::size_t i = 0; i < params.size(); ++i) values_[i] = params[i].factory;
  }
  std::string answer(std::string_view text) {
    const auto words = split(text, ' ');
    if (text == "ID") return std::string(name);
    if (words.size() == 1) return text == "?" ? status() : param(text);
    const bool both = words[1] == "*";
    const auto letter = words[1].size() == 1 ? axis_letters.find(words[1][0]) : axis_letters.npos;
    if (words[0] == "S" || words[0] == "K") {
      if (!both && letter == axis_letters.npos) return "no such axis";
      for (std::size_t a = 0; a < axes_.size(); ++a)
        if (both || a == letter) words[0] == "S" ? axes_[a].slow(now_, ramp(a)) : axes_[a].kill();
      return "ok";
    }
    if (letter == axis_letters.npos) return "no such axis";
    return words.size() < 3 ? "no such command" : of_axis(words, letter);
  }
  [[nodiscard]] double ramp(std::size_t a) const { return static_cast<double>(values_[ramp_param + a]); }
  std::string of_axis(const std::vector<std::string_view>& words, std::size_t a) {
    StepAxis& axis = axes_[a];
    if (axis.state() != StepAxis::State::rests) return "no, it moves";
    const auto value = whole_number<std::int64_t>(words[2]);
    const Sign sign = words[2] == "-" ? Sign::minus : Sign::plus;
    const auto speed = words.size() > 3 ? whole_number<std::int64_t>(words[3]) : values_[speed_param + a];
    if (words[0] == "H" && words.size() == 4) return home(axis, sign, words[3]);
    if (!speed || *speed < 1 || *speed > top_speed) return "no such speed";
    if (words[0] == "J") return go(a, sign, Profile::endless, *speed);
    if (!value || *value < -position_max || *value > position_max) return "no such number";
    if (words[0] == "P") return axis.position = Steps(*value), "ok";
    const std::int64_t way = words[0] == "D" ? *value : *value - axis.position.value;
    if (words[0] != "D" && words[0] != "G") return "no such command";
    return go(a, way < 0 ? Sign::minus : Sign::plus, std::abs(way), *speed);
  }
  std::string go(std::size_t a, Sign sign, std::int64_t way, std::int64_t speed) {
    const Pps pace(static_cast<double>(speed));
    axes_[a].begin(now_, sign, Profile::index(now_, way, pace, Ramp(ramp(a), ramp(a), Pps(start_speed))));
    return "ok";
  }
  std::string home(StepAxis& axis, Sign sign, std::string_view way) {
    if (way != "H" && (way != "L" || sign == Sign::plus)) return "no such homing";
    axis.begin(now_, sign, Profile::constant(now_, 0, Pps(start_speed), Profile::endless),  // stops at once
               way == "H" ? StepAxis::Seeks::home_switch : StepAxis::Seeks::limit_switch);
    return "ok";
  }
  std::string param(std::string_view text) {
    const auto equals = text.find('=');
    for (std::size_t i = 0; i < params.size(); ++i) {
      if (text.substr(0, equals) != params[i].mnemonic) continue;
      if (equals == text.npos) return std::to_string(values_[i]);
      const auto value = whole_number<std::int64_t>(text.substr(equals + 1));
      if (!value || *value < params[i].minimum || *value > params[i].maximum) return "no such value";
      return values_[i] = *value, "ok";
    }
    return "no such command";
  }
  std::string status() {
    std::string text = std::to_string(starts_);
    for (const StepAxis& axis : axes_) {
      const int limits = (axis.plant.limit_operated(Sign::minus) ? minus_bit : 0) |
                         (axis.plant.limit_operated(Sign::plus) ? plus_bit : 0);
      text += fmt::format(" {} {} {:.0f} {} {}", axis.position.value, static_cast<int>(axis.state()),
                          axis.speed(now_).value, limits, static_cast<int>(axis.ended()));
    }
    return text;
  }

  std::array<StepAxis, axes> axes_;
  std::array<std::int64_t, params.size()> values_{};
  std::int64_t starts_ = 0;
  bool powered_ = false;
  Instant now_{};
  std::string line_, out_;
  std::vector<TriggerPulse> pulses_;
};

}  // namespace

Result<std::unique_ptr<Emulator>> make_emulator(const DeviceOptions&) {
  return std::make_unique<TwinEmulator>();
}

}  // namespace hw::twin
