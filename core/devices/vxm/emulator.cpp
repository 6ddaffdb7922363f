#include "core/devices/vxm/emulator.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_vxm.h"

namespace hw::vxm {

VxmEmulator::VxmEmulator(const EmulatorOptions& options) : options_(options) {
  if (options.motors > motors_per_controller) box_.link(Box());
  if (options.barred) box_.quirks.error_first = error_mark_barred;
  box_.quirks.mode_while_running = options.mode_while_running;
  if (options.old_firmware) box_.quirks.firmware = old_firmware;
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

/// With the quirk `overrun` a reply is sent byte by byte: a host that sends meanwhile blocks it.
void VxmEmulator::pace_replies() {
  constexpr Duration::rep ns_of_a_byte = 10'000'000'000;  // at 1 baud
  const Duration byte_time(std::exchange(box_.replied, 0) > 0 ? ns_of_a_byte / box_.rate() : 0);
  answering_until_ = std::max(now_, answering_until_);
  for (const char c : std::exchange(box_.out, {})) held_back_.push_back({answering_until_ += byte_time, c});
}

void VxmEmulator::take_output(std::string& sink) {
  for (; !held_back_.empty() && held_back_.front().leaves <= now_; held_back_.pop_front())
    sink += held_back_.front().byte;
  if (held_back_.empty()) sink += std::exchange(box_.out, {});
  for (const char c : std::exchange(box_.out, {})) held_back_.push_back({answering_until_, c});
}

std::optional<Instant> VxmEmulator::next_event() const {
  auto next = box_.next_event();
  if (!held_back_.empty() && (!next || held_back_.front().leaves < *next)) next = held_back_.front().leaves;
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

// --- non-volatile memory -----------------------------------------------------------------------------------

std::string VxmEmulator::save_memory() const {
  std::string text =
      "# Non-volatile memory of a VXM\nstores = " + std::to_string(box_.stores) + "\n[controller 1]\n";
  text += box_.saved_text();
  if (const Box* s = box_.slave()) text += "[controller 2]\n" + s->saved_text();
  return text;
}

namespace {

struct LoadedMemory {
  int good_lines = 0;
  std::string problem;  ///< of the first bad line
};

/// Takes every valid line into the saved memories.
LoadedMemory load_lines(std::string_view text, Box& first) {
  LoadedMemory loaded;
  Box* box = &first;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    std::string why;
    if (line == "[controller 1]") {
      box = &first;
    } else if (line == "[controller 2]") {
      box = first.slave();  // null: a memory of four motors where two are fitted
    } else if (line.substr(0, 9) == "stores = " && line.size() > 9 && line.size() < 20 &&
               line.find_first_not_of("0123456789", 9) == std::string_view::npos) {
      first.stores = std::stoull(std::string(line.substr(9)));
    } else if (box != nullptr) {
      why = box->load_line(line);
    }
    loaded.good_lines += why.empty();
    if (loaded.problem.empty() && !why.empty())
      loaded.problem = "line " + std::to_string(number) + " " + why + ".";
  }
  return loaded;
}

}  // namespace

Result<> VxmEmulator::load_memory(std::string_view text) {
  Box loaded_box = box_;
  loaded_box.stores = 0;
  loaded_box.forget_saved();
  if (Box* s = loaded_box.slave()) s->forget_saved();
  const LoadedMemory loaded = load_lines(text, loaded_box);
  if (loaded.good_lines == 0)
    return fail(FaultKind::text,
                "This is not a memory of a VXM" + (loaded.problem.empty() ? "." : ": " + loaded.problem),
                "Nothing was changed.");
  box_ = std::move(loaded_box);
  if (Box* s = box_.slave()) s->take_saved();
  box_.take_saved();
  ++memory_loads_;
  after();
  if (loaded.problem.empty()) return {};
  return fail(FaultKind::text, "The memory of the VXM is damaged: " + loaded.problem,
              "The readable part was used; the rest has its factory values.",
              "Check motor types and programs before you run a motor.");
}

namespace {

Result<EmulatorOptions> read_options(const std::map<std::string, std::string>& given) {
  EmulatorOptions options;
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
        else if (name == "mode-while-running")
          options.mode_while_running = true;
        else if (name == "old-firmware")
          options.old_firmware = true;
        else
          return fail(FaultKind::text, "A VXM has no quirk \"" + std::string(name) + "\".", "",
                      "Its quirks are overrun, e-bar, mode-while-running and old-firmware.");
      }
    } else if (key == "baud") {
      const bool known = std::any_of(bauds.begin(), bauds.end(), [&rate = value](const Baud& b) {
        return std::to_string(b.rate) == rate;
      });
      if (!known)
        return fail(FaultKind::text, "baud=" + value + ": a VXM works at " + rates_in_words + " baud.");
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
