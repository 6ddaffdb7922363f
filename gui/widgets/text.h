#pragma once
// Text at whole pixels.
#include <string_view>

#include "gui/surface/ui.h"

namespace hw::gui {

/// Width in pixels.
float text_width(const Ui& ui, Face face, std::string_view s);
/// The number of bytes of `s` that fit into `width_px`, cut between characters.
std::size_t text_fit(const Ui& ui, Face face, std::string_view s, float width_px);

/// Draws a text; `at` is the top left corner of its line, in pixels.
void draw_text(const Ui& ui, ImVec2 at, Face face, ImU32 colour, std::string_view s);
/// Draws a text that ends at `right.x`.
void draw_text_right(const Ui& ui, ImVec2 right, Face face, ImU32 colour, std::string_view s);
/// Draws a text in the centre of the rectangle.
void draw_text_centred(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s);
/// Draws a text from `left`, vertically centred on `centre_y`. A text that reaches beyond `right` ends in an
/// ellipsis; the tip shows it whole.
void draw_text_line(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                    std::string_view s);

/// Draws a text in one line of `face` if it fits, else in two lines of small type, cut if still too long.
void draw_text_in_two_lines(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                            std::string_view s);

/// Draws a text from the top of `in` in at most `lines` lines. A longer text is cut; the tip shows it whole.
void draw_text_in_lines(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s, int lines);

/// Draws a text at ImGui's cursor, in a line of the face's height.
void text(Ui& ui, Face face, Tone tone, std::string_view s);
/// Draws a sentence, wrapped into lines of at most `width` (logical; fill: the rest of the line).
void wrapped(Ui& ui, Face face, Tone tone, std::string_view s, float width = fill);
/// The height that wrapped() would take, in pixels.
float wrapped_height(const Ui& ui, Face face, std::string_view s, float width_px);
/// As text(), but registered, so that scripts can read it by its id.
void named_text(Ui& ui, std::string_view id, Face face, Tone tone, std::string_view s);

/// The width in pixels; for `fill` the rest of the line.
float width_px(const Ui& ui, float width);
/// Fills from the left to the right border of the window, across its padding too; `bar`: 3 px at the left.
Rect draw_across(const Ui& ui, float top, float bottom, ImU32 colour, ImU32 bar = 0);
/// Empty space between groups, in logical pixels.
void gap(Ui& ui, float height);
/// A hairline across the full column, with `space` (logical) above and below.
void group_line(Ui& ui, float space = 12);
/// The title of a group in a row of 40 (44 with a control in it), with the caption at its right. The cursor
/// is below the row afterwards.
void section_title(Ui& ui, std::string_view title, std::string_view caption = {}, float height = 40);
/// Key in ink2 at the left, value at the right, in a row of 24.
void key_value(Ui& ui, std::string_view id, std::string_view key, std::string_view value,
               Tone tone = Tone::ink);
/// A tooltip near the mouse, or below `beside` when the focus asked for it.
void tooltip(Ui& ui, std::string_view sentence, const Rect* beside = nullptr);

}  // namespace hw::gui
