#include "panels/control/action_choice.h"

#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/widgets/text.h"
#include "panels/control/readouts.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float narrow_column = 280, choice_lamp_width = 72;
constexpr float choice_name_width = 128, choice_number_width = 104, choice_line_height = 32;

const ActionInfo& its_info(const Catalog& c, const ActionForm& action) {
  return c.actions[static_cast<std::size_t>(action.action())];
}

int its_readout(const Catalog& c, const ActionForm& action) {
  return c.find_readout(its_info(c, action).sets);
}

/// Draws the name of a readout at the cursor.
void draw_choice_name(Frame& f, const ReadoutInfo& readout, ImVec2 at, float width) {
  f.tab.watched.look_at_group(readout.group);
  draw_text_line(f.ui, at.x, at.x + f.ui.px(width), std::floor(at.y + f.ui.px(choice_line_height / 2)),
                 Face::body, f.ui[Tone::ink2], readout.label);
}

}  // namespace

bool is_of_choice(const Catalog& c, const ActionForm& action) {
  return action.only_a_button() && its_readout(c, action) >= 0;
}

std::size_t end_of_choice(const Catalog& c, const std::vector<ActionForm>& actions, std::size_t first) {
  std::size_t end = first + 1;
  while (end < actions.size() && is_of_choice(c, actions[end]) &&
         its_info(c, actions[end]).sets == its_info(c, actions[first]).sets)
    ++end;
  return end;
}

void draw_action_choice(Frame& f, std::vector<ActionForm>& actions, std::size_t first, float width) {
  Ui& ui = f.ui;
  const std::size_t end = end_of_choice(f.catalog, actions, first);
  const auto readout = static_cast<std::size_t>(its_readout(f.catalog, actions[first]));
  const ReadoutInfo& shown = f.catalog.readouts[readout];
  const ReadoutText now(f, readout);
  const bool lamp = !shown.words.empty() && shown.words.front().label == "off";
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_choice_name(f, shown, at, width);
  show(ui, {Path("readout/{}", shown.id), Kind::text, shown.label, now.view(), {}, false, shown.help},
       {at, ImVec2(at.x + ui.px(choice_name_width - between), at.y + ui.px(choice_line_height))});
  // In a narrow column the lamp is at the right edge, aligned with the lamps that fill the column.
  const bool at_the_right = lamp && width < narrow_column;
  float x = at.x + ui.px(at_the_right ? width - choice_lamp_width : choice_name_width);
  for (std::size_t i = first; i < end; ++i) {
    const ActionInfo& info = its_info(f.catalog, actions[i]);
    const bool is = now.known() && f.now.readouts[readout] == info.sets_to;
    if (lamp && is) continue;  // a press of the lamp sends the opposite action
    ImGui::SetCursorScreenPos(ImVec2(x, at.y));
    actions[i].draw_choice(f, lamp ? now.view() : std::string_view(info.label), lamp, is);
    x = ImGui::GetItemRectMax().x + ui.px(lamp ? between : 0);
    if (lamp && now.known()) break;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(choice_line_height + between)));
  for (std::size_t i = first; i < end; ++i) actions[i].draw_refusal(f, width);
}

bool is_setter(const Catalog& c, const ActionForm& action) {
  const ActionInfo& info = its_info(c, action);
  return info.fields.size() == 1 && info.fields.front().choices.empty() && its_readout(c, action) >= 0;
}

void draw_setter(Frame& f, ActionForm& action, float width) {
  Ui& ui = f.ui;
  const auto readout = static_cast<std::size_t>(its_readout(f.catalog, action));
  const ReadoutInfo& shown = f.catalog.readouts[readout];
  const ReadoutText now(f, readout);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_choice_name(f, shown, at, width);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(choice_name_width), at.y));
  action.draw_bare_field(f, 0, choice_number_width);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(choice_name_width + choice_number_width + between), at.y));
  action.draw_button(f, 0);
  const float x = ImGui::GetItemRectMax().x + ui.px(12);
  const Path words("stands at {}", now.view());
  draw_text_line(ui, x, at.x + ui.px(width), std::floor(at.y + ui.px(choice_line_height / 2)), Face::small,
                 ui[now.old() || !now.known() ? Tone::ink3 : Tone::ink2], words);
  show(ui, {Path("readout/{}", shown.id), Kind::text, shown.label, now.view(), {}, false, shown.help},
       {ImVec2(x, at.y), ImVec2(at.x + ui.px(width), at.y + ui.px(choice_line_height))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(choice_line_height + between)));
  action.draw_refusal(f, width);
}

}  // namespace hw::panels
