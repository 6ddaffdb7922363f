#pragma once
// Buttons. Only buttons that can start motion have the cyan edge.
#include <string_view>

#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

enum class ButtonStyle : std::uint8_t {
  normal,    ///< raised
  primary,   ///< ink fill: at most one button on a screen
  quiet,     ///< text only: Open, Save; `hover` fill under the mouse
  outlined,  ///< `edge` outline without fill
  danger,    ///< `fault` outline: Stop
  segment,   ///< part of a list of choices: quiet, `sel` and `edge` when on
};

struct ButtonOptions {
  ButtonStyle style = ButtonStyle::normal;
  Icon icon = Icon::none;
  Tone icon_tone = Tone::ink;  ///< colour of `icon` while enabled; ink: as the label
  Icon icon_after = Icon::none;
  std::string_view keys = {};      ///< key hint in ink3: "F5"; "ctrl \n" draws the Enter sign
  std::string_view disabled = {};  ///< why it is disabled, and until when; empty: enabled
  std::string_view tip = {};
  float width = 0;        ///< logical; 0 natural, `fill` the rest of the line
  float height = 32;      ///< logical; 32 or 40; 28 in rows (the whole row height takes the press)
  bool moving = false;    ///< can start motion
  bool stops = false;     ///< a Stop
  bool on = false;        ///< chosen: `sel` and `edge`
  bool wordless = false;  ///< only the icon is drawn; scripts still read the label
};

Touch button(Ui& ui, std::string_view id, std::string_view label, const ButtonOptions& options = {});
/// Natural width in logical pixels, for layouts from the right.
float button_width(const Ui& ui, std::string_view label, const ButtonOptions& options = {});
/// Underlined small text within a line: "Show".
bool link(Ui& ui, std::string_view id, std::string_view label, std::string_view disabled = {});
/// STOP ALL, of the given size in pixels. It is never disabled. `clicked` is set when the button is pressed,
/// not released, even while a dialog or list is open. `second`: a second line, "does not reach 03".
Touch stop_button(Ui& ui, ImVec2 size, std::string_view second = {});

}  // namespace hw::gui
