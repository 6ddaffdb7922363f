#include "gui/widgets/code_editor.h"

#define GLFW_INCLUDE_NONE
#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

namespace hw::gui {
namespace {

constexpr float text_left = 64, problem_height = 40, top_gap = 4;  // logical
constexpr int tab_key = GLFW_KEY_TAB, f3_key = GLFW_KEY_F3;

}  // namespace

void CodeEditor::load(std::string_view text) {
  if (text == text_) return;
  model_.set_text(text);
  remember();
}

void CodeEditor::remember() {
  text_ = model_.text();
  text_version_ = model_.version();
  int columns = 0;
  for (int i = 0; i < model_.line_count(); ++i)
    columns = std::max(columns, model_.column({i, static_cast<int>(model_.line(i).size())}));
  widest_ = static_cast<float>(columns);
}

void CodeEditor::go_to(TextPlace place) {
  model_.move_to(place, false);
  reveal_ = true;
}

CodeEditor::Metrics CodeEditor::measure(Ui& ui) const {
  Metrics m{};
  m.line = ui.line(Face::code);
  m.problem = ui.px(problem_height);
  m.advance = ui.font(Face::code)->GetCharAdvance('0');
  m.text_x = ui.px(text_left);
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  m.view = {window->InnerRect.Min, window->InnerRect.Max};
  m.origin = ImVec2(std::floor(window->InnerRect.Min.x + m.text_x - window->Scroll.x),
                    std::floor(window->InnerRect.Min.y + ui.px(top_gap) - window->Scroll.y));
  return m;
}

void CodeEditor::collect_problems(const EditorLook& look) {
  problem_lines_.clear();
  if (!look.report) return;
  for (const Problem& p : look.report->problems)
    if (p.error && p.line < model_.line_count() &&
        std::find(problem_lines_.begin(), problem_lines_.end(), p.line) == problem_lines_.end())
      problem_lines_.push_back(p.line);
  std::sort(problem_lines_.begin(), problem_lines_.end());
}

const Problem* CodeEditor::problem_in(const EditorLook& look, int line, bool error) const {
  if (look.report)
    for (const Problem& p : look.report->problems)
      if (p.line == line && p.error == error) return &p;
  return nullptr;
}

float CodeEditor::top_of(const Metrics& m, int line) const {
  const auto rows =
      std::lower_bound(problem_lines_.begin(), problem_lines_.end(), line) - problem_lines_.begin();
  return m.origin.y + static_cast<float>(line) * m.line + static_cast<float>(rows) * m.problem;
}

int CodeEditor::line_at(const Metrics& m, float y) const {
  int low = 0, high = model_.line_count() - 1;
  while (low < high) {
    const int middle = (low + high + 1) / 2;
    if (top_of(m, middle) <= y)
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

TextPlace CodeEditor::place_at(const Metrics& m, ImVec2 at) const {
  const float columns = std::max(0.0f, (at.x - m.origin.x) / m.advance);
  return model_.at_column(line_at(m, at.y), static_cast<int>(columns + 0.5f));
}

float CodeEditor::x_of(const Metrics& m, TextPlace p) const {
  return std::floor(m.origin.x + static_cast<float>(model_.column(p)) * m.advance);
}

EditorEvent CodeEditor::draw(Ui& ui, std::string_view id, const EditorLook& look) {
  if (text_version_ != model_.version()) remember();
  EditorEvent event;
  if (std::exchange(find_asked_, false)) find_.open(ui, id, model_);
  reveal_ |= find_.draw(ui, id, model_);
  collect_problems(look);
  const float room = ImGui::GetContentRegionAvail().y;  // the find bar may take part of the height
  const float height = look.height < 0 ? room : std::min(room, ui.px(look.height));
  const std::uint64_t version = model_.version();
  ImGui::PushID(this);  // each text has its own scroll position
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui[Tone::well]);
  ImGui::BeginChild(
      "lines", ImVec2(0, height), false,
      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const Metrics m = measure(ui);
  const float whole = top_of(m, model_.line_count()) - m.origin.y + 2 * ui.px(top_gap);
  const float wide = m.text_x + widest_ * m.advance + ui.px(96);
  // The fix buttons lie over the area in which a click places the caret.
  ImGui::SetCursorScreenPos(m.view.min);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 content_end = ImGui::GetCurrentWindow()->DC.CursorMaxPos;
  const Touch t = touch(ui, {id, Kind::editor, "program text", text_, {}, false, {}},
                        ImVec2(std::max(1.0f, m.view.width()), std::max(1.0f, m.view.height())));
  ImGui::SetItemAllowOverlap();
  // The item covers the visible part and must not enlarge the scrolling range.
  ImGui::GetCurrentWindow()->DC.CursorMaxPos = content_end;
  if (t.hovered && mouse.x > m.view.min.x + m.text_x) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  use_mouse(ui, m, t);
  // Tab moves to the next control as elsewhere, except that it indents selected lines.
  if (typing_ && model_.has_selection() && look.read_only.empty()) ui.take_tab(TabTaken::both);
  if (ui.focus.take_entry(id)) typing_ = true;
  if (typing_ && !ui.focus.is(id)) typing_ = false;
  if (std::exchange(comment_asked_, false) && look.read_only.empty())
    model_.toggle_comment(look.comment_mark);
  if (typing_) use_keys(ui, look, m);
  follow_live_line(look, m);
  if (reveal_) keep_caret_in_sight(m);
  draw_lines(ui, look, m);
  ImGui::SetCursorPos(ImVec2(wide, whole));
  ImGui::Dummy(ImVec2(0, 0));
  if (t.ring && !typing_) draw_outline(ui, m.view, ui[Tone::ink], 0, ui.px(2));
  ImGui::EndChild();
  ImGui::PopID();
  event.edited = version != model_.version();
  event.typing = typing_;
  if (event.edited) remember();
  return event;
}

void CodeEditor::use_mouse(Ui& ui, const Metrics& m, const Touch& t) {
  const ImGuiIO& io = ImGui::GetIO();
  if (t.started && ImGui::IsMouseClicked(0)) {
    typing_ = dragging_ = true;
    model_.move_to(place_at(m, io.MousePos), io.KeyShift);
    if (io.MouseClickedCount[0] == 3)
      model_.select_line();
    else if (io.MouseClickedCount[0] == 2)
      model_.select_word();
    dragging_ = io.MouseClickedCount[0] < 2;
  } else if (t.held && dragging_ && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    model_.move_to(place_at(m, io.MousePos), true);
    reveal_ = true;
  } else if (ImGui::IsMouseClicked(0) && !t.hovered) {
    typing_ = false;
  }
  if (!t.held) dragging_ = false;
  if (typing_) {
    ui.note_typing();
  }
}

void CodeEditor::use_caret_keys(const Metrics& m, bool ctrl, bool shift) {
  using Step = TextModel::Step;
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), true); };
  const std::uint64_t version = model_.version();
  const TextPlace before = model_.caret();
  const int page = std::max(1, static_cast<int>(m.view.height() / m.line) - 1);
  if (pressed(ImGuiKey_LeftArrow)) model_.left(ctrl ? Step::word : Step::character, shift);
  if (pressed(ImGuiKey_RightArrow)) model_.right(ctrl ? Step::word : Step::character, shift);
  if (pressed(ImGuiKey_UpArrow)) model_.down(-1, shift);
  if (pressed(ImGuiKey_DownArrow)) model_.down(1, shift);
  if (pressed(ImGuiKey_PageUp)) model_.down(-page, shift);
  if (pressed(ImGuiKey_PageDown)) model_.down(page, shift);
  if (pressed(ImGuiKey_Home)) model_.left(ctrl ? Step::text_end : Step::line_end, shift);
  if (pressed(ImGuiKey_End)) model_.right(ctrl ? Step::text_end : Step::line_end, shift);
  reveal_ |= version != model_.version() || !(before == model_.caret());
}

