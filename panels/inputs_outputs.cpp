#include "panels/inputs_outputs.h"

#include <algorithm>
#include <cmath>

#include "gui/surface/ui.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/cells.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float heading_height = 32, level_height = 26, output_pitch = 36;

bool bit_of(std::uint32_t bits, int number) { return (bits >> (number - 1)) & 1u; }
bool io_is_old(const Frame& f) {
  return !f.connected() || is_stale(f.now.io_seen_at, f.clock, f.now.poll_period);
}
/// `place` is an index into the catalog, from 0.
bool is_active(const Frame& f, std::size_t place) {
  const int n = static_cast<int>(place) + 1;
  return bit_of(f.now.inputs_known, n) && bit_of(f.now.inputs, n) != f.catalog.inputs[place].active_low;
}

/// The most columns, at least 2, that fit all of `names` with `around` logical pixels beside them.
template <class Named>
int columns_of(const Frame& f, std::span<const Named> names, int most, float around) {
  while (most > 2 && !fit_in_cells(f.ui, f.area.width, most, names, around)) --most;
  return most;
}

/// The number of columns of lamps without words, so that no row is half empty; 0: each lamp has its word.
template <class Named>
int lamp_columns(const Frame& f, std::span<const Named> names) {
  constexpr float lamp_width = 20;
  if (names.size() <= 4) return 0;
  for (const int columns : {4, 3})
    if (names.size() % static_cast<std::size_t>(columns) == 0 &&
        fit_in_cells(f.ui, f.area.width, columns, names, lamp_width))
      return columns;
  return 0;
}

/// The consecutive lines of one group, from `first` on.
template <class Line>
std::span<const Line> group_at(const std::vector<Line>& lines, std::size_t first) {
  std::size_t end = first;
  while (end < lines.size() && lines[end].group == lines[first].group) ++end;
  return std::span(lines).subspan(first, end - first);
}

/// Draws the heading of a direction, or of a named group: `io/group/Lines 0 to 7: inputs`.
void draw_heading(Frame& f, std::string_view direction, std::string_view group, std::string_view caption) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  section_title(ui, group.empty() ? direction : group, io_is_old(f) ? "not fresh" : caption, heading_height);
  if (group.empty()) return;
  const Rect r{at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(heading_height))};
  show(ui, {Path("io/group/{}", group), Kind::text, group, group, {}, false, {}}, r);
}

bool is_not_zero(const Frame& f, std::string_view id) {
  if (const int param = f.catalog.find_param(id); param >= 0) {
    const ParamState& state = f.now.params[static_cast<std::size_t>(param)];
    return state.known && state.value != 0;
  }
  const int readout = f.catalog.find_readout(id);
  const auto at = static_cast<std::size_t>(readout);
  return readout >= 0 && f.now.readouts_known[at] && f.now.readouts[at] != 0;
}

/// The name of the output, or of its present function in the controller.
std::string_view name_of(const Frame& f, const OutputInfo& info) {
  const OutputDuty& duty = info.duty;
  const bool on_duty =
      !duty.name.empty() && std::all_of(duty.while_not_zero.begin(), duty.while_not_zero.end(),
                                        [&](const std::string& id) { return is_not_zero(f, id); });
  return on_duty ? duty.name : info.name;
}

/// "Aux X" split into the part that it shares with other outputs and its own part.
struct RailName {
  std::string_view group, own;
};
RailName rail_name(std::string_view name) {
  const std::size_t space = name.rfind(' ');
  if (space != name.npos) return {name.substr(0, space), name.substr(space + 1)};
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;  // "DO12"
  return {"Out", digits > 0 && digits < name.size() ? name.substr(digits) : name};
}

/// Makes "on: 2, 5", for lamps without words.
class OnNames {
 public:
  void add(std::string_view name) {
    const auto end = fmt::format_to_n(shown_ + size_, sizeof shown_ - size_, "{}{}",
                                      size_ == 0 ? "on: " : ", ", rail_name(name).own);
    size_ = std::min(size_ + end.size, sizeof shown_);
  }
  [[nodiscard]] std::string_view view() const { return {shown_, size_}; }

 private:
  char shown_[96];
  std::size_t size_ = 0;
};

}  // namespace

void InputsOutputs::draw(Frame& f) {
  if (f.rail) return draw_rail(f);
  draw_inputs(f);
  draw_outputs(f);
  draw_all_analog(f);
  group_line(f.ui, 8);
}

void InputsOutputs::draw_inputs(Frame& f) {
  const auto& inputs = f.catalog.inputs;
  for (std::size_t i = 0; i < inputs.size();) {
    const auto group = group_at(inputs, i);
    if (!group.front().of_output) {
      OnNames on;
      if (lamp_columns(f, group) > 0)
        for (std::size_t n = i; n < i + group.size(); ++n)
          if (is_active(f, n)) on.add(inputs[n].name);
      draw_heading(f, "Inputs", group.front().group, on.view());
      draw_levels(f, group, i);
    }
    i += group.size();
  }
}

