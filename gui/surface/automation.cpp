#include "gui/surface/automation.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace hw::gui {
namespace {

std::string quoted(std::string_view id) { return "'" + std::string(id) + "'"; }

tl::unexpected<Fault> refuse(std::string what, std::string advice = {}) {
  return fail(FaultKind::refused, std::move(what), {}, std::move(advice));
}

unsigned next_code_point(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  unsigned code = length == 1 ? lead : lead & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length && i < text.size(); ++i)
    code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  text.remove_prefix(std::min(length, text.size()));
  return code;
}

}  // namespace

Automation::Automation(Surface& surface, std::function<void()> run_frame, std::function<double()> now_s,
                       std::function<bool()> over)
    : surface_(surface), run_frame_(std::move(run_frame)), now_s_(std::move(now_s)), over_(std::move(over)) {}

void Automation::frame(int n) {
  for (int i = 0; i < n && !over_(); ++i) run_frame_();
}

void Automation::take_input() {
  do frame();
  while (surface_.screen().more_input() && !over_());
}

/// Draws frames until all input is handled, and one more frame to show the effects.
void Automation::settle() {
  take_input();
  frame();
}

Result<> Automation::usable(std::string_view id) {
  const Widget* w = surface_.screen().registry().find(id);
  if (!w)
    return refuse("There is no widget " + quoted(id) + " on the screen.",
                  "ui.list() lists those on the screen.");
  if (!w->enabled) {
    const std::string why = w->reason.empty() ? "." : ": " + std::string(w->reason);
    return refuse(quoted(id) + " is disabled" + why);
  }
  return {};
}

/// A button that can start motion accepts a press only after it has been in its place for a while: see
/// press_guard.h.
Result<> Automation::wait_until_settled(std::string_view id) {
  constexpr int frames_at_most = 90;
  for (int n = 0; n < frames_at_most && !over_(); ++n) {
    if (Result<> ok = usable(id); !ok) return ok;
    const Widget* w = surface_.screen().registry().find(id);
    if (!w->moving || now_s_() - w->settled_since_s >= settle_time_s) return {};
    frame();
  }
  const Widget* w = surface_.screen().registry().find(id);
  if (w && w->layer < surface_.screen().registry().top_layer()) return {};  // covered: press() reports it
  return refuse(quoted(id) + " is moving on the screen, so a press on it would not be taken.");
}

/// Brings the widget into view and moves the mouse over it.
Result<const Widget*> Automation::reach(std::string_view id) {
  Registry& registry = surface_.screen().registry();
  const Widget* drawn = registry.find(id);
  if (!drawn || !drawn->enabled)
    frame();  // the last frame may be older than the event that the script has waited for
  if (Result<> ok = usable(id); !ok) return fail(ok.error());
  if (!registry.find(id)->in_view()) {
    registry.scroll_to(id);
    frame(3);
    if (Result<> ok = usable(id); !ok) return fail(ok.error());
    if (!registry.find(id)->in_view())
      return refuse(quoted(id) + " is out of view and cannot be scrolled into it.",
                    "Make the window larger.");
  }
  if (Result<> ok = wait_until_settled(id); !ok) return fail(ok.error());
  // Moves the pointer again if an earlier action has moved the widget away.
  constexpr int moves_at_most = 8;
  for (int n = 0; n < moves_at_most; ++n) {
    const ImVec2 at = registry.find(id)->rect.centre();
    point_at(at);
    if (Result<> ok = usable(id); !ok) return fail(ok.error());
    const ImVec2 now = registry.find(id)->rect.centre();
    if (now.x == at.x && now.y == at.y) break;
  }
  if (const Widget* cut = registry.find(id); !cut->hovered && !cut->wholly_in_view()) {
    // Half of the widget is out of view, and a splitter beside the view covers the rest.
    registry.scroll_to(id);
    frame(3);
    if (Result<> ok = wait_until_settled(id); !ok) return fail(ok.error());
    point_at(registry.find(id)->rect.centre());
    if (Result<> ok = usable(id); !ok) return fail(ok.error());
  }
  const Widget* w = registry.find(id);
  if (!w->hovered)
    return refuse(quoted(id) + " is covered by something else: a dialog, a list or a message.");
  return w;
}

void Automation::point_at(ImVec2 at) {
  surface_.screen().input().push(InputEvent::mouse_move(at.x, at.y, now_s_()));
  frame();
  frame();
}

void Automation::push_button(bool down) {
  InputQueue& input = surface_.screen().input();
  input.push(InputEvent::mouse_button(0, down, input.pointer(), now_s_()));
}

Result<> Automation::press(std::string_view id) {
  const auto widget = reach(id);
  if (!widget) return fail(widget.error());
  push_button(true);
  frame();
  pressed_ = id;
  return {};
}

Result<> Automation::release(std::string_view id) {
  if (pressed_ != id) return refuse(quoted(id) + " is not pressed.", "ui.press() comes first.");
  pressed_.clear();
  push_button(false);
  settle();
  return {};
}

Result<> Automation::drag(std::string_view id, std::string_view onto, float share) {
  const auto widget = reach(id);
  if (!widget) return fail(widget.error());
  push_button(true);
  frame();
  const auto put_down = [this] { push_button(false), settle(); };
  if (Result<> ok = usable(onto); !ok) return put_down(), ok;
  const Rect to = surface_.screen().registry().find(onto)->rect;
  if (!surface_.screen().registry().find(onto)->in_view())
    return put_down(), refuse(quoted(onto) + " is out of view: nothing can be dragged there.");
  point_at(ImVec2(to.centre().x, to.min.y + share * to.height()));
  put_down();
  return {};
}