bool CodeEditor::use_control_keys(Ui& ui, const EditorLook& look, bool shift) {
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, true); };
  const bool may_edit = look.read_only.empty();
  if (pressed('A')) return model_.select_all(), true;
  if (pressed('C') || pressed('X')) {
    if (model_.has_selection()) ImGui::SetClipboardText(model_.selected().c_str());
    if (pressed('X') && may_edit && model_.has_selection()) model_.backspace(false);
    return true;
  }
  if (pressed('V')) {
    const char* text = ImGui::GetClipboardText();
    if (text && may_edit) model_.insert(text);
    return true;
  }
  if (pressed('Z') && may_edit) return shift ? model_.redo() : model_.undo(), true;
  if (pressed(']') && may_edit) return model_.indent(1), true;
  if (pressed('[') && may_edit) return model_.indent(-1), true;
  if (pressed('Y') && may_edit) return model_.redo(), true;
  if (pressed('/') && may_edit) return model_.toggle_comment(look.comment_mark), true;
  if (pressed('F')) return find_.open(ui, std::string(ui.focus.id()), model_), false;
  return false;
}

void CodeEditor::use_keys(Ui& ui, const EditorLook& look, const Metrics& m) {
  ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), true); };
  const bool ctrl = io.KeyCtrl, shift = io.KeyShift, may_edit = look.read_only.empty();
  const std::uint64_t version = model_.version();
  use_caret_keys(m, ctrl, shift);
  if (ctrl) {
    reveal_ |= use_control_keys(ui, look, shift);
  } else {
    if (ImGui::IsKeyPressed(tab_key, true) && model_.has_selection() && may_edit)
      model_.indent(shift ? -1 : 1);
    if ((pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) && may_edit) model_.insert("\n");
  }
  if (ImGui::IsKeyPressed(f3_key, true)) reveal_ |= find_.next(model_, !shift);
  if (may_edit) {
    if (pressed(ImGuiKey_Backspace)) model_.backspace(ctrl);
    if (pressed(ImGuiKey_Delete)) model_.erase(ctrl);
    for (ImWchar c : io.InputQueueCharacters) {
      if (c < 32 || c == 127) continue;
      char bytes[5];
      ImTextCharToUtf8(bytes, c);
      model_.insert(bytes);
    }
  }
  io.InputQueueCharacters.resize(0);
  reveal_ |= version != model_.version();
}

