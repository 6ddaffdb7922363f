#include "core/devices/vxm/emulator.h"

#include <algorithm>
#include <optional>

#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {

std::size_t ix(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t pulses_kept = 100'000;

struct Options {
  int motors = 2;
  bool overrun = false, barred = false;
};

class VxmEmulator final : public Emulator {
 public:
  explicit VxmEmulator(const Options& options);

  void receive(std::string_view bytes) override;
  void take_output(std::string& sink) override;
  [[nodiscard]] std::optional<Instant> next_event() const override;
  void advance_to(Instant now) override;
  Result<> operate(const BenchCommand& command) override;
  void look(BenchView& view) const override;
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override;
  [[nodiscard]] int rate() const override { return box_.rate(); }
  [[nodiscard]] std::string save_memory() const override;
  Result<> load_memory(std::string_view text) override;
  [[nodiscard]] std::uint64_t memory_version() const override { return box_.stores + memory_loads_; }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override {
    return std::make_unique<VxmEmulator>(*this);
  }

 private:
  void after();
  void gather_pulses(Box& box, int first_axis, int first_output);
  void pace_replies();
  Box& box_of(int axis) { return axis < motors_per_controller ? box_ : *box_.slave(); }
  [[nodiscard]] const Box& box_of(int axis) const {
    return axis < motors_per_controller ? box_ : *box_.slave();
  }
  [[nodiscard]] int boxes() const { return options_.motors > motors_per_controller ? 2 : 1; }
  Result<> check_axis(AxisId axis) const;

  Result<> act(const bench::Input& c);
  Result<> act(const bench::Limit& c);
  Result<> act(const bench::HomeSwitch& c);
  Result<> act(const bench::Analog& c);
  Result<> act(const bench::Button& c);
  Result<> act(const bench::Jam& c);
  Result<> act(const bench::Slip& c);
  Result<> act(const bench::Place& c);
  Result<> act(const bench::Power& c);
  Result<> act(const bench::PowerCycle& c);
  Result<> act(const bench::Unplug&) { return wire_fault(); }
  Result<> act(const bench::Garble&) { return wire_fault(); }
  Result<> act(const bench::Drop&) { return wire_fault(); }
  static Result<> wire_fault() {
    return fail(FaultKind::refused, "Faults of the wire are made where the wire is, not in the controller.");
  }
  void press(int button, bool on);

  Options options_;
  Box box_;
  Instant now_{};
  std::uint32_t buttons_ = 0, inputs_ = 0;
  std::string held_back_;  ///< quirk overrun: the reply that is being sent
  Instant answering_until_{};
  std::uint64_t memory_loads_ = 0;
  mutable std::vector<TriggerPulse> pulses_;
};

VxmEmulator::VxmEmulator(const Options& options) : options_(options) {
  if (options.motors > motors_per_controller) box_.link(Box());
  if (options.barred) box_.error_first = error_mark_barred;
  AxisPlace slide;
  slide.minus = Steps(-default_travel), slide.plus = Steps(default_travel);
  for (int axis = 0; axis < boxes() * motors_per_controller; ++axis) {
    const bool fitted = axis < options.motors;
    const int local = axis % motors_per_controller;
    box_of(axis).set_fitted(local, fitted);
    if (fitted) box_of(axis).plant(local).set_place(slide);
    box_of(axis).plant_changed(local);
  }
}

void VxmEmulator::receive(std::string_view bytes) {
  for (const char c : bytes) {
    if (options_.overrun && now_ < answering_until_) box_.block();
    box_.receive(c);
    if (options_.overrun) pace_replies();
  }
  after();
}

/// With the quirk `overrun` a reply leaves when its last byte would have: a host that talks meanwhile blocks
/// it.
void VxmEmulator::pace_replies() {
  if (box_.replied > 0) {
    constexpr std::int64_t bits_per_byte = 10;
    const auto bits = static_cast<std::int64_t>(box_.out.size()) * bits_per_byte;
    answering_until_ = std::max(now_, answering_until_) + Duration(bits * 1'000'000'000 / box_.rate());
  }
  box_.replied = 0;
  if (now_ < answering_until_) {
    held_back_ += box_.out;
    box_.out.clear();
  }
}

void VxmEmulator::take_output(std::string& sink) {
  if (!held_back_.empty() && now_ >= answering_until_) sink += std::exchange(held_back_, {});
  if (!held_back_.empty()) {
    held_back_ += box_.out;
  } else {
    sink += box_.out;
  }
  box_.out.clear();
}

std::optional<Instant> VxmEmulator::next_event() const {
  auto next = box_.next_event();
  if (!held_back_.empty() && (!next || answering_until_ < *next)) next = answering_until_;
  return next;
}

void VxmEmulator::advance_to(Instant now) {
  for (;;) {
    const auto next = box_.next_event();
    if (!next || *next > now) break;
    const bool later = *next > now_;
    now_ = std::max(now_, *next);
    box_.set_time(now_);
    after();  // pulses of moves that end now
    if (!box_.settle() && !later) break;
    after();
  }
  now_ = std::max(now_, now);
  box_.set_time(now_);
  after();
}

void VxmEmulator::after() {
  gather_pulses(box_, 0, 0);
  if (Box* s = box_.slave()) gather_pulses(*s, motors_per_controller, outputs_per_controller);
}

void VxmEmulator::gather_pulses(Box& box, int first_axis, int first_output) {
  for (const Pulse& p : box.pulses) {
    TriggerPulse pulse;
    pulse.at = p.at, pulse.output = first_output + p.output, pulse.width = p.width;
    for (int axis = 0; axis < options_.motors; ++axis)
      pulse.position[ix(axis)] = Steps(box_of(axis).counter_at(axis % motors_per_controller, p.at));
    pulse.position[ix(first_axis + p.axis)] = Steps(p.position);
    pulses_.push_back(pulse);
  }
  box.pulses.clear();
  if (pulses_.size() > 2 * pulses_kept) pulses_.erase(pulses_.begin(), pulses_.end() - pulses_kept);
}

const std::vector<TriggerPulse>& VxmEmulator::pulses() const {
  if (pulses_.size() > pulses_kept) pulses_.erase(pulses_.begin(), pulses_.end() - pulses_kept);
  return pulses_;
}

// --- the bench
// ----------------------------------------------------------------------------------------------

Result<> VxmEmulator::operate(const BenchCommand& command) {
  auto result = std::visit([this](const auto& c) { return act(c); }, command);
  box_.settle();
  after();
  return result;
}

Result<> VxmEmulator::check_axis(AxisId axis) const {
  if (axis.index < options_.motors) return {};
  return fail(FaultKind::refused,
              "This bench has " + std::to_string(options_.motors) + " motors and no motor " +
                  std::to_string(axis.index + 1) + ".",
              "Nothing was changed.");
}

Result<> VxmEmulator::act(const bench::Input& c) {
  const int count = boxes() * inputs_per_controller;
  if (c.number < 1 || c.number > count)
    return fail(
        FaultKind::refused,
        "There is no input " + std::to_string(c.number) + ": inputs are 1 to " + std::to_string(count) + ".",
        "Nothing was changed.");
  const std::uint32_t bit = 1u << (c.number - 1);
  inputs_ = c.active ? inputs_ | bit : inputs_ & ~bit;
  const int box = (c.number - 1) / inputs_per_controller, input = (c.number - 1) % inputs_per_controller;
  const std::uint32_t stop = box == 0 ? 1u << 5 : 1u << 11;
  const bool low = c.active || (input == 3 && (buttons_ & stop) != 0);
  (box == 0 ? box_ : *box_.slave()).set_line(line_in_1 + input, low);
  return {};
}

Result<> VxmEmulator::act(const bench::Button& c) {
  const auto found = std::find(panel_buttons.begin(), panel_buttons.end(), c.name);
  const int button = static_cast<int>(found - panel_buttons.begin());
  if (found == panel_buttons.end() || (button >= buttons_per_controller && boxes() < 2)) {
    std::string all;
    for (int i = 0; i < boxes() * buttons_per_controller; ++i)
      all += (i ? ", " : "") + std::string(panel_buttons[ix(i)]);
    return fail(FaultKind::refused, "The front panel has no button \"" + c.name + "\".",
                "Nothing was changed.", "Its buttons are " + all + ".");
  }
  press(button, c.pressed);
  return {};
}

void VxmEmulator::press(int button, bool on) {
  const std::uint32_t bit = 1u << button;
  buttons_ = on ? buttons_ | bit : buttons_ & ~bit;
  const bool of_slave = button >= buttons_per_controller;
  Box& box = of_slave ? *box_.slave() : box_;
  // Master: 1- 1+ 2- 2+ Run Stop; Slave: 3- 3+ 4- 4+ Run Stop. Stop is wired to input 4.
  const int local = of_slave ? button - buttons_per_controller : button;
  if (local < 4) return box.set_line(line_jog + local, on);
  if (local == 4) return box.set_line(line_run, on);
  const std::uint32_t input_4 = of_slave ? 1u << 7 : 1u << 3;
  box.set_line(line_in_4, on || (inputs_ & input_4) != 0);
}

Result<> VxmEmulator::act(const bench::Limit& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  const int axis = c.axis.index, local = axis % motors_per_controller;
  box_of(axis).plant(local).operate_limit(c.sign, c.operated);
  box_of(axis).plant_changed(local);
  return {};
}

Result<> VxmEmulator::act(const bench::HomeSwitch& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  const int axis = c.axis.index, local = axis % motors_per_controller;
  box_of(axis).plant(local).operate_home(c.operated);
  box_of(axis).plant_changed(local);
  return {};
}

Result<> VxmEmulator::act(const bench::Analog& c) {
  if (c.number < 1 || c.number > boxes())
    return fail(FaultKind::refused, "There is no analog input " + std::to_string(c.number) + ".",
                "Nothing was changed.");
  if (c.value < analog_min || c.value > analog_max)
    return fail(FaultKind::refused, std::to_string(c.value) + " is no reading of the analog input.",
                "Nothing was changed.", "It gives 0 to 1024.");
  (c.number == 1 ? box_ : *box_.slave()).set_analog(c.value);
  return {};
}

Result<> VxmEmulator::act(const bench::Jam& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  const int axis = c.axis.index, local = axis % motors_per_controller;
  box_of(axis).plant(local).jam(c.on);
  box_of(axis).plant_changed(local);
  return {};
}

Result<> VxmEmulator::act(const bench::Slip& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  const int axis = c.axis.index, local = axis % motors_per_controller;
  box_of(axis).plant(local).slip(c.by);
  box_of(axis).plant_changed(local);
  return {};
}

Result<> VxmEmulator::act(const bench::Place& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  if (c.place.index_every || c.place.counts_per_step)
    return fail(FaultKind::refused,
                "A VXM has no encoder: index_every and counts_per_step mean nothing to it.",
                "The place of motor " + std::to_string(c.axis.index + 1) + " was not changed.");
  if (c.place.home_from.has_value() != c.place.home_to.has_value())
    return fail(FaultKind::refused, "A home zone needs both ends.",
                "The place of motor " + std::to_string(c.axis.index + 1) + " was not changed.");
  const int axis = c.axis.index, local = axis % motors_per_controller;
  box_of(axis).plant(local).set_place(c.place);
  box_of(axis).plant_changed(local);
  return {};
}

Result<> VxmEmulator::act(const bench::Power& c) {
  box_.power(c.on, now_);
  if (!c.on) held_back_.clear();
  answering_until_ = now_;
  return {};
}

Result<> VxmEmulator::act(const bench::PowerCycle&) {
  (void)act(bench::Power(false));
  return act(bench::Power(true));
}

void VxmEmulator::look(BenchView& view) const {
  view = BenchView();
  view.present = true;
  view.powered = box_.powered();
  view.buttons = buttons_;
  view.inputs_operated = inputs_;
  for (int i = 0; i < boxes(); ++i) {
    const Box& box = i == 0 ? box_ : *box_.slave();
    const Box::Lamps lamps = box.lamps();
    const std::uint32_t power = 1u << (i * lamps_per_controller), online = power << 1;
    view.lamps |= (lamps.power ? power : 0) | (lamps.online ? online : 0);
    view.lamps_blink |= (lamps.power_blinks ? power : 0) | (lamps.online_blinks ? online : 0);
    view.outputs |= static_cast<std::uint32_t>(box.outputs()) << (i * outputs_per_controller);
    view.analog[ix(i)] = box.analog();
  }
  for (int axis = 0; axis < options_.motors; ++axis) {
    const motion::Plant& plant = box_of(axis).axis(axis % motors_per_controller).plant;
    const std::uint32_t bit = 1u << axis;
    view.load_position[ix(axis)] = plant.load();
    const bool home = plant.home_operated();
    if (home || plant.limit_operated(Sign::minus)) view.limits_minus |= bit;
    if (home || plant.limit_operated(Sign::plus)) view.limits_plus |= bit;
    if (plant.limit_by_hand(Sign::minus)) view.limits_minus_by_hand |= bit;
    if (plant.limit_by_hand(Sign::plus)) view.limits_plus_by_hand |= bit;
    if (plant.jammed()) view.jammed |= bit;
  }
}

// --- non-volatile memory -----------------------------------------------------------------------------------

std::string VxmEmulator::save_memory() const {
  std::string text =
      "# Non-volatile memory of a VXM\nstores = " + std::to_string(box_.stores) + "\n[controller 1]\n";
  text += box_.saved_text();
  if (const Box* s = box_.slave()) text += "[controller 2]\n" + s->saved_text();
  return text;
}

Result<> VxmEmulator::load_memory(std::string_view text) {
  std::string problem;
  Box* box = &box_;
  int number = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    std::string why;
    if (line.empty() || line.front() == '#') continue;
    if (line == "[controller 1]") {
      box = &box_;
    } else if (line == "[controller 2]") {
      box = box_.slave();  // null: a memory of four motors, two are fitted
    } else if (line.substr(0, 9) == "stores = " && line.size() > 9 && line.size() < 20 &&
               line.find_first_not_of("0123456789", 9) == std::string_view::npos) {
      box_.stores = std::stoull(std::string(line.substr(9)));
    } else if (box != nullptr) {
      why = box->load_line(line);
    }
    if (problem.empty() && !why.empty()) problem = "Line " + std::to_string(number) + " " + why + ".";
  }
  if (Box* s = box_.slave()) s->take_saved();
  box_.take_saved();
  ++memory_loads_;
  after();
  if (problem.empty()) return {};
  return fail(FaultKind::text, "The memory of the VXM is damaged: " + problem,
              "What could be read was taken; the rest has its factory value.",
              "Check motor types and programs before you run a motor.");
}

Result<Options> read_options(const std::map<std::string, std::string>& given) {
  Options options;
  for (const auto& [key, value] : given) {
    if (key == "motors") {
      if (value.size() != 1 || value[0] < '1' || value[0] > '4')
        return fail(FaultKind::text, "motors=" + value + ": a VXM has 1 to 4 motors.");
      options.motors = value[0] - '0';
    } else if (key == "quirk") {
      for (std::string_view rest = value; !rest.empty();) {
        const auto end = std::min(rest.find('+'), rest.size());
        const std::string_view name = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (name == "overrun")
          options.overrun = true;
        else if (name == "e-bar")
          options.barred = true;
        else
          return fail(FaultKind::text, "A VXM has no quirk \"" + std::string(name) + "\".", "",
                      "Its quirks are overrun and e-bar.");
      }
    } else if (key == "baud") {
      const bool known = std::any_of(bauds.begin(), bauds.end(),
                                     [&](const Baud& b) { return std::to_string(b.rate) == value; });
      if (!known)
        return fail(FaultKind::text, "baud=" + value + ": a VXM works at 9600, 19200 or 38400 baud.");
    } else {
      return fail(FaultKind::text, "The VXM emulator has no option \"" + key + "\".", "",
                  "Its options are motors, quirk and baud.");
    }
  }
  return options;
}

}  // namespace

Result<std::unique_ptr<Emulator>> make_emulator(const std::map<std::string, std::string>& options) {
  auto read = read_options(options);
  if (!read) return fail(read.error());
  return std::make_unique<VxmEmulator>(*read);
}

}  // namespace hw::vxm
