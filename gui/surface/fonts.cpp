#include "gui/surface/fonts.h"

#include <algorithm>
#include <cmath>

#include <imstb_truetype.h>

extern "C" {
extern const unsigned char hw_font_inter_regular[], hw_font_inter_regular_end[];
extern const unsigned char hw_font_inter_medium[], hw_font_inter_medium_end[];
extern const unsigned char hw_font_inter_semibold[], hw_font_inter_semibold_end[];
extern const unsigned char hw_font_mono_regular[], hw_font_mono_regular_end[];
}

namespace hw::gui {
namespace {

enum class Cut : std::uint8_t { regular, medium, semibold, mono };
enum class Letters : std::uint8_t { text, figures };

struct File {
  const unsigned char* begin;
  const unsigned char* end;
};
File file_of(Cut cut) {
  switch (cut) {
    case Cut::regular: return {hw_font_inter_regular, hw_font_inter_regular_end};
    case Cut::medium: return {hw_font_inter_medium, hw_font_inter_medium_end};
    case Cut::semibold: return {hw_font_inter_semibold, hw_font_inter_semibold_end};
    case Cut::mono: break;
  }
  return {hw_font_mono_regular, hw_font_mono_regular_end};
}

struct Spec {
  Face face;
  Cut cut;
  FaceSize size;
  Letters letters;
};
constexpr Spec specs[] = {
    {Face::small, Cut::regular, {12, 16}, Letters::text},
    {Face::small_bold, Cut::semibold, {12, 16}, Letters::text},
    {Face::body, Cut::regular, {14, 20}, Letters::text},
    {Face::body_medium, Cut::medium, {14, 20}, Letters::text},
    {Face::body_bold, Cut::semibold, {14, 20}, Letters::text},
    {Face::title, Cut::regular, {16, 20}, Letters::text},
    {Face::title_bold, Cut::semibold, {16, 20}, Letters::text},
    {Face::stop, Cut::semibold, {20, 24}, Letters::text},
    {Face::time, Cut::medium, {20, 24}, Letters::text},
    {Face::digits26, Cut::medium, {26, 32}, Letters::figures},
    {Face::digits32, Cut::medium, {32, 36}, Letters::figures},
    {Face::digits36, Cut::medium, {36, 36}, Letters::figures},
    {Face::digits48, Cut::medium, {48, 48}, Letters::figures},
    {Face::code, Cut::mono, {14, 24}, Letters::text},
    {Face::code_field, Cut::mono, {13, 20}, Letters::text},
    {Face::code_time, Cut::mono, {12, 20}, Letters::text},
};
static_assert(std::size(specs) == static_cast<std::size_t>(Face::count));

// The characters of the console's sentences (thin space, dashes, ellipsis, minus, comparison, single angle
// quotes) without the figures, which are merged from the same file in cells of equal width.
constexpr ImWchar text_but_figures[] = {0x20,   0x2F,   0x3A,   0x17F,  0x2009, 0x2009,
                                        0x2013, 0x2013, 0x2026, 0x2026, 0x2039, 0x203A,
                                        0x2212, 0x2212, 0x2264, 0x2265, 0};
// Large sizes are used for the top bar's words and a time: Latin-1 is enough.
constexpr ImWchar large_but_figures[] = {0x20,   0x2F,   0x3A,   0x7E,   0xA0, 0xFF,
                                         0x2009, 0x2009, 0x2212, 0x2212, 0};
constexpr ImWchar signs_of_digits[] = {0x20, 0x20, 0x2D, 0x2E, 0x2212, 0x2212, 0};
constexpr ImWchar figures[] = {'0', '9', 0};
constexpr ImWchar mono_all[] = {0x20,   0x17F,  0x2009, 0x2009, 0x2013, 0x2013, 0x2026, 0x2026,
                                0x2039, 0x203A, 0x2212, 0x2212, 0x2264, 0x2265, 0};

// ImGui's font size is ascent + descent, not the em.
float imgui_size(Cut cut, float em_px) { return em_px * (cut == Cut::mono ? 1.32f : 1.2102f); }

/// Advance of the widest figure, in em.
float widest_figure_em(Cut cut) {
  stbtt_fontinfo info;
  const File file = file_of(cut);
  if (!stbtt_InitFont(&info, file.begin, 0)) return 0.6541f;
  int widest = 0;
  for (char figure = '0'; figure <= '9'; ++figure) {
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&info, figure, &advance, &bearing);
    widest = std::max(widest, advance);
  }
  return static_cast<float>(widest) * stbtt_ScaleForMappingEmToPixels(&info, 1.0f);
}

ImFont* add(ImFontAtlas& atlas, Cut cut, float em_px, const ImWchar* ranges, bool merge,
            float fixed_advance) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.PixelSnapH = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.MergeMode = merge;
  if (fixed_advance > 0) config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = fixed_advance;
  const File file = file_of(cut);
  return atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(file.begin),
                                    static_cast<int>(file.end - file.begin), imgui_size(cut, em_px), &config,
                                    ranges);
}

}  // namespace

FaceSize size_of(Face face) { return specs[static_cast<std::size_t>(face)].size; }

Fonts::Fonts() : atlas_(std::make_unique<ImFontAtlas>()) {}

void Fonts::build(float scale) {
  atlas_->Clear();
  atlas_->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas_->TexDesiredWidth = scale > 1.5f ? 2048 : 1024;
  scale_ = scale;
  for (const Spec& spec : specs) {
    const float em_px = std::round(spec.size.em * scale);
    ImFont*& font = fonts_[static_cast<std::size_t>(spec.face)];
    if (spec.cut == Cut::mono) {
      font = add(*atlas_, spec.cut, em_px, mono_all, false, 0);
      continue;
    }
    const ImWchar* signs = spec.letters == Letters::figures ? signs_of_digits
                           : spec.size.em >= 20             ? large_but_figures
                                                            : text_but_figures;
    font = add(*atlas_, spec.cut, em_px, signs, false, 0);
    add(*atlas_, spec.cut, em_px, figures, true, widest_figure_em(spec.cut) * em_px);
  }
  atlas_->Build();
}

}  // namespace hw::gui
