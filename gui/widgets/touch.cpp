#include "gui/widgets/touch.h"

#include <algorithm>

#include <imgui_internal.h>

#include "gui/model/gui_log.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr double not_taken_shown_s = 2;

void add_to_registry(Ui& ui, const About& about, const Rect& rect, bool hovered,
                     const PressGuard::Button* place = nullptr) {
  Widget w;
  w.id = about.id;
  w.label = about.label;
  w.value = about.value;
  w.reason = about.disabled;
  w.kind = about.kind;
  w.rect = rect;
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  w.clip = {clip.Min, clip.Max};
  w.layer = GImGui->BeginPopupStack.Size;
  w.enabled = about.disabled.empty();
  w.moving = about.moving;
  w.stops = about.stops;
  w.card = about.card;
  if (place) {
    w.settled_since_s = place->since_s;
    w.press_ignored = place->ignored_until_s > ui.now_s;
  }
  w.hovered = hovered;
  ui.registry.add(w);
}

void press_by_mouse(const Ui& ui, Touch& t) {
  t.pressed_at_s = ui.input.pressed_at_s();
  t.released_at_s = ui.input.released_at_s();
  t.started = ImGui::IsItemActivated();
  t.ended = ImGui::IsItemDeactivated();
  t.held = ImGui::IsItemActive();
  t.double_clicked = t.hovered && ImGui::IsMouseDoubleClicked(0);
}

void press_by_keyboard(Ui& ui, std::string_view id, Touch& t) {
  if (ui.focus.key_held(id) || ui.focus.key_ended(id)) {
    t.pressed_at_s = ui.focus.key_pressed_at_s();
    t.released_at_s = ui.focus.key_ended(id) ? ui.focus.key_released_at_s() : ui.now_s;
  }
  t.started |= ui.focus.key_started(id);
  t.held |= ui.focus.key_held(id);
  t.ended |= ui.focus.key_ended(id);
  t.clicked |= ui.focus.key_started(id);
  t.armed = ui.focus.armed(id, ui.now_s);
  if (t.armed) ui.wake_in(2.0);
}

/// Ignores a press, and its release, on a widget that has just moved under the pointer.
void refuse_early_press(Ui& ui, std::string_view id, PressGuard::Button& place, Touch& t) {
  if (t.started) place.ignored_until_s = 0;
  if (t.started && place.too_early(t.pressed_at_s)) {
    gui_log().debug("a press on {} is ignored: it was {} only a moment ago", id,
                    place.became_ready ? "enabled" : "placed here");
    place.ignored_until_s = ui.now_s + not_taken_shown_s;
    ImGui::ClearActiveID();
    t.started = t.held = t.clicked = t.double_clicked = false;
  }
  t.press_ignored = place.ignored_until_s > ui.now_s;
  if (t.press_ignored) ui.wake_in(place.ignored_until_s - ui.now_s);
}

std::string_view why_ignored(const PressGuard::Button& place) {
  return place.became_ready ? "Press again: it was enabled only a moment ago."
                            : "Press again: it appeared here only a moment ago.";
}

/// The tip says why the widget is disabled, what it does, or why a press had no effect.
void show_tip(Ui& ui, const About& about, const Touch& t, bool over, const PressGuard::Button* place) {
  const std::string_view shown = !t.enabled ? about.disabled : about.tip;
  const bool shown_for_ring = t.ring && !t.armed && !t.enabled;
  if (t.armed)
    tooltip(ui, "Press again within two seconds: this moves something.", &t.rect);
  else if (t.press_ignored)
    tooltip(ui, why_ignored(*place), &t.rect);
  else if (!shown.empty() && !t.held && (over || shown_for_ring))
    tooltip(ui, shown, over ? nullptr : &t.rect);
}

}  // namespace

