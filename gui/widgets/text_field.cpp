#include "gui/widgets/text_field.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

struct Call {  // data for ImGui's callback
  std::string* text;
  const LineHelp* help;
  bool tab;
};

int on_input(ImGuiInputTextCallbackData* data) {
  Call& call = *static_cast<Call*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
    call.text->resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = call.text->data();
    return 0;
  }
  std::string line(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  std::size_t cursor = static_cast<std::size_t>(data->CursorPos);
  bool changed = false;
  if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
    changed = call.help->history(line, data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    cursor = line.size();
  } else if (call.tab && call.help->complete) {
    changed = call.help->complete(line, cursor);
  }
  if (!changed) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, line.data(), line.data() + line.size());
  data->CursorPos = static_cast<int>(std::min(cursor, line.size()));
  data->SelectionStart = data->SelectionEnd = data->CursorPos;
  return 0;
}

ImGuiInputTextFlags flags_of(const FieldOptions& o, bool tab) {
  ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_AutoSelectAll;
  if (o.help && o.help->history) flags |= ImGuiInputTextFlags_CallbackHistory;
  if (o.help && o.help->complete && tab) flags |= ImGuiInputTextFlags_CallbackAlways;
  if (o.help) flags &= ~ImGuiInputTextFlags_AutoSelectAll;
  if (o.password) flags |= ImGuiInputTextFlags_Password;
  return flags;
}

void draw_frame(Ui& ui, const Rect& r, const FieldOptions& o, bool typing) {
  const bool enabled = o.disabled.empty();
  if (enabled) draw_fill(ui, r, ui[Tone::well]);
  if (o.error)
    draw_outline(ui, r, ui[Tone::fault], 3, ui.hair() * 2);
  else if (o.stale && enabled && !typing)
    draw_dashed_outline(ui, r, ui[Tone::edge]);
  else
    draw_outline(ui, r, ui[!enabled ? Tone::line : typing || o.changed ? Tone::ink : Tone::edge]);
}

Face value_face(const FieldOptions& o) {
  return o.changed && o.face == Face::body ? Face::body_bold : o.face;
}

struct Insets {
  float left, right;
};

/// The unit is left out when the number would be cut.
bool unit_fits(const Ui& ui, float width, const std::string& text, const FieldOptions& o) {
  const float unit = std::ceil(text_width(ui, Face::small, o.unit)) + ui.px(6);
  return std::ceil(text_width(ui, value_face(o), text)) + unit + ui.px(20) <= width;
}

/// The insets of the text within the frame. ImGui has no right alignment, so the left padding provides it.
Insets insets_of(const Ui& ui, float width, const std::string& text, const FieldOptions& o) {
  Insets in{ui.px(10), ui.px(10)};
  if (o.prompt != Icon::none) in.left += ui.px(14);
  if (!o.unit.empty()) in.right += std::ceil(text_width(ui, Face::small, o.unit)) + ui.px(6);
  if (o.right)
    in.left = std::max(in.left, width - in.right - std::ceil(text_width(ui, value_face(o), text)) - 1);
  return in;
}

/// ImGui edits a copy of its own and would overwrite a text that the panel has set meanwhile, such as a
/// number in another unit or a new value of the controller. A text selected whole stays selected.
void follow_text(const std::string& text) {
  const ImGuiID item = ImGui::GetID("");
  auto* const state = ImGui::GetInputTextState(item);
  if (!state || GImGui->ActiveId != item || !state->TextAIsValid || text == state->TextA.Data) return;
  const bool all = std::abs(state->Stb.select_end - state->Stb.select_start) == state->CurLenW;
  state->TextW.resize(std::max(state->TextW.Size, static_cast<int>(text.size()) + 1));
  state->CurLenA = static_cast<int>(text.size());
  state->CurLenW =
      ImTextStrFromUtf8(state->TextW.Data, state->TextW.Size, text.data(), text.data() + text.size());
  state->SelectAll();
  if (!all) state->ClearSelection();
  auto& undo = state->Stb.undostate;  // its steps apply to the former text
  undo.undo_point = undo.undo_char_point = 0;
  undo.redo_point = STB_TEXTEDIT_UNDOSTATECOUNT;
  undo.redo_char_point = STB_TEXTEDIT_UNDOCHARCOUNT;
}