void CodeEditor::keep_caret_in_sight(const Metrics& m) {
  reveal_ = false;
  const float top = top_of(m, model_.caret().line), bottom = top + m.line;
  const bool problem = std::binary_search(problem_lines_.begin(), problem_lines_.end(), model_.caret().line);
  const float end = bottom + (problem ? m.problem : 0);
  if (top < m.view.min.y) ImGui::SetScrollY(std::max(0.0f, ImGui::GetScrollY() - (m.view.min.y - top)));
  if (end > m.view.max.y) ImGui::SetScrollY(ImGui::GetScrollY() + (end - m.view.max.y));
  const float x = x_of(m, model_.caret()), left = m.view.min.x + m.text_x,
              right = m.view.max.x - 4 * m.advance;
  if (x < left) ImGui::SetScrollX(std::max(0.0f, ImGui::GetScrollX() - (left - x)));
  if (x > right) ImGui::SetScrollX(ImGui::GetScrollX() + (x - right));
}

/// Scrolls to the line that runs, but only when the line or the size of the view changes, so that the user
/// can scroll away.
void CodeEditor::follow_live_line(const EditorLook& look, const Metrics& m) {
  if (look.live_line == followed_line_ && m.view.height() == followed_height_) return;
  followed_line_ = look.live_line;
  followed_height_ = m.view.height();
  if (look.live_line < 0 || look.live_line >= model_.line_count() || typing_) return;
  const float top = top_of(m, look.live_line);
  if (top < m.view.min.y || top + m.line > m.view.max.y)
    ImGui::SetScrollY(std::max(0.0f, ImGui::GetScrollY() + top - m.view.min.y - m.view.height() / 3));
}

}  // namespace hw::gui
