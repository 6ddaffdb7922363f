#pragma once
// The console's own messages: a banner for the worst problem, toasts for completed actions, a dialog before
// an action that cannot be undone.
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
  std::string_view brief = {};  ///< shorter label for a narrow window; empty: as `label`
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
/// Draws the banner across the full width of the window. Returns the index of the action clicked in this
/// frame, or -1.
int banner(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions);
/// The height of that banner in this width, both logical.
float banner_height(const Ui& ui, const Banner& what, float width, bool actions);
/// The same banner in one bar that fills the current window: title and aside above the sentences, in small
/// type. `one_line` folds it to one line without the aside. The tip shows a text that was cut.
int banner_bar(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions,
               bool one_line = false);
/// Tints the ground of a row or card, with a bar at its left, from the cursor down `height_px` pixels.
void tinted(Ui& ui, Severity severity, float height_px);

/// Draws the newest message in `place`: mark, sentence, count, age, the number of further messages, and a
/// cross. Narrower than 160 logical pixels it shows only the mark and the number. A press opens the list of
/// all messages. Ids: `toast/NUMBER` (also for the messages behind the newest), `message/strip`,
/// `message/more`, `message/close/NUMBER`.
void draw_messages(Ui& ui, Toasts& toasts, const Rect& place);
/// Call last in a frame. Expires old messages, and draws the list of messages while it is open: beside the
/// strip, inside `within`, without covering the line `status`. Ids: `message/list/NUMBER`,
/// `message/list/NUMBER/close`, `message/close_all`.
void draw_toasts(Ui& ui, Toasts& toasts, const Rect& within, const Rect& status);

struct Dialog {
  std::string_view title;
  std::string_view sentences;
  std::string_view yes;  ///< a verb: "Store in controller"
  std::string_view no = "Cancel";
  bool moving = false;  ///< `yes` can start motion
};
enum class Answer : std::uint8_t { none, yes, no };
/// Draws a modal dialog while `open`. Esc answers no. The focus starts on no, so that an accidental Enter
/// does nothing. Ids: `id/yes`, `id/no`, `id/says`.
Answer dialog(Ui& ui, std::string_view id, bool& open, const Dialog& what);

/// Begins a centred modal window. If it returns true, draw the content, then call end_modal(). Width and
/// height are logical; height 0 takes the height of the content.
bool begin_modal(Ui& ui, std::string_view id, bool open, float width, float height = 0);
void end_modal();

}  // namespace hw::gui