Result<> Automation::click(std::string_view id) {
  const auto widget = reach(id);
  if (!widget) return fail(widget.error());
  push_button(true);
  frame();
  push_button(false);
  settle();
  return {};
}

void Automation::tap(int key) {
  InputQueue& input = surface_.screen().input();
  input.push(InputEvent::key(key, true, now_s_()));
  input.push(InputEvent::key(key, false, now_s_()));
}

void Automation::push_text(std::string_view text) {
  InputQueue& input = surface_.screen().input();
  while (!text.empty()) {
    const unsigned code = next_code_point(text);
    if (code == '\n')
      tap(GLFW_KEY_ENTER);
    else if (code == '\t')
      tap(GLFW_KEY_TAB);
    else
      input.push(InputEvent::text(code, now_s_()));
  }
}

Result<> Automation::type(std::string_view id, std::string_view text) {
  const auto widget = reach(id);
  if (!widget) return fail(widget.error());
  const Kind kind = (*widget)->kind;
  if (kind != Kind::field && kind != Kind::editor)
    return refuse(quoted(id) + " is a " + std::string(name_of(kind)) + ": nothing can be typed into it.");
  if (Result<> clicked = click(id); !clicked) return clicked;
  if (kind == Kind::field) {
    if (Result<> all = key("Ctrl+A"); !all) return all;
  } else if (Result<> end = key("Ctrl+End"); !end) {
    return end;
  }
  if (text.empty() || text[0] == '\n') {
    if (kind == Kind::field) tap(GLFW_KEY_DELETE);
  }
  push_text(text);
  settle();
  return {};
}

Result<> Automation::key_down(std::string_view text) {
  const Result<Chord> chord = read_chord(text);
  if (!chord) return fail(chord.error());
  InputQueue& input = surface_.screen().input();
  const double now = now_s_();
  if (chord->ctrl) input.push(InputEvent::key(GLFW_KEY_LEFT_CONTROL, true, now));
  if (chord->shift) input.push(InputEvent::key(GLFW_KEY_LEFT_SHIFT, true, now));
  if (chord->alt) input.push(InputEvent::key(GLFW_KEY_LEFT_ALT, true, now));
  input.push(InputEvent::key(chord->key, true, now));
  if (chord->text) input.push(InputEvent::text(chord->text, now));
  take_input();
  return {};
}

Result<> Automation::key_up(std::string_view text) {
  const Result<Chord> chord = read_chord(text);
  if (!chord) return fail(chord.error());
  InputQueue& input = surface_.screen().input();
  const double now = now_s_();
  input.push(InputEvent::key(chord->key, false, now));
  if (chord->alt) input.push(InputEvent::key(GLFW_KEY_LEFT_ALT, false, now));
  if (chord->shift) input.push(InputEvent::key(GLFW_KEY_LEFT_SHIFT, false, now));
  if (chord->ctrl) input.push(InputEvent::key(GLFW_KEY_LEFT_CONTROL, false, now));
  settle();
  return {};
}

Result<> Automation::key(std::string_view chord) {
  if (Result<> down = key_down(chord); !down) return down;
  return key_up(chord);
}

Result<std::string> Automation::value(std::string_view id) {
  frame();
  const Widget* w = surface_.screen().registry().find(id);
  if (!w)
    return refuse("There is no widget " + quoted(id) + " on the screen.",
                  "ui.list() lists those on the screen.");
  return std::string(w->value);
}

bool Automation::exists(std::string_view id) {
  frame();
  return surface_.screen().registry().find(id) != nullptr;
}

std::vector<Automation::Listed> Automation::list() {
  frame();
  std::vector<Listed> all;
  const float scale = surface_.screen().scale();
  for (const Widget& w : surface_.screen().registry().widgets())
    all.push_back(Listed{std::string(w.id), std::string(name_of(w.kind)), std::string(w.label),
                         std::string(w.value), w.rect.min.x / scale, w.rect.min.y / scale,
                         w.rect.width() / scale, w.rect.height() / scale, w.enabled, w.moving});
  return all;
}

Result<> Automation::screenshot(const std::string& path) {
  frame();
  return surface_.screenshot(path);
}

Result<> Automation::window(int width, int height, float scale) {
  if (width < 320 || height < 240 || width > 16384 || height > 16384 || !(scale >= 0.5f && scale <= 4.0f))
    return refuse("A window of " + std::to_string(width) + " x " + std::to_string(height) + " at scale " +
                      std::to_string(scale) + " is not possible.",
                  "Widths from 320, heights from 240, scales from 0.5 to 4.");
  surface_.resize(width, height, scale);
  frame(3);
  return {};
}

Result<> Automation::theme(std::string_view name) {
  if (name != "dark" && name != "light")
    return refuse("There is no theme " + quoted(name) + ".", "There are \"dark\" and \"light\".");
  surface_.screen().set_theme(name == "dark");
  frame(2);
  return {};
}

void Automation::lose_focus() {
  surface_.screen().input().push(InputEvent::focus_lost(now_s_()));
  settle();
}

}  // namespace hw::gui
