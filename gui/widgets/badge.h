#pragma once
// Marks that are never clicked: EMULATED, UNTRUSTED, "02 is slow", "stop guaranteed by: host".
#include <string_view>

#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

enum class BadgeTone : std::uint8_t { emulated, ok, warn, fault, motion };
/// A badge 20 logical pixels high, with tint, colour, shape and word.
void badge(Ui& ui, std::string_view id, BadgeTone tone, Icon icon, std::string_view words,
           std::string_view tip = {});
float badge_width(const Ui& ui, Icon icon, std::string_view words);

/// The EMULATED badge has a shape and a word; where it is too narrow, only the word, then only the shape.
enum class EmulatedForm : std::uint8_t { whole, word, shape };
EmulatedForm emulated_form(const Ui& ui, float room_px);
float emulated_width(const Ui& ui, EmulatedForm form);
void emulated_badge(Ui& ui, std::string_view id, EmulatedForm form = EmulatedForm::whole);

}  // namespace hw::gui
