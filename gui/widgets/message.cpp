#include "gui/widgets/message.h"

#include <algorithm>
#include <cstdio>

#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/region.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

/// Dims the screen, except the modal and STOP ALL, which still works.
void dim_around_modal(Ui& ui) {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  Rect holes[2] = {{window->Pos, ImVec2(window->Pos.x + window->Size.x, window->Pos.y + window->Size.y)}, {}};
  if (const Widget* stop = ui.registry.find("stop_all")) holes[1] = stop->rect;
  float edges[6] = {0, holes[0].min.y, holes[0].max.y, holes[1].min.y, holes[1].max.y, ui.size_px.y};
  std::sort(edges, edges + 6);
  window->DrawList->PushClipRectFullScreen();
  const ImU32 colour = with_alpha(ui[Tone::ground], ui.theme.dark ? 0.6f : 0.5f);
  for (int i = 0; i + 1 < 6; ++i) {
    const float y0 = edges[i], y1 = edges[i + 1], middle = (y0 + y1) * 0.5f;
    float x = 0;
    if (y1 <= y0) continue;
    const bool swapped = holes[1].min.x < holes[0].min.x;
    for (const Rect& hole : {holes[swapped], holes[!swapped]}) {
      if (middle < hole.min.y || middle >= hole.max.y) continue;
      window->DrawList->AddRectFilled(ImVec2(x, y0), ImVec2(std::max(x, hole.min.x), y1), colour);
      x = std::max(x, hole.max.x);
    }
    window->DrawList->AddRectFilled(ImVec2(x, y0), ImVec2(ui.size_px.x, y1), colour);
  }
  window->DrawList->PopClipRect();
}

/// Writes `<id>/<tail>` into `buffer`.
std::string_view child(std::span<char> buffer, std::string_view id, std::string_view tail) {
  const int n = std::snprintf(buffer.data(), buffer.size(), "%.*s/%.*s", static_cast<int>(id.size()),
                              id.data(), static_cast<int>(tail.size()), tail.data());
  return {buffer.data(), static_cast<std::size_t>(std::clamp(n, 0, static_cast<int>(buffer.size()) - 1))};
}

int draw_actions(Ui& ui, std::span<const Action> actions, std::string_view aside) {
  int picked = -1;
  for (int i = 0; i < static_cast<int>(actions.size()); ++i) {
    const Action& a = actions[static_cast<std::size_t>(i)];
    ButtonOptions o;
    o.style = a.main ? ButtonStyle::normal : ButtonStyle::quiet;
    o.disabled = a.disabled;
    o.moving = a.moving;
    if (i > 0) ImGui::SameLine();
    if (button(ui, a.id, a.label, o).clicked) picked = i;
    if (i == 0 && !aside.empty()) {
      ImGui::SameLine();
      const ImVec2 at = ImGui::GetCursorScreenPos();
      draw_text_line(ui, at.x + ui.px(8), at.x + ui.px(400), at.y + ui.px(16), Face::body, ui[Tone::ink2],
                     aside);
      ImGui::Dummy(ImVec2(std::ceil(text_width(ui, Face::body, aside)) + ui.px(16), ui.px(32)));
    }
  }
  return picked;
}

}  // namespace

SeverityMark severity_mark(Severity severity) {
  switch (severity) {
    case Severity::plain: return {Tone::ink2, Tone::raised, Icon::info};
    case Severity::ok: return {Tone::ok, Tone::ok_t, Icon::check};
    case Severity::motion: return {Tone::motion, Tone::motion_t, Icon::play};
    case Severity::warn: return {Tone::warn, Tone::warn_t, Icon::warning};
    case Severity::fault: break;
  }
  return {Tone::fault, Tone::fault_t, Icon::diamond_solid};
}

void tinted(Ui& ui, Severity severity, float height_px) {
  const float y = ImGui::GetCursorScreenPos().y;
  const SeverityMark look = severity_mark(severity);
  draw_across(ui, y, y + height_px, ui[look.tint], ui[look.ink]);
}

