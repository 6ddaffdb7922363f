#pragma once
// The console's own messages: a banner for the worst fact, toasts for what was done, a dialog before anything
// that cannot be undone.
#include <span>
#include <string_view>

#include "gui/model/severity.h"
#include "gui/model/toasts.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct SeverityMark {
  Tone ink, tint;
  Icon icon;
};
SeverityMark severity_mark(Severity severity);

struct Action {
  std::string_view id, label;
  std::string_view brief = {};  ///< label where there is little room; empty: as `label`
  std::string_view disabled = {};
  bool main = false;  ///< a raised button; others are quiet
  bool moving = false;
};
struct Banner {
  Severity severity = Severity::fault;
  Icon icon = Icon::diamond_solid;
  std::string_view title;
  std::string_view sentences;   ///< lines broken by '\n'
  std::string_view aside = {};  ///< beside the actions: "Attempt 5 in 3 s."
  std::string_view brief = {};  ///< text for a bar; empty: as much of `sentences` as fits
};
/// Across the full width of the window, bar 3. Returns the index of the action just clicked, or -1.
int banner(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions);
/// Height of that banner in this width, logical.
float banner_height(const Ui& ui, const Banner& what, float width, bool actions);
/// The same in one bar that fills the current window: title and aside over the sentences, in small type, or
/// folded to one line without the aside; a cut text is shown whole under the mouse.
int banner_bar(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions,
               bool one_line = false);
/// Tints a row or card and its bar at the left, from the cursor down `height_px`; draws nothing else.
void tinted(Ui& ui, Severity severity, float height_px);

/// The newest message in `place`, for any view with room for it: mark, sentence, count, age, number of
/// further messages, and a cross; in a width below 160 only its mark and their number. A press opens the list
/// of all. Ids: `toast/NUMBER` (also for the messages behind the newest), `message/strip`, `message/more`,
/// `message/close/NUMBER`.
void draw_messages(Ui& ui, Toasts& toasts, const Rect& place);
/// Last in a frame: expires messages, and draws their list while it is open: by the strip, in `within`,
/// covering nothing of the line `status`. Ids: `message/list/NUMBER`, `message/list/NUMBER/close`,
/// `message/close_all`.
void draw_toasts(Ui& ui, Toasts& toasts, const Rect& within, const Rect& status);

struct Dialog {
  std::string_view title;
  std::string_view sentences;
  std::string_view yes;  ///< a verb: "Store in controller"
  std::string_view no = "Cancel";
  bool moving = false;  ///< `yes` can start motion
};
enum class Answer : std::uint8_t { none, yes, no };
/// Modal while `open`; Esc is no. The focus is on no, so an accidental Enter does nothing.
/// Ids: `id/yes`, `id/no`, `id/says`.
Answer dialog(Ui& ui, std::string_view id, bool& open, const Dialog& what);

/// The frame of a modal window, centred; true: draw its content, then end_modal(). Width and height logical;
/// height 0: the height of its content.
bool begin_modal(Ui& ui, std::string_view id, bool open, float width, float height = 0);
void end_modal();

}  // namespace hw::gui
