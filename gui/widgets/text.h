#pragma once
// Text at whole pixels.
#include <string_view>

#include "gui/surface/ui.h"

namespace hw::gui {

/// Width in pixels.
float text_width(const Ui& ui, Face face, std::string_view s);
/// The number of bytes of `s` that fit into `width_px`, cut between characters.
std::size_t text_fit(const Ui& ui, Face face, std::string_view s, float width_px);

/// At an exact place: `at` is the top left corner of the text's line.
void draw_text(const Ui& ui, ImVec2 at, Face face, ImU32 colour, std::string_view s);
/// Ends at `right.x`.
void draw_text_right(const Ui& ui, ImVec2 right, Face face, ImU32 colour, std::string_view s);
/// Centred in the rectangle.
void draw_text_centred(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s);
/// From `left`, vertically centred on the line `centre_y`; a text too long for `right` ends in an ellipsis,
/// and is shown whole under the mouse.
void draw_text_line(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                    std::string_view s);

/// In one line of `face` if it fits, else in two of small type, cut if still too long.
void draw_text_in_two_lines(const Ui& ui, float left, float right, float centre_y, Face face, ImU32 colour,
                            std::string_view s);

/// From the top of `in`, in the given number of lines; a longer text is cut, and shown whole under the mouse.
void draw_text_in_lines(const Ui& ui, const Rect& in, Face face, ImU32 colour, std::string_view s, int lines);

/// At ImGui's cursor, in a line of the face's height.
void text(Ui& ui, Face face, Tone tone, std::string_view s);
/// A sentence in lines no wider than `width` (logical; fill: the rest).
void wrapped(Ui& ui, Face face, Tone tone, std::string_view s, float width = fill);
/// Height in pixels that wrapped() would take.
float wrapped_height(const Ui& ui, Face face, std::string_view s, float width_px);
/// A text that scripts can read by path: as text(), but registered.
void named_text(Ui& ui, std::string_view id, Face face, Tone tone, std::string_view s);

/// Pixels of the rest of the line for `fill`, else the scaled width.
float width_px(const Ui& ui, float width);
/// Fills from the left to the right border of the window, across its padding too; `bar`: 3 px at the left.
Rect draw_across(const Ui& ui, float top, float bottom, ImU32 colour, ImU32 bar = 0);
/// Empty space between groups, in logical pixels.
void gap(Ui& ui, float height);
/// Hairline across the full column, with `space` above and below.
void group_line(Ui& ui, float space = 12);
/// Title of a group in a row of 40 (44 with a control in it); leaves the cursor below. The caption is at the
/// right.
void section_title(Ui& ui, std::string_view title, std::string_view caption = {}, float height = 40);
/// Key in ink2 at the left, value at the right, in a row of 24.
void key_value(Ui& ui, std::string_view id, std::string_view key, std::string_view value,
               Tone tone = Tone::ink);
/// Tooltip near the mouse, or under `beside` when requested by the focus.
void tooltip(Ui& ui, std::string_view sentence, const Rect* beside = nullptr);

}  // namespace hw::gui
