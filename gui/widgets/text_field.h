#pragma once
// A line of text. The panel owns the text. Typed text is kept when the field loses the focus. The panel may
// set the text at any time, even while the field has the caret.
#include <functional>
#include <string>
#include <string_view>

#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

/// Handles Up, Down and Tab while the user types into a field, as in the terminal. Each function returns true
/// when it changed `text`.
struct LineHelp {
  std::function<bool(std::string& text, int direction)> history;         ///< -1 older, +1 newer
  std::function<bool(std::string& text, std::size_t& cursor)> complete;  ///< Tab
};

struct FieldOptions {
  std::string_view disabled = {};
  std::string_view tip = {};
  std::string_view unit = {};         ///< in ink3 at the right inside
  std::string_view placeholder = {};  ///< shown while empty
  std::string_view hint = {};         ///< behind the caret while typing: the effect of Enter
  Icon prompt = Icon::none;
  Face face = Face::body;  ///< code_field for wire text
  float width = fill, height = 32;
  bool right = false;  ///< right aligned: numbers
  bool whole = false;  ///< a double click selects the whole text, not a word
  bool error = false;
  bool changed = false;  ///< ink outline, value 600
  bool stale = false;
  bool keep_focus = false;  ///< after Enter: the terminal keeps the caret
  bool password = false;
  const LineHelp* help = nullptr;
};

struct Field {
  Touch touch;
  bool typing = false;   ///< has the caret now
  bool edited = false;   ///< the text changed in this frame
  bool entered = false;  ///< Enter
  bool left = false;     ///< lost the caret in this frame
};

Field text_field(Ui& ui, std::string_view id, std::string_view label, std::string& text,
                 const FieldOptions& options = {});

/// Gives the field the caret in the next frame that draws it.
inline void type_into(Ui& ui, std::string_view id) { ui.focus.move_to(id); }

}  // namespace hw::gui
