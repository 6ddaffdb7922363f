#include "gui/widgets/state_word.h"

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr StateLook looks[] = {
    {Icon::ring, "IDLE", "idle", Tone::ink2},
    {Icon::play, "MOVING +", "moving", Tone::motion},
    {Icon::back, "MOVING \xE2\x88\x92", "moving", Tone::motion},
    {Icon::play, "MOVING", "moving", Tone::motion},
    {Icon::home_plus, "HOMING", "homing", Tone::motion},
    {Icon::home_minus, "HOMING", "homing", Tone::motion},
    {Icon::pause, "STOPPING", "stopping", Tone::motion},
    {Icon::limit_plus, "LIMIT +", "limit +", Tone::warn},
    {Icon::limit_minus, "LIMIT \xE2\x88\x92", "limit \xE2\x88\x92", Tone::warn},
    {Icon::cross, "OFF", "off", Tone::ink3},
    {Icon::clock, "STALE", "stale", Tone::warn},
    {Icon::diamond, "UNTRUSTED", "untrusted", Tone::warn},
    {Icon::plug, "LOST", "link lost", Tone::fault},
    {Icon::diamond_solid, "FAULT", "fault", Tone::fault},
    {Icon::pause, "WAITING", "waiting", Tone::ink2},
    {Icon::clock, "CONNECTING", "asking", Tone::ink2},
    {Icon::warning, "SLIP", "slip", Tone::warn},
    {Icon::ring_dot, "IN PLACE", "in place", Tone::ink2},
    {Icon::cross, "OPEN LOOP", "open loop", Tone::ink3},
    {Icon::warning, "OFF PLACE", "not in place", Tone::warn},
};

Rect draw_state(Ui& ui, ImVec2 at, const StateLook& look, Face face) {
  const float h = ui.line(face);
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(at.x + ui.px(6), at.y + std::floor(h * 0.5f)),
            ui.px(12), ui[look.tone]);
  draw_text(ui, ImVec2(at.x + ui.px(20), at.y), face, ui[look.tone], look.word);
  return {at, ImVec2(at.x + ui.px(20) + std::ceil(text_width(ui, face, look.word)), at.y + h)};
}

void register_words(Ui& ui, std::string_view id, std::string_view words, const Rect& rect) {
  if (!id.empty()) show(ui, {id, Kind::text, words, words, {}, false, {}}, rect);
}

}  // namespace

const StateLook& look_of(State state) { return looks[static_cast<std::size_t>(state)]; }

float state_word_width(const Ui& ui, State state, Face face) {
  return ui.px(20) + std::ceil(text_width(ui, face, look_of(state).word));
}

void draw_state_right(Ui& ui, std::string_view id, ImVec2 right, State state, Face face, float room_px) {
  const StateLook& look = look_of(state);
  const float middle = right.y + std::floor(ui.line(face) * 0.5f);
  for (const Face fits : {face, Face::small_bold}) {
    const float width = state_word_width(ui, state, fits);
    if (width > room_px) continue;
    const float top = middle - std::floor(ui.line(fits) * 0.5f);
    return register_words(ui, id, look.word, draw_state(ui, ImVec2(right.x - width, top), look, fits));
  }
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(right.x - ui.px(6), middle), ui.px(12),
            ui[look.tone]);
  register_words(ui, id, look.word,
                 {ImVec2(right.x - ui.px(12), right.y), ImVec2(right.x, right.y + ui.line(face))});
}

}  // namespace hw::gui