Touch touch(Ui& ui, const About& about, ImVec2 size) {
  Touch t;
  t.enabled = about.disabled.empty();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // In a narrow window at a large scale the size may be empty, which ImGui rejects.
  size = ImVec2(std::max(size.x, 1.0f), std::max(size.y, 1.0f));
  t.rect = {at, ImVec2(at.x + size.x, at.y + size.y)};
  const char* begin = about.id.data();
  ImGui::PushID(begin, begin + about.id.size());
  const bool pressed = ImGui::InvisibleButton("", size);
  const bool over = about.always ? t.rect.contains(ImGui::GetIO().MousePos) : ImGui::IsItemHovered();
  t.hovered = over;
  PressGuard::Button* place = nullptr;
  if (about.moving) {
    const bool uncovered = GImGui->BeginPopupStack.Size >= ui.registry.top_layer();
    place = &ui.press_guard.see(ImGui::GetID(""), t.rect, t.enabled && uncovered, ui.now_s);
  }
  if (t.enabled) {
    t.clicked = about.always ? over && ImGui::IsMouseClicked(0) : pressed;
    press_by_mouse(ui, t);
    if (place) refuse_early_press(ui, about.id, *place, t);
    if (t.started) ui.focus.set(about.id);
    press_by_keyboard(ui, about.id, t);
  }
  ImGui::PopID();
  t.ring = ui.focus.ring_on(about.id);
  t.hovered |= ui.pretend == Ui::Pretend::hovered;
  t.held |= ui.pretend == Ui::Pretend::held;
  t.ring |= ui.pretend == Ui::Pretend::ring;
  if (ui.registry.wants_scroll(about.id)) ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleEdgeY);
  add_to_registry(ui, about, t.rect, over, place);
  show_tip(ui, about, t, over, place);
  return t;
}

void show(Ui& ui, const About& about, const Rect& rect) {
  const bool over = ImGui::IsWindowHovered() && rect.contains(ImGui::GetIO().MousePos);
  if (ui.registry.wants_scroll(about.id)) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    ImGui::ScrollToBringRectIntoView(window, ImRect(rect.min, rect.max));
  }
  add_to_registry(ui, about, rect, over);
  if (over && !about.tip.empty()) tooltip(ui, about.tip);
}

void draw_fill(Ui& ui, const Rect& r, ImU32 colour, float rounding) {
  ImGui::GetWindowDrawList()->AddRectFilled(r.min, r.max, colour, ui.px(rounding));
}

void draw_outline(Ui& ui, const Rect& r, ImU32 colour, float rounding, float width) {
  // ImGui's AddRect draws around (min + 0.5, max - 0.5), which gives whole pixels for odd widths.
  const float w = width > 0 ? width : ui.hair();
  const float inset = (w - 1) * 0.5f;
  ImGui::GetWindowDrawList()->AddRect(ImVec2(r.min.x + inset, r.min.y + inset),
                                      ImVec2(r.max.x - inset, r.max.y - inset), colour, ui.px(rounding), 0,
                                      w);
}

void draw_ring(Ui& ui, const Touch& t) {
  if (t.press_ignored) draw_dashed_outline(ui, t.rect, ui[Tone::warn]);
  if (!t.ring) return;
  const float out = ui.px(4), w = ui.px(2);
  const Rect r{ImVec2(t.rect.min.x - out, t.rect.min.y - out),
               ImVec2(t.rect.max.x + out, t.rect.max.y + out)};
  draw_outline(ui, r, ui[Tone::ink], 5, w);
}

void draw_dashed_outline(Ui& ui, const Rect& r, ImU32 colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float w = ui.hair(), dash = ui.px(3), step = 2 * dash;
  for (float x = r.min.x; x < r.max.x; x += step) {
    const float end = std::min(x + dash, r.max.x);
    list->AddRectFilled(ImVec2(x, r.min.y), ImVec2(end, r.min.y + w), colour);
    list->AddRectFilled(ImVec2(x, r.max.y - w), ImVec2(end, r.max.y), colour);
  }
  for (float y = r.min.y; y < r.max.y; y += step) {
    const float end = std::min(y + dash, r.max.y);
    list->AddRectFilled(ImVec2(r.min.x, y), ImVec2(r.min.x + w, end), colour);
    list->AddRectFilled(ImVec2(r.max.x - w, y), ImVec2(r.max.x, end), colour);
  }
}

void draw_motion_edge(Ui& ui, const Rect& r, ImU32 colour) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(r.min.x, r.max.y - ui.px(2)), r.max, colour, ui.px(3),
                                            ImDrawFlags_RoundCornersBottom);
}

}  // namespace hw::gui
