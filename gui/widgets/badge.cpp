#include "gui/widgets/badge.h"

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

struct Pair {
  Tone ink, tint;
};
Pair pair_of(BadgeTone tone) {
  switch (tone) {
    case BadgeTone::emulated: return {Tone::emu, Tone::emu_t};
    case BadgeTone::ok: return {Tone::ok, Tone::ok_t};
    case BadgeTone::warn: return {Tone::warn, Tone::warn_t};
    case BadgeTone::fault: return {Tone::fault, Tone::fault_t};
    case BadgeTone::motion: break;
  }
  return {Tone::motion, Tone::motion_t};
}

}  // namespace

float badge_width(const Ui& ui, Icon icon, std::string_view words) {
  if (words.empty()) return ui.px(24);
  return std::ceil(text_width(ui, Face::small_bold, words)) + ui.px(icon == Icon::none ? 12 : 30);
}

namespace {

constexpr std::string_view emulated_word = "EMULATED";

struct EmulatedParts {
  Icon icon;
  std::string_view word;
};
EmulatedParts parts_of(EmulatedForm form) {
  return {form == EmulatedForm::word ? Icon::none : Icon::emulated,
          form == EmulatedForm::shape ? std::string_view() : emulated_word};
}

}  // namespace

EmulatedForm emulated_form(const Ui& ui, float room_px) {
  for (const EmulatedForm form : {EmulatedForm::whole, EmulatedForm::word})
    if (emulated_width(ui, form) <= room_px) return form;
  return EmulatedForm::shape;
}

float emulated_width(const Ui& ui, EmulatedForm form) {
  const auto [icon, word] = parts_of(form);
  return badge_width(ui, icon, word);
}

void emulated_badge(Ui& ui, std::string_view id, EmulatedForm form) {
  const auto [icon, word] = parts_of(form);
  badge(ui, {}, BadgeTone::emulated, icon, word);
  show(ui,
       {id,
        Kind::text,
        emulated_word,
        emulated_word,
        {},
        false,
        "Not a real controller: an emulator in this program."},
       {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
}

void badge(Ui& ui, std::string_view id, BadgeTone tone, Icon icon, std::string_view words,
           std::string_view tip) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect r{at, ImVec2(at.x + badge_width(ui, icon, words), at.y + ui.px(20))};
  const Pair pair = pair_of(tone);
  draw_fill(ui, r, ui[pair.tint], 2);
  float x = r.min.x + ui.px(6);
  if (icon != Icon::none) {
    draw_icon(ImGui::GetWindowDrawList(), icon, ImVec2(x + ui.px(6), std::floor(r.centre().y)), ui.px(11),
              ui[pair.ink]);
    x += ui.px(18);
  }
  draw_text_line(ui, x, r.max.x, r.centre().y, Face::small_bold, ui[pair.ink], words);
  ImGui::Dummy(ImVec2(r.width(), r.height()));
  if (!id.empty()) show(ui, {id, Kind::text, words, words, {}, false, tip}, r);
}

}  // namespace hw::gui
