#include "panels/inputs_outputs.h"

#include <algorithm>

#include "gui/ui.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

namespace {

bool bit(std::uint32_t bits, int number) { return (bits >> (number - 1)) & 1u; }
bool io_is_old(const Frame& f) {
  return !f.connected() || is_stale(f.now.io_seen_at, f.clock, f.now.poll_period);
}

constexpr float between = 8;

bool is_not_zero(const Frame& f, std::string_view id) {
  if (const int param = f.catalog.find_param(id); param >= 0) {
    const ParamState& state = f.now.params[static_cast<std::size_t>(param)];
    return state.known && state.value != 0;
  }
  const int readout = f.catalog.find_readout(id);
  const auto at = static_cast<std::size_t>(readout);
  return readout >= 0 && f.now.readouts_known[at] && f.now.readouts[at] != 0;
}

/// Its own name, or that of what the controller uses it for at present.
std::string_view name_of(const Frame& f, const OutputInfo& info) {
  const OutputDuty& duty = info.duty;
  const bool on_duty =
      !duty.name.empty() && std::all_of(duty.while_not_zero.begin(), duty.while_not_zero.end(),
                                        [&](const std::string& id) { return is_not_zero(f, id); });
  return on_duty ? duty.name : info.name;
}

}  // namespace

void InputsOutputs::draw(Frame& f) {
  if (f.rail) return draw_rail(f);
  const char* title = f.catalog.outputs.empty()  ? "Inputs"
                      : f.catalog.inputs.empty() ? "Outputs"
                                                 : "Inputs and outputs";
  section_title(f.ui, title, io_is_old(f) ? "not fresh" : "", 40);
  draw_inputs(f);
  gap(f.ui, 4);
  draw_outputs(f);
  for (int n = 1; n <= static_cast<int>(f.catalog.analog.size()); ++n) draw_analog(f, n);
  group_line(f.ui, 10);
}

void InputsOutputs::draw_inputs(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float cell = (f.area.width + between) / 2;
  const int count = static_cast<int>(f.catalog.inputs.size());
  for (int n = 1; n <= count; ++n) {
    const InputInfo& info = f.catalog.inputs[static_cast<std::size_t>(n - 1)];
    const bool known = bit(f.now.inputs_known, n) && !io_is_old(f), high = bit(f.now.inputs, n);
    const bool active = high != info.active_low;
    LampOptions o;
    o.state = !known ? LampState::unknown : active ? LampState::on : LampState::off;
    o.word = !bit(f.now.inputs_known, n) ? "?" : known ? (high ? "high" : "low") : (high ? "high?" : "low?");
    o.tip = info.help;
    o.width = cell - between;
    o.height = 28;
    const int column = (n - 1) % 2, row = (n - 1) / 2;
    ImGui::SetCursorScreenPos(
        ImVec2(at.x + ui.px(static_cast<float>(column) * cell), at.y + ui.px(static_cast<float>(row) * 28)));
    lamp(ui, Path("io/in/{}", n), info.name, o);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(static_cast<float>((count + 1) / 2) * 28)));
}

void InputsOutputs::draw_outputs(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float cell = (f.area.width + between) / 2;
  const int count = static_cast<int>(f.catalog.outputs.size());
  for (int n = 1; n <= count; ++n) {
    const int column = (n - 1) % 2, row = (n - 1) / 2;
    ImGui::SetCursorScreenPos(
        ImVec2(at.x + ui.px(static_cast<float>(column) * cell), at.y + ui.px(static_cast<float>(row) * 40)));
    draw_output(f, n, cell - between);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(static_cast<float>((count + 1) / 2) * 40)));
}