int banner(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float side = ui.px(16), indent = ui.px(28);
  const ImVec2 at(corner.x + side, corner.y);
  const float width = ImGui::GetContentRegionAvail().x - 2 * side;
  const float sentences = wrapped_height(ui, Face::body, what.sentences, width - indent);
  const float rows = actions.empty() ? 0 : ui.px(32) + ui.px(8);
  const float height = ui.px(12) + ui.line(Face::title_bold) + ui.px(6) + sentences + rows + ui.px(12);
  const SeverityMark look = severity_mark(what.severity);
  tinted(ui, what.severity, height);
  draw_icon(ImGui::GetWindowDrawList(), what.icon, ImVec2(at.x + ui.px(8), at.y + ui.px(22)), ui.px(14),
            ui[look.ink]);
  draw_text_line(ui, at.x + indent, at.x + width, at.y + ui.px(22), Face::title_bold, ui[Tone::ink],
                 what.title);
  show(ui, {.id = id, .kind = Kind::text, .label = what.title, .value = what.sentences, .card = true},
       {at, ImVec2(at.x + width, at.y + height)});
  ImGui::SetCursorScreenPos(ImVec2(at.x + indent, at.y + ui.px(18) + ui.line(Face::title_bold)));
  ImGui::BeginGroup();
  wrapped(ui, Face::body, Tone::ink, what.sentences, (width - indent) / ui.scale);
  int picked = -1;
  if (!actions.empty()) {
    gap(ui, 4);
    picked = draw_actions(ui, actions, what.aside);
  }
  ImGui::EndGroup();
  ImGui::SetCursorScreenPos(ImVec2(corner.x, at.y + height));
  return picked;
}

float banner_height(const Ui& ui, const Banner& what, float width, bool actions) {
  const float words = wrapped_height(ui, Face::body, what.sentences, ui.px(width - 2 * 16 - 28)) / ui.scale;
  return std::ceil(12 + ui.line(Face::title_bold) / ui.scale + 6 + words + (actions ? 32 + 8 : 0) + 12);
}

