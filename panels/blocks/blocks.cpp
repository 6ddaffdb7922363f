#include "panels/blocks/blocks.h"

#include <string_view>
#include <utility>

#include <imgui_internal.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "core/base/index.h"
#include "gui/input/keyboard.h"
#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_measures.h"
#include "panels/blocks/block_text.h"
#include "panels/lines.h"
#include "panels/program/overwrite_question.h"

namespace hw::panels {

using namespace gui;

void Blocks::draw(Frame& f) {
  follow(f);
  draw_toolbar(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float asked = overwrite_question_height(f), bottom = f.ui.px(f.area.bottom());
  const float height = (bottom - asked - at.y) / f.ui.scale;
  const BlockSides::Columns columns = sides_.columns(f);
  if (columns.palette > 0) draw_palette(f, columns.palette, height);
  ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + columns.palette), at.y));
  if (columns.list > 0) draw_list(f, columns, height);
  if (columns.side > 0) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.right() - columns.side), at.y));
    draw_sides(f, columns.side, height);
  }
  if (asked > 0) draw_overwrite_question(f, bottom - asked, asked);
  run_.draw_dialog(f, work_.written()->text);
  files_.draw_dialogs(f);
  from_text_.draw_dialog(f);
}

/// Applies changes since the last frame.
void Blocks::follow(Frame& f) {
  BlockList& blocks = f.tab.desk().blocks;
  blocks.begin_in(f.catalog, look_.units(f));
  editor_ = &blocks.editor;
  chosen_.follow(*editor_, rows_);
  if (look_.follow(f, *editor_)) {
    // The user typed the present text in the previous unit.
    rows_.forget_words(), form_.forget(), drafts_.forget();
    if (std::string_view(f.ui.focus.id()).starts_with("blocks/")) ImGui::ClearActiveID();
  }
  files_.follow(f);
  tool_.follow(*editor_, f.catalog, look_.look());
  use_keys(f);
  chosen_.follow(*editor_, rows_);
  drafts_.follow(*editor_, rows_);
  if (const int step = std::exchange(blocks.wanted_step, -1); step >= 0 && ix(step) < rows_.size())
    bring_up(f, rows_.path(ix(step)));
  blocks.chosen_step = chosen_.row();
  work_.follow(f, *editor_);
  if (f.ui.keyboard.pressed(Command::simulate)) {
    if (const std::string_view why_not = why_not_rehearse_now(f.now, f.catalog); why_not.empty())
      trial_.again();
    else
      f.toast(Severity::warn, std::string(why_not), &f.tab.desk().programs.texts);
  }
  trial_.follow(f, work_.written());
}

void Blocks::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  const Rehearsed rehearsed = work_.up_to_date() ? trial_.rehearsed(f) : Rehearsed();
  run_.draw(f, work_.written()->text, why_none(), rehearsed);
  const bool close = f.area.width < closer_below, brief = f.area.width < brief_below;
  const ButtonOptions from_text{.disabled = TextToBlocks::why_not(f),
                                .tip = "Turns the text in the program editor into blocks.",
                                .height = 40};
  const char* from = brief ? "From text" : "From the text";
  next_in_toolbar(f, close ? 4 : 8, button_width(ui, from, from_text));
  if (button(ui, "blocks/from_text", from, from_text).clicked) from_text_.start(f);
  ButtonOptions look{.style = ButtonStyle::quiet, .height = 40};
  const float words = button_width(ui, "Undo", look) + button_width(ui, "Redo", look) +
                      sides_.switch_width(f) + BlockFiles::width(ui, false);
  look.wordless = ui.px(words + 16) > ui.px(f.area.right() - 8) - ImGui::GetItemRectMax().x;
  const auto step_back = [&](float gap, const char* id, const char* label, Icon icon,
                             std::string_view why_not) {
    look.disabled = why_not;
    if (look.wordless) look.icon = icon, look.tip = label;
    next_in_toolbar(f, gap, button_width(ui, label, look));
    return button(ui, id, label, look).clicked;
  };
  if (step_back(close ? 0 : 16, "blocks/undo", "Undo", Icon::undo,
                editor_->can_undo() ? "" : "Nothing to undo."))
    take_back();
  if (step_back(0, "blocks/redo", "Redo", Icon::redo, editor_->can_redo() ? "" : "Nothing was undone."))
    make_again();
  sides_.draw_switch(f);
  files_.draw(f, look.wordless);
  end_toolbar(f, at);
  const Rect bar{at, ImVec2(ui.px(f.area.right()), ImGui::GetCursorScreenPos().y)};
  if (const int row = run_.draw_refusals(f, work_.written()->text, rows_, bar); row >= 0)
    bring_up(f, rows_.path(ix(row)));
}

std::string_view Blocks::why_none() const {
  std::string_view why = form_.problem();
  if (why.empty()) why = tool_.problem();
  if (why.empty()) why = drafts_.problem();
  return why.empty() ? work_.why_none(*editor_) : why;
}

void Blocks::draw_sides(Frame& f, float width, float height) {
  const auto text = [&](float, float high) {
    if (draw_block_text(f, *work_.written(), BlockTextMarks{chosen_, run_.live_step()}, high))
      choose_first_refused(f);
  };
  const auto path = [&](float wide, float high) {
    trial_.draw_path(f, chosen_.row(), wide, high);
    if (const int step = trial_.clicked_step(); step >= 0 && ix(step) < rows_.size())
      choose(rows_.path(ix(step)));
  };
  sides_.draw(f, width, height, text, path);
}

/// Keys for the buttons. Arrow keys alone jog, so Alt with an arrow moves a block.
void Blocks::use_keys(Frame& f) {
  if (f.ui.keyboard.typing() || f.ui.registry.top_layer() > 0) return;
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, true); };
  if (io.KeyCtrl && pressed('Z')) io.KeyShift ? make_again() : take_back();
  if (io.KeyCtrl && pressed('Y')) make_again();
  if (!chosen_.any() || sides_.columns(f).list == 0) return;  // a hidden block must not change
  const int arrow = (pressed(GLFW_KEY_DOWN) ? 1 : 0) - (pressed(GLFW_KEY_UP) ? 1 : 0);
  if (arrow != 0 && io.KeyAlt) move(arrow);
  if (arrow != 0 && io.KeyShift && !io.KeyAlt) {
    put_form_away();
    chosen_.extend(*editor_, arrow);
    open_form();
  }
  if (io.KeyCtrl && pressed('D')) duplicate();
  if (io.KeyCtrl && pressed('G')) put_into_loop();
  const bool presses_something = f.ui.focus.ring_on(f.ui.focus.id());
  if (const sequence::Step* step = chosen_.any() ? editor_->at(*chosen_.head()) : nullptr;
      step && pressed(GLFW_KEY_SPACE) && !presses_something)
    return skip(!step->skipped);
  if (pressed(GLFW_KEY_DELETE)) remove();
}

}  // namespace hw::panels