void InputsOutputs::draw_output(Frame& f, int n, float width) {
  const OutputInfo& info = f.catalog.outputs[static_cast<std::size_t>(n - 1)];
  const bool on = bit(f.now.outputs, n), known = bit(f.now.outputs_known, n);
  IntentId& asked = asked_[static_cast<std::size_t>(n)];
  const IntentFate* fate = f.now.fate_of(asked);
  if (fate && fate->fate == Fate::done) asked = 0;
  ToggleOptions o;
  o.width = width;
  o.tip = info.help;
  o.state = on ? ToggleState::on : ToggleState::off;
  if (!known || io_is_old(f)) {
    o.state = ToggleState::stale;
    o.word = !known ? "?" : on ? "on?" : "off?";
  }
  if (asked != 0) o.state = fate && fate->fate != Fate::pending ? ToggleState::refused : ToggleState::sending;
  if (asked != 0 && fate && fate->fate != Fate::pending) o.tip = fate->sentence;
  if (asked != 0) o.word = {};
  o.disabled = !f.connected()   ? "There is no link."
               : !info.settable ? "This output cannot be set by the console."
                                : "";
  if (toggle_lamp(f.ui, Path("io/out/{}", n), name_of(f, info), o).clicked)
    asked = f.send(intent::SetOutput(n, known ? !on : true));
}

void InputsOutputs::draw_analog(Frame& f, int n) {
  Ui& ui = f.ui;
  const AnalogInfo& info = f.catalog.analog[static_cast<std::size_t>(n - 1)];
  const std::int32_t value = f.now.analog[static_cast<std::size_t>(n - 1)];
  const bool known = bit(f.now.analog_known, n);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(14), right = at.x + ui.px(f.area.width);
  draw_text_line(ui, at.x, right, middle, Face::body, ui[Tone::ink], info.name);
  const Path of("of {} {}", info.maximum, info.unit);
  const Path number("{}", value);
  const std::string_view shown = known ? number.view() : std::string_view("?");
  float x = right - std::ceil(text_width(ui, Face::small, of));
  draw_text_line(ui, x, right + 1, middle, Face::small, ui[Tone::ink2], of);
  x -= ui.px(6) + std::ceil(text_width(ui, Face::body_bold, shown));
  draw_text_line(ui, x, right, middle, Face::body_bold, ui[known && !io_is_old(f) ? Tone::ink : Tone::ink3],
                 shown);
  const float left = at.x + std::ceil(text_width(ui, Face::body, info.name)) + ui.px(12);
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.px(4))));
  MeterOptions o;
  o.old = !known || io_is_old(f);
  o.words = shown;
  // The number is up to as wide as the largest; the bar ends before it and does not move with it.
  const Path largest("{}", info.maximum);
  const float number_left = right - std::ceil(text_width(ui, Face::small, of)) - ui.px(6) -
                            std::ceil(text_width(ui, Face::body_bold, largest));
  o.width = std::max(24.0f, std::floor((number_left - ui.px(8) - left) / ui.scale));
  const float span = static_cast<float>(std::max(1, info.maximum - info.minimum));
  meter(ui, Path("io/analog/{}", n), info.name, known ? static_cast<float>(value - info.minimum) / span : 0,
        o);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(28)));
}

void InputsOutputs::draw_rail(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float width = ui.px(f.area.width);
  float y = top.y;
  const auto words = [&](Face face, Tone tone, std::string_view s) {
    draw_text_centred(ui, {ImVec2(top.x, y), ImVec2(top.x + width, y + ui.px(16))}, face, ui[tone], s);
    y += ui.px(20);
  };
  words(Face::small_bold, Tone::ink, "Out");
  for (int n = 1; n <= static_cast<int>(f.catalog.outputs.size()); ++n) {
    const bool known = bit(f.now.outputs_known, n) && !io_is_old(f), on = bit(f.now.outputs, n);
    const LampState state = !known ? LampState::unknown : on ? LampState::on : LampState::off;
    const Rect r{ImVec2(top.x, y), ImVec2(top.x + width, y + ui.px(36))};
    draw_lamp(ui, ImVec2(std::floor(r.centre().x), y + ui.px(8)), 12, LampShape::round, state);
    show(ui,
         {Path("io/lamp/{}", n),
          Kind::lamp,
          f.catalog.outputs[static_cast<std::size_t>(n - 1)].name,
          !known ? "?"
          : on   ? "on"
                 : "off",
          {},
          false,
          f.catalog.outputs[static_cast<std::size_t>(n - 1)].name},
         r);
    y += ui.px(18);
    words(on ? Face::small_bold : Face::small, on ? Tone::ink : Tone::ink2, Path("{}", n));
  }
  ImGui::SetCursorScreenPos(ImVec2(top.x, y));
  group_line(ui, 8);
}

}  // namespace hw::panels