namespace {

std::string_view brief_label(const Action& a) { return a.brief.empty() ? a.label : a.brief; }

/// The end of the sentences without the last `left_out`; 0: no sentence is left.
std::size_t end_without(std::string_view sentences, int left_out) {
  std::size_t end = sentences.size();
  for (; left_out > 0 && end != 0; --left_out) {
    const std::size_t before = end > 1 ? sentences.rfind(". ", end - 2) : sentences.npos;
    end = before == sentences.npos ? 0 : before + 1;
  }
  return end;
}

void show_under_mouse(Ui& ui, const Rect& in, const Banner& what) {
  if (ImGui::IsWindowHovered() && in.contains(ImGui::GetIO().MousePos)) ui.note_cut(what.sentences);
}

std::string words_of_bar(const Banner& what) {
  std::string words(what.brief.empty() ? what.sentences : what.brief);
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words;
}

/// Draws the title, and behind it as many whole sentences as fit.
void draw_words_in_one_line(Ui& ui, const Rect& in, const Banner& what) {
  const std::string kept = words_of_bar(what);
  const std::string_view words = kept;
  const float middle = std::floor(in.centre().y);
  const float behind = in.min.x + std::ceil(text_width(ui, Face::small_bold, what.title)) + ui.px(8);
  draw_text_line(ui, in.min.x, in.max.x, middle, Face::small_bold, ui[Tone::ink], what.title);
  show_under_mouse(ui, in, what);
  if (behind + ui.px(80) > in.max.x) return;
  std::size_t end = words.size();
  for (int left_out = 1; end != 0 && behind + text_width(ui, Face::small, words.substr(0, end)) > in.max.x;
       ++left_out)
    end = end_without(words, left_out);
  if (end == 0) end = words.size();  // even the first sentence is too long: it is cut
  draw_text_line(ui, behind, in.max.x, middle, Face::small, ui[Tone::ink], words.substr(0, end));
}

/// Draws the title, and behind or below it as many whole sentences as fit into two lines. The tip shows the
/// rest.
void draw_bar_words(Ui& ui, const Rect& in, const Banner& what) {
  const std::string kept = words_of_bar(what);
  const std::string_view words = kept;
  const std::string title =
      std::string(what.title) + (what.aside.empty() ? "" : " ") + std::string(what.aside);
  const float upper = in.min.y + in.height() / 4, lower = in.max.y - in.height() / 4;
  draw_text_line(ui, in.min.x, in.max.x, upper, Face::small_bold, ui[Tone::ink], title);
  const float behind = in.min.x + std::ceil(text_width(ui, Face::small_bold, title)) + ui.px(8);
  const auto shown_for_mouse = [&](bool whole) {
    if (!whole) show_under_mouse(ui, in, what);
  };
  if (text_width(ui, Face::small, words) <= in.width() || behind + ui.px(80) > in.max.x) {
    std::size_t end = words.size();
    for (int left_out = 1; end != 0 && text_width(ui, Face::small, words.substr(0, end)) > in.width();
         ++left_out)
      end = end_without(words, left_out);
    if (end == 0) end = words.size();  // even the first sentence is too long: it is cut
    shown_for_mouse(end == words.size());
    return draw_text_line(ui, in.min.x, in.max.x, lower, Face::small, ui[Tone::ink], words.substr(0, end));
  }
  std::string_view first, second;
  for (int left_out = 0;; ++left_out) {
    const std::size_t end = end_without(words, left_out);
    if (end == 0) break;  // even the first sentence is too long: it is cut
    const std::string_view part = words.substr(0, end);
    const char* wrap =
        ui.font(Face::small)
            ->CalcWordWrapPositionA(1.0f, part.data(), part.data() + part.size(), in.max.x - behind);
    first = part.substr(0, static_cast<std::size_t>(wrap - part.data()));
    second = part.substr(first.size());
    while (second.starts_with(' ')) second.remove_prefix(1);
    if (text_width(ui, Face::small, second) <= in.width()) break;
  }
  shown_for_mouse(first.size() + second.size() + 1 >= words.size());
  draw_text_line(ui, behind, in.max.x + 1, upper, Face::small, ui[Tone::ink], first);
  draw_text_line(ui, in.min.x, in.max.x, lower, Face::small, ui[Tone::ink], second);
}

}  // namespace

int banner_bar(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions,
               bool one_line) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const Rect all{at, ImVec2(at.x + room.x, at.y + room.y)};
  const SeverityMark look = severity_mark(what.severity);
  tinted(ui, what.severity, all.height());
  show(ui, {.id = id, .kind = Kind::text, .label = what.title, .value = what.sentences, .card = true}, all);
  const float middle = std::floor(all.centre().y), line = ui.line(Face::small), side = ui.px(16);
  draw_icon(ImGui::GetWindowDrawList(), what.icon, ImVec2(at.x + side, middle), ui.px(14), ui[look.ink]);
  float width = 0;
  for (const Action& a : actions) width += ui.px(button_width(ui, brief_label(a))) + ui.px(8);
  const float left = at.x + 2 * side, right = all.max.x - width - ui.px(8);
  const Rect words{ImVec2(left, middle - line), ImVec2(right, middle + line)};
  one_line ? draw_words_in_one_line(ui, words, what) : draw_bar_words(ui, words, what);
  ImGui::SetCursorScreenPos(ImVec2(right + ui.px(8), middle - ui.px(14)));
  int picked = -1;
  for (int i = 0; i < static_cast<int>(actions.size()); ++i) {
    const Action& a = actions[static_cast<std::size_t>(i)];
    const ButtonOptions o{.style = a.main ? ButtonStyle::normal : ButtonStyle::quiet,
                          .disabled = a.disabled,
                          .height = 28,
                          .moving = a.moving};
    if (i > 0) ImGui::SameLine(0, ui.px(8));
    if (button(ui, a.id, brief_label(a), o).clicked) picked = i;
  }
  return picked;
}

