#include "gui/shell/dialogs.h"

#include <algorithm>
#include <span>

#include <fmt/core.h>

#include "gui/model/goes_on.h"
#include "gui/shell/console.h"
#include "gui/surface/ui.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"

namespace hw::gui {
namespace {

constexpr float width = 440;

void title(Ui& ui, std::string_view words) {
  text(ui, Face::title_bold, Tone::ink, words);
  gap(ui, 8);
}

/// Draws a label with a field at its right.
Field labelled_field(Ui& ui, std::string_view id, std::string_view label, std::string& text_of,
                     std::string_view placeholder) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(120), at.y + ui.px(16), Face::body, ui[Tone::ink2], label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(128), at.y));
  FieldOptions options;
  options.placeholder = placeholder;
  return text_field(ui, id, label, text_of, options);
}

struct Choice {
  std::string_view id, label;
  ButtonStyle style = ButtonStyle::normal;
  bool moving = false;
};

/// Draws the buttons of a dialog, right aligned, the safe button first. Returns the index of the button
/// pressed in this frame, or -1.
int draw_choices(Ui& ui, std::span<const Choice> choices) {
  float all = 0;
  for (const Choice& c : choices)
    all += button_width(ui, c.label, {.style = c.style, .moving = c.moving}) + 8;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(
      ImVec2(at.x + std::max(0.0f, ImGui::GetContentRegionAvail().x - ui.px(all - 8)), at.y));
  int pressed = -1;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, ui.px(8));
    const ButtonOptions options{.style = choices[i].style, .moving = choices[i].moving};
    if (button(ui, choices[i].id, choices[i].label, options).clicked) pressed = static_cast<int>(i);
  }
  return pressed;
}

// ---- effects of closing a tab or window

/// The tabs that are closed together with this tab, itself included.
std::vector<Tab*> closed_with(Tab& tab) { return tab.bus ? tab.bus->members : std::vector<Tab*>(1, &tab); }

bool any_goes_on(std::span<Tab* const> tabs) {
  return std::any_of(tabs.begin(), tabs.end(), [](const Tab* tab) { return goes_on(*tab); });
}

/// Names the unsaved data of panels, and its controller if there are several.
std::string unsaved_of(std::span<Tab* const> tabs) {
  std::string all;
  for (const Tab* tab : tabs) {
    const std::string what = tab->panels.unkept();
    if (what.empty()) continue;
    if (!all.empty()) all += ' ';
    all += tabs.size() > 1 ? fmt::format("{}: {}", tab->name(), what) : what;
  }
  return all;
}

}  // namespace

void Dialogs::begin(Kind kind, Tab& tab) {
  kind_ = kind;
  tab_ = &tab;
  just_opened_ = true;
}

void Dialogs::names(Tab& tab) {
  begin(Kind::names, tab);
  name_ = tab.bus ? tab.bus->members.front()->settings.profile.bus_name : tab.settings.profile.name;
  axis_names_.clear();
  for (std::size_t i = 0; i < tab.catalog().axes.size(); ++i)
    axis_names_.push_back(tab.settings.profile.axes[i].name);
}

bool Dialogs::ask_to_close(Console& console, Kind kind, Tab* tab, std::vector<Tab*> closed) {
  closed_ = std::move(closed);
  if (kind_ == kind && tab_ == tab) {  // a second request while the question is open: stop and close
    leave(console, true);
    return false;
  }
  goes_on_ = any_goes_on(closed_);
  unkept_ = unsaved_of(closed_);
  if (!goes_on_ && unkept_.empty()) return false;
  begin(kind, *tab);
  words_height_ = 0;
  return true;
}

/// Acts on the answer. The caller closes the dialog.
void Dialogs::leave(Console& console, bool stopped) {
  if (stopped) stop_running(closed_);
  console.note_unreached(
      closed_, kind_ == Kind::end ? "the window was closed" : fmt::format("{} was closed", tab_->name()));
  close();
}

void Dialogs::close_controller(Console& console, Tab& tab) {
  if (!ask_to_close(console, Kind::close_controller, &tab, closed_with(tab))) console.close(tab);
}

bool Dialogs::may_end(Console& console) {
  std::vector<Tab*> all;
  for (const auto& tab : console.tabs()) all.push_back(tab.get());
  Tab* first = all.empty() ? nullptr : all.front();
  return !ask_to_close(console, Kind::end, first, std::move(all));
}

