#include "panels/variables.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "core/base/number_text.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float name_width = 44, least_cell = 150, command_height = 56;

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

template <class T>
bool read_whole(std::string_view s, T& value) {
  const auto number = whole_number<T>(trimmed(s));
  value = number.value_or(value);
  return number.has_value();
}

}  // namespace

Result<std::pair<int, std::int64_t>> parse_assignment(std::string_view text, const VariableFacts& facts) {
  const auto wrong = [&](std::string why) {
    return fail(FaultKind::text, std::move(why), "Nothing was sent.",
                fmt::format("Write it like {0}{1}=25.", facts.prefix, facts.stored_from));
  };
  const std::size_t equals = text.find('=');
  if (equals == text.npos) return wrong("The = and the value are missing.");
  std::string_view name = trimmed(text.substr(0, equals));
  const bool has_prefix =
      name.size() >= facts.prefix.size() &&
      std::equal(facts.prefix.begin(), facts.prefix.end(), name.begin(),
                 [](unsigned char a, unsigned char b) { return std::toupper(a) == std::toupper(b); });
  if (has_prefix) name.remove_prefix(facts.prefix.size());
  if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
  int number = 0;
  if (!read_whole(name, number) || number < 0 || number >= facts.count)
    return wrong(fmt::format("The variables are {0}0 to {0}{1}.", facts.prefix, facts.count - 1));
  std::int64_t value = 0;
  if (!read_whole(text.substr(equals + 1), value))
    return wrong("The value after the = is not a whole number.");
  if (facts.minimum < facts.maximum && (value < facts.minimum || value > facts.maximum))
    return wrong(fmt::format("{} is out of range: {} to {}.", value, facts.minimum, facts.maximum));
  return std::pair(number, value);
}

void Variables::draw(Frame& f) {
  fields_.resize(static_cast<std::size_t>(f.catalog.variables.count));
  f.tab.watched.look_at_group(f.catalog.variables.readout_group);
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  begin_part(ui, "variables", 0, ui.px(f.area.height - command_height), Tone::panel, 16);
  draw_grid(f, ImGui::GetContentRegionAvail().x / ui.scale);
  end_part();
  ImGui::SetCursorScreenPos(ImVec2(at.x, ui.px(f.area.bottom() - command_height)));
  draw_command(f);
}

void Variables::draw_grid(Frame& f, float width) {
  const VariableFacts& facts = f.catalog.variables;
  const int columns = std::max(1, static_cast<int>((width + wide_between) / (least_cell + wide_between)));
  const int kept = std::clamp(facts.stored_from, 0, facts.count);
  if (kept > 0) {
    section_title(f.ui, fmt::format("{0}0 to {0}{1}", facts.prefix, kept - 1), "lost at power-off");
    draw_part(f, 0, kept, columns, width);
  }
  if (kept < facts.count) {
    section_title(f.ui, fmt::format("{0}{1} to {0}{2}", facts.prefix, kept, facts.count - 1),
                  "kept by Store");
    draw_part(f, kept, facts.count, columns, width);
  }
  gap(f.ui, 16);
}

// Numbers run down each column, as in the maker's lists.
void Variables::draw_part(Frame& f, int first, int end, int columns, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int rows = (end - first + columns - 1) / columns;
  const float cell =
      std::floor((width - wide_between * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  for (int n = first; n < end; ++n) {
    const auto column = static_cast<float>((n - first) / rows), row = static_cast<float>((n - first) % rows);
    ImGui::SetCursorScreenPos(
        ImVec2(at.x + ui.px(column * (cell + wide_between)), at.y + ui.px(row * list_row_height)));
    draw_cell(f, n, cell);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(static_cast<float>(rows) * list_row_height)));
}

void Variables::draw_cell(Frame& f, int n, float width) {
  Ui& ui = f.ui;
  const auto index = static_cast<std::size_t>(n);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool known = f.now.variables_known[index];
  const Path name("{}{}", f.catalog.variables.prefix, n);
  draw_text_line(ui, at.x, at.x + ui.px(name_width), at.y + ui.px(16), Face::code_field,
                 ui[known && f.now.variables[index] != 0 ? Tone::ink : Tone::ink2], name);
  NumberOptions o;
  if (f.catalog.variables.minimum < f.catalog.variables.maximum) {
    o.range.min = static_cast<double>(f.catalog.variables.minimum);
    o.range.max = static_cast<double>(f.catalog.variables.maximum);
  }
  o.width = width - name_width;
  o.disabled = f.no_link();
  o.sentence_below = false;
  o.stale = !f.connected();
  if (!fields_[index].sentence.empty()) o.tip = fields_[index].sentence;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width), at.y));
  const std::optional<double> shown = known ? std::optional<double>(f.now.variables[index]) : std::nullopt;
  const NumberEvent e = number_field(ui, Path("var/{}", n), name, shown, fields_[index], o);
  const std::string& sentence = fields_[index].sentence;
  const bool refused = e.field.left && !sentence.empty();
  if (refused || e.committed) f.withdraw(&fields_[index]);  // the message about the previous value
  if (e.committed) f.send(intent::SetVariable(n, std::llround(e.value)));
  if (refused)
    f.toast(
        Severity::fault,
        fmt::format("{}: {}{} Nothing was sent.", name.view(), sentence, sentence.ends_with('.') ? "" : "."),
        &fields_[index]);
}

void Variables::draw_command(Frame& f) {
  Ui& ui = f.ui;
  const float top = f.area.bottom() - command_height;
  ImGui::GetWindowDrawList()->AddRectFilled(
      ui.px(f.area.x, top), ImVec2(ui.px(f.area.right()), ui.px(top) + ui.hair()), ui[Tone::line]);
  ButtonOptions b;
  b.disabled = !f.connected() ? f.no_link() : command_.empty() ? "Type a variable and its value." : "";
  const float button_wide = button_width(ui, "Set", b);
  ImGui::SetCursorScreenPos(ui.px(f.area.x + 16, top + 12));
  const Path placeholder("{0}{1}=25", f.catalog.variables.prefix, f.catalog.variables.stored_from);
  FieldOptions o;
  o.placeholder = placeholder;
  o.prompt = Icon::prompt;
  o.face = Face::code_field;
  o.width = f.area.width - 40 - button_wide;
  o.keep_focus = true;
  const Field field = text_field(ui, "var/command", "Set a variable", command_, o);
  ImGui::SetCursorScreenPos(ui.px(f.area.right() - 16 - button_wide, top + 12));
  const bool clicked = button(ui, "var/set", "Set", b).clicked;
  if ((clicked || field.entered) && !command_.empty() && f.connected()) set(f);
}

void Variables::set(Frame& f) {
  const auto request = parse_assignment(command_, f.catalog.variables);
  if (!request) return f.toast(Severity::fault, request.error().sentence());
  f.send(intent::SetVariable(request->first, request->second));
  NumberField& field = fields_[static_cast<std::size_t>(request->first)];
  field.reset();
  f.withdraw(&field);
  command_.clear();
}

}  // namespace hw::panels
