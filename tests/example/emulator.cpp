// A Twin in miniature.
#include "core/device/emulator.h"

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/device/plant_bench.h"
#include "core/motion/step_axis.h"
#include "tests/example/facts.h"
#include "tests/example/twin.h"

namespace hw::twin {
namespace {

using motion::Profile;
using motion::Ramp;
using motion::StepAxis;

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

class TwinEmulator final : public Emulator {
 public:
  void receive(std::string_view bytes) override {
    if (!powered_) return;
    for (const char c : bytes) {
      if (c != '\n') {
        if (line_.size() < longest_line) line_ += c;
        continue;
      }
      const std::string line = std::exchange(line_, {});
      const auto end = line.find(' ');
      if (end == line.npos) continue;
      const std::string text = line.substr(0, end + 1) + answer(std::string_view(line).substr(end + 1));
      out_ += fmt::format("{}*{:04X}\n", text, check_sum(text));
    }
  }
  void take_output(std::string& sink) override { sink += std::exchange(out_, {}); }
  [[nodiscard]] std::optional<Instant> next_event() const override {
    std::optional<Instant> next;
    for (const StepAxis& axis : axes_)
      if (const auto due = axis.next_event(); due && (!next || *due < *next)) next = due;
    return next;
  }
  void advance_to(Instant now) override {
    now_ = now;
    for (StepAxis& axis : axes_) axis.advance(now);
  }
  Result<> operate(const BenchCommand& command) override {
    return act_on_plants(
        command, [this](AxisId a) { return a.index < axes ? &axes_[a.index].plant : nullptr; },
        [this](AxisId a) { axes_[a.index].plant_changed(), advance_to(now_); },
        [this](bool on) { switch_power(on); });
  }
  void look(BenchView& view) const override {
    view = BenchView();
    view.present = true;
    view.powered = powered_;
    for (int a = 0; a < axes; ++a) show_plant(view, a, axes_[ix(a)].plant);
  }
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  [[nodiscard]] int rate() const override { return baud; }
  [[nodiscard]] std::string save_memory() const override { return fmt::format("starts = {}\n", starts_); }
  Result<> load_memory(std::string_view text) override {
    const auto value = text.starts_with("starts = ")
                           ? whole_number<std::int64_t>(text.substr(9, text.find('\n') - 9))
                           : std::nullopt;
    if (!value) return fail(FaultKind::text, "This is not the memory of a Twin.");
    starts_ = *value;
    return {};
  }
  [[nodiscard]] std::uint64_t memory_version() const override { return static_cast<std::uint64_t>(starts_); }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override {
    return std::make_unique<TwinEmulator>(*this);
  }

 private:
  static constexpr std::size_t longest_line = 80;

  void switch_power(bool on) {
    if (std::exchange(powered_, on) == on) return;
    if (on) ++starts_;
    line_.clear(), out_.clear();
    for (std::size_t i = 0; i < params.size(); ++i) values_[i] = params[i].factory;
    for (StepAxis& axis : axes_) axis.kill(), axis.position = Steps(0);
  }

  std::string answer(std::string_view text) {
    const auto words = split(text);
    if (words.empty()) return "no command";
    if (words.size() == 1)
      return words[0] == "ID" ? std::string(name) : words[0] == "?" ? status() : param(words[0]);
    const bool both = words[1] == "*";
    const auto letter = words[1].size() == 1 ? axis_letters.find(words[1][0]) : axis_letters.npos;
    if (words[0] == "S" || words[0] == "K") {
      if (!both && letter == axis_letters.npos) return "no such axis";
      for (std::size_t a = 0; a < axes_.size(); ++a)
        if (both || a == letter) words[0] == "S" ? slow(a) : axes_[a].kill();
      return "ok";
    }
    if (letter == axis_letters.npos) return "no such axis";
    return words.size() < 3 ? "no such command" : of_axis(words, letter);
  }

  void slow(std::size_t a) { axes_[a].slow(now_, static_cast<double>(values_[ramp_param + a])); }

  std::string of_axis(const std::vector<std::string_view>& words, std::size_t a) {
    StepAxis& axis = axes_[a];
    if (axis.state() != StepAxis::State::rests) return "no, it moves";
    const auto value = whole_number<std::int64_t>(words[2]);
    const Sign sign = words[2] == "-" ? Sign::minus : Sign::plus;
    const auto speed = words.size() > 3 ? whole_number<std::int64_t>(words[3])
                                        : values_[(words[0] == "J" ? jog_param : speed_param) + a];
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
    const double ramp = static_cast<double>(values_[ramp_param + a]);
    axes_[a].begin(
        now_, sign,
        Profile::index(now_, way, Pps(static_cast<double>(speed)), Ramp(ramp, ramp, Pps(start_speed))));
    return "ok";
  }

  /// Slowly enough to stop at once.
  std::string home(StepAxis& axis, Sign sign, std::string_view way) {
    if (way != "H" && (way != "L" || sign == Sign::plus)) return "no such homing";
    axis.begin(now_, sign, Profile::constant(now_, 0, Pps(start_speed), Profile::endless),
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
    for (const StepAxis& axis : axes_)
      text += fmt::format(" {} {} {:.0f} {} {}", axis.position.value, static_cast<int>(axis.state()),
                          axis.speed(now_).value,
                          (axis.plant.limit_operated(Sign::minus) ? minus_bit : 0) |
                              (axis.plant.limit_operated(Sign::plus) ? plus_bit : 0),
                          static_cast<int>(axis.ended()));
    return text;
  }

  std::array<StepAxis, axes> axes_;
  std::array<std::int64_t, params.size()> values_{params[0].factory, params[1].factory, params[2].factory,
                                                  params[3].factory, params[4].factory, params[5].factory};
  std::int64_t starts_ = 1;
  bool powered_ = true;
  Instant now_{};
  std::string line_, out_;
  std::vector<TriggerPulse> pulses_;
};

}  // namespace

Result<std::unique_ptr<Emulator>> make_emulator(const DeviceOptions&) {
  return std::make_unique<TwinEmulator>();
}

}  // namespace hw::twin