/// Each line has a word, except that many lines with short names get only lamps. `first`: index of the first
/// line, from 0.
void InputsOutputs::draw_levels(Frame& f, std::span<const InputInfo> lines, std::size_t first) {
  const int lamps = lamp_columns(f, lines);
  Cells cells(f.ui, f.area.width, lamps > 0 ? lamps : columns_of(f, lines, 3, 56), level_height);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const InputInfo& info = lines[i];
    const std::size_t place = first + i;
    const int n = static_cast<int>(place) + 1;
    const bool known = bit_of(f.now.inputs_known, n) && !io_is_old(f), high = bit_of(f.now.inputs, n);
    LampOptions o;
    o.state = !known ? LampState::unknown : is_active(f, place) ? LampState::on : LampState::off;
    o.word = !bit_of(f.now.inputs_known, n) ? "?"
             : known                        ? (high ? "high" : "low")
                                            : (high ? "high?" : "low?");
    o.word_shown = lamps == 0;
    o.tip = info.help;
    o.width = cells.cell();
    o.height = level_height;
    cells.stand(static_cast<int>(i));
    lamp(f.ui, Path("io/in/{}", f.catalog.input_number(place)), with_minus(info.name), o);
  }
  cells.end();
}

// A few outputs show the full name of their function. They keep their place when the function changes.
static int output_columns(const Frame& f, std::span<const OutputInfo> outputs, int most) {
  const int columns = columns_of(f, outputs, most, 20);
  if (columns != 2) return columns;
  constexpr float lamp_and_word = 66;
  const float half = f.ui.px(std::floor((f.area.width + between) / 2) - between - lamp_and_word);
  const bool fit = std::all_of(outputs.begin(), outputs.end(), [&](const OutputInfo& info) {
    return text_width(f.ui, Face::body, info.duty.name) <= half;
  });
  return fit ? 2 : 1;
}

/// The levels of the lines are below the switches, if the controller reports them.
void InputsOutputs::draw_outputs(Frame& f) {
  const auto& outputs = f.catalog.outputs;
  for (std::size_t i = 0; i < outputs.size();) {
    const auto group = group_at(outputs, i);
    const int columns = output_columns(f, group, outputs.size() > 6 ? 4 : 2);
    const bool narrow = columns > 2;
    OnNames on;
    for (std::size_t n = i; narrow && n < i + group.size(); ++n)
      if (bit_of(f.now.outputs & f.now.outputs_known, static_cast<int>(n) + 1)) on.add(outputs[n].name);
    draw_heading(f, "Outputs", group.front().group, on.view());
    Cells cells(f.ui, f.area.width, columns, output_pitch);
    for (std::size_t n = i; n < i + group.size(); ++n) {
      cells.stand_at_next();
      draw_output(f, static_cast<int>(n) + 1, cells.cell(), narrow);
    }
    cells.end();
    draw_levels_of_outputs(f, group.front().group);
    i += group.size();
  }
}

void InputsOutputs::draw_levels_of_outputs(Frame& f, std::string_view group) {
  const auto& inputs = f.catalog.inputs;
  for (std::size_t i = 0; i < inputs.size();) {
    const auto lines = group_at(inputs, i);
    if (lines.front().of_output && lines.front().group == group) draw_levels(f, lines, i);
    i += lines.size();
  }
}

void InputsOutputs::draw_output(Frame& f, int n, float width, bool narrow) {
  const OutputInfo& info = f.catalog.outputs[static_cast<std::size_t>(n - 1)];
  const bool on = bit_of(f.now.outputs, n), known = bit_of(f.now.outputs_known, n);
  const int number = f.catalog.output_number(static_cast<std::size_t>(n - 1));
  IntentId& asked = asked_[static_cast<std::size_t>(n)];
  const IntentOutcome* outcome = f.now.outcome_of(asked);
  if ((outcome && outcome->state == IntentState::done) || f.now.forgotten(asked)) asked = 0;
  ToggleOptions o;
  o.width = width;
  o.narrow = narrow;
  o.tip = info.help;
  o.state = on ? ToggleState::on : ToggleState::off;
  if (!known || io_is_old(f)) {
    o.state = ToggleState::stale;
    o.word = !known ? "?" : on ? "on?" : "off?";
  }
  if (asked != 0)
    o.state = outcome && outcome->state != IntentState::pending ? ToggleState::refused : ToggleState::sending;
  if (asked != 0 && outcome && outcome->state != IntentState::pending) o.tip = outcome->sentence;
  if (asked != 0) o.word = {};
  o.disabled = !f.connected()   ? "There is no link."
               : !info.settable ? "This output cannot be set by the console."
                                : "";
  if (toggle_lamp(f.ui, Path("io/out/{}", number), name_of(f, info), o).clicked)
    asked = f.send(intent::SetOutput(number, known ? !on : true));
}

/// A few inputs have a line each; many are in two columns, with their unit in the title.
void InputsOutputs::draw_all_analog(Frame& f) {
  const int count = static_cast<int>(f.catalog.analog.size());
  const bool many = count > 2;
  if (many) section_title(f.ui, "Analog", f.catalog.analog.front().unit, heading_height);
  Cells cells(f.ui, f.area.width, many ? 2 : 1, many ? 24 : 28);
  for (int n = 1; n <= count; ++n) {
    cells.stand(n - 1);
    draw_analog(f, n, cells.cell(), many);
  }
  cells.end();
}

