#pragma once
// What the console says by itself: a banner for the worst that is true, toasts for what was done, a dialog
// before what cannot be undone.
#include <span>
#include <string_view>

#include "gui/model/mood.h"
#include "gui/model/toasts.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct MoodMark {
  Tone ink, tint;
  Icon icon;
};
MoodMark mood_mark(Mood mood);

struct Action {
  std::string_view id, label;
  std::string_view brief = {};  ///< label where there is little room; empty: the same
  std::string_view disabled = {};
  bool main = false;  ///< a raised button; others are quiet
  bool moving = false;
};
struct Banner {
  Mood mood = Mood::fault;
  Icon icon = Icon::diamond_solid;
  std::string_view title;
  std::string_view sentences;   ///< lines broken by '\n'
  std::string_view aside = {};  ///< beside the actions: "Attempt 5 in 3 s."
};
/// Across the full width of the window, bar 3. Returns the index of the action just clicked, or -1.
int banner(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions);
/// Of the same banner, logical, in that width.
float banner_height(const Ui& ui, const Banner& what, float width, bool actions);
/// The same in one bar that fills the current window: title and aside over the sentences, in small type; what
/// is cut is told whole under the mouse.
int banner_bar(Ui& ui, std::string_view id, const Banner& what, std::span<const Action> actions);
/// Tint of a row or card with its bar at the left, from the cursor down `height` pixels; draws nothing else.
void tinted(Ui& ui, Mood mood, float height_px);

/// The newest message in `place`, for whoever has room for it beside all else: mark, sentence, how often,
/// age, how many more stand, and a cross; in less than 160 its mark and their number. A press opens the list
/// of all. Ids: `toast/NUMBER` (those that wait behind the newest too), `message/strip`, `message/more`,
/// `message/close/NUMBER`.
void draw_messages(Ui& ui, Toasts& toasts, const Rect& place);
/// Last in a frame: lets the time of messages pass, and draws their list while it is open: by the strip, in
/// `within`, over nothing of the line `status`. Ids: `message/list/NUMBER`, `message/list/NUMBER/close`,
/// `message/close_all`.
void draw_toasts(Ui& ui, Toasts& toasts, const Rect& within, const Rect& status);

struct Dialog {
  std::string_view title;
  std::string_view sentences;
  std::string_view yes;  ///< a verb: "Store in controller"
  std::string_view no = "Cancel";
  bool moving = false;  ///< yes can start motion
};
enum class Answer : std::uint8_t { none, yes, no };
/// Modal while `open`; Esc is no. The focus stands on no, so Enter by accident does nothing.
/// Ids: `id/yes`, `id/no`, `id/says`.
Answer dialog(Ui& ui, std::string_view id, bool& open, const Dialog& what);

/// The frame of a modal window, centred; true: draw its content, then end_modal(). Width and height logical;
/// height 0: as its content needs.
bool begin_modal(Ui& ui, std::string_view id, bool open, float width, float height = 0);
void end_modal();

}  // namespace hw::gui
