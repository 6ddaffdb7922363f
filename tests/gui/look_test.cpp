// The tokens of the look: contrast, and figures that keep their column.
#include <cmath>

#include <gtest/gtest.h>

#include "gui/widgets/digits.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

/// Of two opaque colours after WCAG 2: 1 (same) to 21 (black on white).
double contrast(ImU32 a, ImU32 b) {
  const auto luminance = [](ImU32 c) {
    const auto channel = [&](int shift) {
      const double v = ((c >> shift) & 255) / 255.0;
      return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(IM_COL32_R_SHIFT) + 0.7152 * channel(IM_COL32_G_SHIFT) +
           0.0722 * channel(IM_COL32_B_SHIFT);
  };
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

TEST(Look, AStateHasAWord) {
  EXPECT_EQ(look_of(State::idle).word, "IDLE");
  EXPECT_EQ(look_of(State::slipped).word, "SLIP");
  EXPECT_EQ(look_of(State::in_place).word, "IN PLACE");
  EXPECT_EQ(look_of(State::open_loop).word, "OPEN LOOP");
  EXPECT_EQ(look_of(State::not_in_place).word, "OFF PLACE");
}

TEST(Theme, TextNeverFallsBelowFourAndAHalf) {
  const Tone texts[] = {Tone::ink,  Tone::ink2,  Tone::ink3, Tone::motion, Tone::ok,
                        Tone::warn, Tone::fault, Tone::emu,  Tone::flow,   Tone::trace};
  const Tone grounds[] = {Tone::ground, Tone::panel, Tone::raised, Tone::hover, Tone::well, Tone::sel};
  for (const Theme* theme : {&dark_theme, &light_theme})
    for (Tone text : texts)
      for (Tone ground : grounds)
        EXPECT_GE(contrast((*theme)[text], (*theme)[ground]), 4.45)
            << (theme->dark ? "dark " : "light ") << static_cast<int>(text) << " on "
            << static_cast<int>(ground);
}

TEST(Theme, TintsAndFillsCarryTheirText) {
  const std::pair<Tone, Tone> pairs[] = {
      {Tone::motion, Tone::motion_t}, {Tone::ok, Tone::ok_t},     {Tone::warn, Tone::warn_t},
      {Tone::fault, Tone::fault_t},   {Tone::emu, Tone::emu_t},   {Tone::on_motion, Tone::motion},
      {Tone::on_stop, Tone::stop},    {Tone::panel, Tone::ink},   {Tone::ink, Tone::fault_t},
      {Tone::ink, Tone::warn_t},      {Tone::ink, Tone::motion_t}};
  for (const Theme* theme : {&dark_theme, &light_theme})
    for (const auto& [text, ground] : pairs)
      EXPECT_GE(contrast((*theme)[text], (*theme)[ground]), 4.5)
          << (theme->dark ? "dark " : "light ") << static_cast<int>(text) << " on "
          << static_cast<int>(ground);
}

TEST(Fonts, FiguresAreTabularInEachFace) {
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    Fonts fonts;
    fonts.build(scale);
    for (int face = 0; face < static_cast<int>(Face::count); ++face) {
      const ImFont* font = fonts[static_cast<Face>(face)];
      const float one = font->GetCharAdvance('1');
      EXPECT_GT(one, 0);
      for (char figure = '0'; figure <= '9'; ++figure)
        EXPECT_FLOAT_EQ(font->GetCharAdvance(static_cast<ImWchar>(figure)), one) << "face " << face;
    }
  }
}

TEST(Fonts, TheAtlasStaysSmall) {
  Fonts fonts;
  fonts.build(1);
  EXPECT_EQ(fonts.atlas().TexWidth, 1024);
  EXPECT_LE(fonts.atlas().TexHeight, 1024);
}

TEST(Fonts, HaveTheSignsThatSentencesUse) {
  Fonts fonts;
  fonts.build(1);
  for (const ImWchar c : {0x2009, 0x2013, 0x2026, 0x2212, 0x2264, 0x2265, 0x2039, 0x203A, 0xB0, 0xB5})
    for (const Face face : {Face::small, Face::body, Face::body_bold, Face::code}) {
      if (face == Face::code && c == 0x2009) continue;  // the wire has no thin spaces, nor has its face
      EXPECT_NE(fonts[face]->FindGlyphNoFallback(c), nullptr) << std::hex << c;
    }
}

TEST(Fonts, EightFiguresFitIntoTheColumn) {
  float width = 0;
  Stage stage(in_window([&](Ui& ui) {
    width = text_width(ui, Face::digits48,
                       "\xE2\x88\x92"
                       "150.000");
  }));
  stage.frames(1);
  EXPECT_LE(width, 272 - 36);
}

}  // namespace
}  // namespace hw::gui
