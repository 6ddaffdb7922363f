#pragma once
// The typefaces: Inter for text, JetBrains Mono for wire text. There is one atlas for each scale, built from
// fonts inside the binary. All Inter faces have tabular figures.
#include <array>
#include <cstdint>
#include <memory>

#include <imgui.h>

namespace hw::gui {

enum class Face : std::uint8_t {
  small,        ///< Inter 400, 12 em in a line of 16: captions, second lines, reasons
  small_bold,   ///< 600: chips
  body,         ///< Inter 400, 14 in 20: everything else
  body_medium,  ///< 500: buttons
  body_bold,    ///< 600: names, section titles
  title,        ///< Inter 400, 16 in 20: the unit beside digits
  title_bold,   ///< 600: axis name, state word of an axis
  stop,         ///< Inter 600, 20 in 24: STOP ALL
  time,         ///< Inter 500, 20 in 24: rehearsal time
  digits26,     ///< Inter 500, figures only: positions
  digits32,
  digits36,
  digits48,
  code,        ///< JetBrains Mono 400, 14 in 24: editor
  code_field,  ///< 13 in 20: terminal and fields
  code_time,   ///< 12: times
  count
};

/// em and line height in logical pixels.
struct FaceSize {
  float em, line;
};
FaceSize size_of(Face face);

class Fonts {
 public:
  Fonts();
  /// Builds the atlas for `scale` (physical over logical pixels). It must not run during an ImGui frame. It
  /// needs no ImGui context, so it can run while the window opens.
  void build(float scale);
  [[nodiscard]] ImFont* operator[](Face face) const { return fonts_[static_cast<std::size_t>(face)]; }
  [[nodiscard]] float scale() const { return scale_; }
  [[nodiscard]] ImFontAtlas& atlas() const { return *atlas_; }

 private:
  std::unique_ptr<ImFontAtlas> atlas_;
  std::array<ImFont*, static_cast<std::size_t>(Face::count)> fonts_{};
  float scale_ = 0;
};

}  // namespace hw::gui