namespace {

/// Whether a dialog was drawn in this frame or the previous one. A dialog may remain in ImGui's stack when
/// its owner disappeared without closing it; it does not count.
bool a_dialog_is_open() {
  for (const ImGuiPopupData& popup : GImGui->OpenPopupStack)
    if (const ImGuiWindow* w = popup.Window; w && (w->Flags & ImGuiWindowFlags_Modal))
      if (w->Active || w->WasActive) return true;
  return false;
}

}  // namespace

bool begin_modal(Ui& ui, std::string_view id, bool open, float width, float height) {
  char name[96];
  std::snprintf(name, sizeof name, "##%.*s", static_cast<int>(id.size()), id.data());
  if (!open) return false;
  // ImGui has one popup per level. Two modals would close each other in every frame.
  if (!ImGui::IsPopupOpen(name) && !a_dialog_is_open()) ImGui::OpenPopup(name);
  const float w = std::min(ui.px(width), ui.size_px.x - ui.px(32));
  // Centred below the top bar: STOP ALL stays visible.
  const float top = ui.px(top_bar_height), room = ui.size_px.y - top;
  const float h = height > 0 ? std::min(ui.px(height), room - ui.px(16)) : 0;
  ImGui::SetNextWindowPos(ImVec2(std::floor(ui.size_px.x * 0.5f), std::floor(top + room * 0.5f)),
                          ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(w, h));
  // A modal as high as its content scrolls in a lower window.
  if (height == 0) ImGui::SetNextWindowSizeConstraints(ImVec2(w, 0), ImVec2(w, room - ui.px(16)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.px(24, 20));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui.hair());
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
  if (height == 0) flags |= ImGuiWindowFlags_AlwaysAutoResize;
  const bool shown = ImGui::BeginPopupModal(name, nullptr, flags);
  ImGui::PopStyleVar(3);
  if (!shown) return false;
  ui.take_arrows();
  dim_around_modal(ui);
  return true;
}

void end_modal() { ImGui::EndPopup(); }

Answer dialog(Ui& ui, std::string_view id, bool& open, const Dialog& what) {
  if (!begin_modal(ui, id, open, 480)) return Answer::none;
  char buffer[128];
  if (ImGui::IsWindowAppearing()) ui.focus.move_to(child(buffer, id, "no"));
  text(ui, Face::title_bold, Tone::ink, what.title);
  gap(ui, 8);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::body, Tone::ink2, what.sentences, 432);
  show(ui, {child(buffer, id, "says"), Kind::text, what.title, what.sentences},
       {from, ImVec2(from.x + ui.px(432), ImGui::GetCursorScreenPos().y)});
  gap(ui, 16);
  Answer answer = Answer::none;
  const ButtonOptions no{.style = ButtonStyle::outlined};
  const ButtonOptions yes{.style = what.moving ? ButtonStyle::normal : ButtonStyle::primary,
                          .moving = what.moving};
  const float both = ui.px(button_width(ui, what.no, no)) + ui.px(button_width(ui, what.yes, yes)) + ui.px(8);
  ImGui::SetCursorScreenPos(
      ImVec2(ImGui::GetCursorScreenPos().x + std::max(0.0f, ImGui::GetContentRegionAvail().x - both),
             ImGui::GetCursorScreenPos().y));
  if (button(ui, child(buffer, id, "no"), what.no, no).clicked || ui.cancelled()) answer = Answer::no;
  ImGui::SameLine();
  if (button(ui, child(buffer, id, "yes"), what.yes, yes).clicked) answer = Answer::yes;
  if (answer != Answer::none) {
    open = false;
    ImGui::CloseCurrentPopup();
  }
  end_modal();
  return answer;
}

}  // namespace hw::gui