Tab* Dialogs::closing() const { return kind_ == Kind::close_controller ? tab_ : nullptr; }

void Dialogs::reset(Tab& tab) { begin(Kind::reset, tab); }

bool Dialogs::make_room(Tab& tab, std::vector<int> slots) {
  if (open() || slots.empty()) return false;
  begin(Kind::make_room, tab);
  slots_ = std::move(slots);
  return true;
}

bool Dialogs::closing(Tab& tab, FollowedIntents::Question question) {
  if (open()) return false;
  begin(Kind::closing, tab);
  question_ = std::move(question);
  return true;
}

void Dialogs::draw(Ui& ui, Console& console) {
  if (!begin_modal(ui, "dialog", open(), width + 48)) return;
  if (ui.cancelled() && !just_opened_) close();
  switch (kind_) {
    case Kind::names: draw_names(ui, console); break;
    case Kind::close_controller:
    case Kind::end: draw_close(ui, console); break;
    case Kind::reset: draw_reset(ui); break;
    case Kind::make_room: draw_make_room(ui, console); break;
    case Kind::closing: draw_closing(ui); break;
    case Kind::none: break;
  }
  just_opened_ = false;
  if (kind_ == Kind::none) ImGui::CloseCurrentPopup();
  end_modal();
}

void Dialogs::draw_names(Ui& ui, Console& console) {
  title(ui, "Names");
  wrapped(ui, Face::small, Tone::ink2, "For the screen only. The controller does not know them.");
  gap(ui, 12);
  if (just_opened_) type_into(ui, "names/controller");
  const std::string& unnamed = tab_->bus ? tab_->bus->default_name : tab_->catalog().short_name;
  bool done =
      labelled_field(ui, "names/controller", tab_->bus ? "Bus" : "Controller", name_, unnamed).entered;
  for (std::size_t i = 0; i < axis_names_.size(); ++i) {
    const AxisInfo& axis = tab_->catalog().axes[i];
    gap(ui, 4);
    const std::string label = axis.description.empty() ? "Axis " + axis.name : axis.description;
    done |= labelled_field(ui, "names/" + axis.name, label, axis_names_[i], "across, lift, turn ...").entered;
  }
  gap(ui, 12);
  static constexpr Choice choices[] = {{"names/cancel", "Cancel", ButtonStyle::outlined},
                                       {"names/ok", "Use these names", ButtonStyle::primary}};
  const int pressed = draw_choices(ui, choices);
  if (pressed == 0) close();
  if (!done && pressed != 1) return;
  for (std::size_t i = 0; i < axis_names_.size(); ++i) tab_->settings.profile.axes[i].name = axis_names_[i];
  tab_->settings.edited();
  console.rename(*tab_, name_);
  close();
}

std::string Dialogs::why_asked() const {
  std::string what;
  if (goes_on_) what = kind_ == Kind::end ? goes_on_unwatched(closed_) : goes_on_unwatched(*tab_);
  if (unkept_.empty()) return what;
  return what.empty() ? unkept_ + " Closing loses it."
                      : fmt::format("{} {} Closing loses it.", what, unkept_);
}

/// Draws the question before closing a controller or the window. Enter means stay. The buttons keep their
/// places when the motion ends meanwhile.
void Dialogs::draw_close(Ui& ui, Console& console) {
  title(ui, kind_ == Kind::end ? "Close the window?" : fmt::format("Close {}?", tab_->name()));
  goes_on_ = goes_on_ || any_goes_on(closed_);
  const std::string why = why_asked();
  const float height = wrapped_height(ui, Face::body, why, ImGui::GetContentRegionAvail().x);
  words_height_ = std::max(words_height_, height);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::body, Tone::ink2, why);
  show(ui, {.id = "close/why", .kind = gui::Kind::text, .label = "Why it is asked", .value = why},
       {at, ImVec2(at.x + ImGui::GetContentRegionAvail().x, at.y + height)});
  if (goes_on_)
    text(ui, Face::small, Tone::ink3, "Close again with the same key or button to stop and close.");
  gap(ui, 12 + (words_height_ - height) / ui.scale);
  if (just_opened_) ui.focus.move_to("close/cancel");
  static constexpr Choice stay{"close/cancel", "Stay", ButtonStyle::outlined};
  const bool several = closed_.size() > 1;
  const Choice of_motion[] = {stay,
                              {"close/leave", several ? "Close, let them run" : "Close, let it run"},
                              {"close/stop", several ? "Stop all and close" : "Stop it and close"}};
  static constexpr Choice of_texts[] = {stay, {"close/lose", "Close anyway"}};
  const int pressed =
      goes_on_ ? draw_choices(ui, std::span<const Choice>(of_motion)) : draw_choices(ui, of_texts);
  if (pressed < 0) return;
  if (pressed == 0) return close();
  const bool whole = kind_ == Kind::end;
  leave(console, pressed == 2);
  if (whole)
    console.end();
  else
    console.close(*tab_);
}