/// ImGui's InputText without its own frame, placed so that the text starts after the left inset.
bool edit(Ui& ui, const Rect& r, std::string& text, const FieldOptions& o, const Insets& in) {
  Call call{&text, o.help, ImGui::IsKeyPressed(GLFW_KEY_TAB, true) && !ImGui::GetIO().KeyShift};
  ImFont* font = ui.font(value_face(o));
  const float pad_y = std::max(0.0f, std::floor((r.height() - font->FontSize) * 0.5f));
  ImGui::PushFont(font);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(in.left, pad_y));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0f);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0u);
  ImGui::PushStyleColor(ImGuiCol_Text, ui[!o.disabled.empty() || o.stale ? Tone::ink3 : Tone::ink]);
  ImGui::SetNextItemWidth(r.width() - in.right);
  ImGui::PushClipRect(r.min, ImVec2(r.max.x - in.right + ui.px(2), r.max.y), true);
  const bool edited =
      ImGui::InputText("", text.data(), text.capacity() + 1, flags_of(o, call.tab), on_input, &call);
  auto* const state = ImGui::GetInputTextState(ImGui::GetItemID());
  if (state && o.whole && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    state->SelectAll();
    state->SelectedAllMouseLock = true;  // a small movement of the mouse must not change the selection
  }
  // A text that fits must not scroll: the left padding follows a right-aligned text one frame late.
  if (state && o.right &&
      std::ceil(text_width(ui, value_face(o), text)) + ui.px(20) <= r.width() - in.right + ui.px(10))
    state->ScrollX = 0;
  ImGui::PopClipRect();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
  return edited;
}

void draw_extras(Ui& ui, const Rect& r, const std::string& text, const FieldOptions& o, const Insets& in,
                 bool typing) {
  const float middle = std::floor(r.centre().y);
  if (o.prompt != Icon::none)
    draw_icon(ImGui::GetWindowDrawList(), o.prompt, ImVec2(r.min.x + ui.px(13), middle), ui.px(12),
              ui[Tone::ink2]);
  if (!o.unit.empty())
    draw_text_line(ui, r.max.x - in.right + ui.px(6), r.max.x, middle, Face::small, ui[Tone::ink3], o.unit);
  const float after = r.min.x + in.left + std::ceil(text_width(ui, value_face(o), text));
  if (text.empty() && !o.placeholder.empty() && (!typing || o.hint.empty()))
    draw_text_line(ui, r.min.x + in.left + ui.px(2), r.max.x - in.right, middle, Face::body, ui[Tone::ink3],
                   o.placeholder);
  else if (typing && !o.hint.empty())
    draw_text_line(ui, after + ui.px(14), r.max.x - in.right, middle, Face::body, ui[Tone::ink3], o.hint);
}

}  // namespace

Field text_field(Ui& ui, std::string_view id, std::string_view label, std::string& text,
                 const FieldOptions& wanted) {
  Field f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect r{at, ImVec2(at.x + width_px(ui, wanted.width), at.y + ui.px(wanted.height))};
  FieldOptions o = wanted;
  if (!unit_fits(ui, r.width(), text, o)) o.unit = {};
  const bool enabled = o.disabled.empty();
  ImGui::PushID(id.data(), id.data() + id.size());
  const ImGuiID item = ImGui::GetID("");
  const bool was_typing = GImGui->ActiveId == item;
  draw_frame(ui, r, o, was_typing || ui.pretend == Ui::Pretend::held);
  const Insets in = insets_of(ui, r.width(), text, o);
  if (enabled) {
    follow_text(text);
    if (ui.focus.take_entry(id)) ImGui::SetKeyboardFocusHere();
    f.edited = edit(ui, r, text, o, in);
    f.typing = GImGui->ActiveId == item;
    f.left = ImGui::IsItemDeactivated();
    f.entered =
        (was_typing || f.typing) &&
        (ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) || ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false)) &&
        !ImGui::GetIO().KeyCtrl;
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0)) ui.focus.set(id);
    if (f.entered && o.keep_focus) ui.focus.move_to(id);
    if (f.typing && o.help && o.help->complete) ui.take_tab();
  } else {
    draw_text_line(ui, r.min.x + in.left, r.max.x, std::floor(r.centre().y), o.face, ui[Tone::ink3], text);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(r.width(), r.height()));
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (over && enabled) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  // A press on the unit or the insets counts too, although they are outside of ImGui's item.
  if (over && enabled && !f.typing && ImGui::IsMouseClicked(0)) ui.focus.move_to(id);
  ImGui::PopID();
  draw_extras(ui, r, text, o, in, f.typing);
  f.touch.rect = r;
  f.touch.enabled = enabled;
  f.touch.hovered = over;
  f.touch.ring = ui.focus.ring_on(id) || ui.pretend == Ui::Pretend::ring;
  const std::string_view shown = enabled ? o.tip : o.disabled;
  show(ui, {id, Kind::field, label, text, o.disabled, false, f.typing ? std::string_view() : shown}, r);
  draw_ring(ui, f.touch);
  return f;
}

}  // namespace hw::gui
