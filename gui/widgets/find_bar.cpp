#include "gui/widgets/find_bar.h"

#include <cstdio>

#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"

namespace hw::gui {
namespace {

struct FindIds {
  char field[96], next[96], previous[96], close[96];
  explicit FindIds(std::string_view id) {
    const auto make = [&](char(&out)[96], const char* tail) {
      std::snprintf(out, sizeof out, "%.*s/find%s", static_cast<int>(id.size()), id.data(), tail);
    };
    make(field, "");
    make(next, "/next");
    make(previous, "/previous");
    make(close, "/close");
  }
};

}  // namespace

void FindBar::open(Ui& ui, std::string_view id, const TextModel& model) {
  open_ = true;
  failed_ = false;
  const TextRange chosen = model.selection();
  if (model.has_selection() && chosen.begin.line == chosen.end.line) needle_ = model.selected();
  ui.focus.move_to(FindIds(id).field);
}

bool FindBar::next(TextModel& model, bool forward) {
  const TextRange chosen = model.selection();
  const auto hit = model.find(needle_, forward ? chosen.end : chosen.begin, forward);
  failed_ = !hit && !needle_.empty();
  if (!hit) return false;
  model.move_to(hit->begin, false);
  model.move_to(hit->end, true);
  return true;
}

void FindBar::count(const TextModel& model) {
  if (counted_version_ == model.version() && counted_needle_ == needle_) return;
  counted_version_ = model.version();
  counted_needle_ = needle_;
  count_ = 0;
  TextPlace at{0, 0};
  for (auto hit = model.find(needle_, at, true); hit && hit->begin >= at && count_ < 10000;
       hit = model.find(needle_, at, true)) {
    ++count_;
    at = hit->end;
  }
}

bool FindBar::draw(Ui& ui, std::string_view id, TextModel& model) {
  if (!open_) return false;
  count(model);
  const FindIds ids(id);
  bool moved = false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(16), at.y + ui.px(4)));
  FieldOptions options;
  options.width = 240;
  options.face = Face::code_field;
  options.placeholder = "Find";
  options.error = failed_;
  options.keep_focus = true;
  const Field field = text_field(ui, ids.field, "find", needle_, options);
  if (field.edited) {
    failed_ = false;
    model.move_to(model.selection().begin, false);
    moved = next(model, true);
  } else if (field.entered) {
    moved = next(model, !ImGui::GetIO().KeyShift);
  }
  ImGui::SameLine();
  if (button(ui, ids.previous, "",
             {.style = ButtonStyle::quiet, .icon = Icon::chevron_up, .tip = "Previous (Shift Enter)"})
          .clicked)
    moved = next(model, false);
  ImGui::SameLine(0, 0);
  if (button(ui, ids.next, "",
             {.style = ButtonStyle::quiet, .icon = Icon::chevron_down, .tip = "Next (Enter, F3)"})
          .clicked)
    moved = next(model, true);
  ImGui::SameLine();
  char words[48];
  std::snprintf(words, sizeof words, needle_.empty() ? " " : count_ == 1 ? "1 place" : "%d places", count_);
  const ImVec2 words_at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, words_at.x, words_at.x + ui.px(120), words_at.y + ui.px(16), Face::small,
                 ui[failed_ ? Tone::fault : Tone::ink2], words);
  ImGui::SetCursorScreenPos(ImVec2(words_at.x + ui.px(80), at.y + ui.px(4)));
  if (button(ui, ids.close, "", {.style = ButtonStyle::quiet, .icon = Icon::cross, .tip = "Close (Esc)"})
          .clicked ||
      ui.cancelled()) {
    open_ = false;
    ui.focus.move_to(id);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
  return moved;
}

}  // namespace hw::gui