void Dialogs::draw_reset(Ui& ui) {
  const Snapshot& now = tab_->now();
  title(ui, fmt::format("Reset {}?", tab_->bus
                                         ? tab_->id()
                                         : tab_->name()));  // the other controllers of the bus are not reset
  std::string what =
      "A reset acts like switching the power off and on: the controller stops, and its positions start from "
      "zero.";
  if (now.unsaved_setup || now.unsaved_programs)
    what += " Store first to keep unsaved data: data that is only in RAM is lost.";
  wrapped(ui, Face::body, Tone::ink2, what);
  gap(ui, 12);
  static constexpr Choice choices[] = {{"reset/cancel", "Cancel", ButtonStyle::outlined},
                                       {"reset/ok", "Reset it"}};
  const int pressed = draw_choices(ui, choices);
  if (pressed == 1) tab_->send_followed(intent::Reset());
  if (pressed >= 0) close();
}

void Dialogs::draw_make_room(Ui& ui, Console& console) {
  const ProgramFacts& facts = tab_->catalog().program;
  const Snapshot& now = tab_->now();
  title(ui, "Which program may be emptied?");
  wrapped(ui, Face::body, Tone::ink2,
          "Choose a program: a move of the console needs an empty program for its duration, and all programs "
          "hold commands. The text of the chosen program is loaded into the editor first.");
  gap(ui, 12);
  int chosen = -1;
  for (const int slot : slots_) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string name = fmt::format("{} {}", facts.slot_word, slot);
    const std::string use =
        fmt::format("{}, {} of {} {}", name, now.slot_bytes_used[static_cast<std::size_t>(slot)],
                    facts.capacity, facts.capacity_unit);
    const std::string words = "Empty " + name, id = fmt::format("room/{}", slot);
    const float wide = button_width(ui, words);
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    draw_text_line(ui, at.x, right - ui.px(wide + 8), at.y + ui.px(16), Face::body, ui[Tone::ink], use);
    ImGui::SetCursorScreenPos(ImVec2(right - ui.px(wide), at.y));
    if (button(ui, id, words).clicked) chosen = slot;
    gap(ui, 4);
  }
  gap(ui, 8);
  static constexpr Choice choices[] = {{"room/cancel", "Leave all unchanged", ButtonStyle::outlined}};
  if (draw_choices(ui, choices) == 0) close();
  if (chosen < 0) return;
  close();
  console.show_panel("program");  // the panel gets the text and shows the outcome
  Desk& desk = tab_->desk();
  desk.programs.job.begin(ProgramJob::Goal::make_room, chosen, desk.programs.texts, now, tab_->catalog(),
                          [this](IntentBody body) { return tab_->send(std::move(body)); });
}

void Dialogs::draw_closing(Ui& ui) {
  title(ui, "Drive the axis to its command?");
  wrapped(ui, Face::body, Tone::ink2, question_->sentence);
  gap(ui, 12);
  static constexpr Choice choices[] = {
      {"closing/cancel", "Cancel", ButtonStyle::outlined},
      {"closing/drive", "Drive it there", ButtonStyle::normal, true},
      {"closing/stay", "Take this position as its command", ButtonStyle::primary}};
  const int pressed = draw_choices(ui, choices);
  if (pressed < 0) return;
  close();
  if (pressed == 0) return;
  *closing_of(question_->body) = pressed == 1 ? intent::Closing::drive : intent::Closing::stay;
  tab_->send_followed(std::move(question_->body));
}

}  // namespace hw::gui