void InputsOutputs::draw_analog(Frame& f, int n, float width, bool short_words) {
  Ui& ui = f.ui;
  const AnalogInfo& info = f.catalog.analog[static_cast<std::size_t>(n - 1)];
  const std::int32_t value = f.now.analog[static_cast<std::size_t>(n - 1)];
  const bool known = bit_of(f.now.analog_known, n);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + ui.px(short_words ? 12 : 14), right = at.x + ui.px(width);
  const Face name_face = short_words ? Face::small : Face::body;
  draw_text_line(ui, at.x, right, middle, name_face, ui[Tone::ink], info.name);
  const Path of("of {} {}", info.maximum, info.unit);
  const float of_width = short_words ? 0 : ui.px(6) + std::ceil(text_width(ui, Face::small, of));
  if (!short_words)
    draw_text_line(ui, right - of_width + ui.px(6), right + 1, middle, Face::small, ui[Tone::ink2], of);
  const Path number("{}", value);
  const std::string_view shown = known ? number.view() : std::string_view("?");
  const float x = right - of_width - std::ceil(text_width(ui, Face::body_bold, shown));
  draw_text_line(ui, x, right, middle, Face::body_bold, ui[known && !io_is_old(f) ? Tone::ink : Tone::ink3],
                 shown);
  const float left = at.x + std::ceil(text_width(ui, name_face, info.name)) + ui.px(short_words ? 8 : 12);
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.px(4))));
  MeterOptions o;
  o.old = !known || io_is_old(f);
  o.words = shown;
  // The bar ends before the widest possible number, so that its length does not change with the number.
  const Path largest("{}", info.maximum);
  const float number_left = right - of_width - std::ceil(text_width(ui, Face::body_bold, largest));
  o.width = std::max(24.0f, std::floor((number_left - ui.px(8) - left) / ui.scale));
  const float span = static_cast<float>(std::max(1, info.maximum - info.minimum));
  meter(ui, Path("io/analog/{}", n), info.name, known ? static_cast<float>(value - info.minimum) / span : 0,
        o);
}

/// Outputs are lamps above their own names, below their shared name. Many outputs are in two columns.
void InputsOutputs::draw_rail(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const int count = static_cast<int>(f.catalog.outputs.size()), columns = count > 4 ? 2 : 1;
  const float cell = f.area.width / static_cast<float>(columns), pitch = count > 8 ? 34 : 38;
  float y = 0;
  int column = 0;
  std::string_view group;
  for (int n = 1; n <= count; ++n) {
    const OutputInfo& info = f.catalog.outputs[static_cast<std::size_t>(n - 1)];
    const RailName name = rail_name(info.name);
    if (name.group != group) {
      y += n == 1 ? 0 : column > 0 ? pitch + 6 : 6;
      const float at = top.y + ui.px(y);
      draw_text_centred(ui, {ImVec2(top.x, at), ImVec2(top.x + ui.px(f.area.width), at + ui.px(16))},
                        Face::small_bold, ui[Tone::ink], name.group);
      group = name.group;
      y += 20, column = 0;
    }
    draw_rail_lamp(f, n, name.own, ImVec2(top.x + ui.px(cell * static_cast<float>(column)), top.y + ui.px(y)),
                   ui.px(cell));
    if (++column == columns) y += pitch, column = 0;
  }
  ImGui::SetCursorScreenPos(ImVec2(top.x, top.y + ui.px(y + (column > 0 ? pitch : 0))));
  group_line(ui, 8);
}

void InputsOutputs::draw_rail_lamp(Frame& f, int n, std::string_view own, ImVec2 at, float width) {
  Ui& ui = f.ui;
  const OutputInfo& info = f.catalog.outputs[static_cast<std::size_t>(n - 1)];
  const bool known = bit_of(f.now.outputs_known, n) && !io_is_old(f), on = bit_of(f.now.outputs, n);
  const Rect r{at, ImVec2(at.x + width, at.y + ui.px(36))};
  draw_lamp(ui, ImVec2(std::floor(r.centre().x), r.min.y + ui.px(8)), 12, LampShape::round,
            !known ? LampState::unknown
            : on   ? LampState::on
                   : LampState::off);
  draw_text_centred(ui, {ImVec2(r.min.x, r.min.y + ui.px(18)), ImVec2(r.max.x, r.min.y + ui.px(34))},
                    on ? Face::small_bold : Face::small, ui[on ? Tone::ink : Tone::ink2], own);
  const std::string_view value = !known ? "?" : on ? "on" : "off";
  show(ui,
       {Path("io/lamp/{}", f.catalog.output_number(static_cast<std::size_t>(n - 1))),
        Kind::lamp,
        info.name,
        value,
        {},
        false,
        name_of(f, info)},
       r);
}

}  // namespace hw::panels
