#include "panels/jog/guard_offer.h"

#include <algorithm>

#include <imgui.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float guard_words_width = 432;

/// Calls `act` for the devices that the pad jogs.
template <class Act>
void for_each_device(Frame& f, Act act) {
  if (!f.tab.bus) return act(f.tab);
  for (Tab* member : f.tab.bus->members) act(*member);
}

/// The device with the weakest guard.
Tab& weakest(Frame& f) {
  Tab* found = &f.tab;
  for_each_device(f, [&](Tab& tab) {
    if (tab.now().jog_guard.state < found->now().jog_guard.state) found = &tab;
  });
  return *found;
}

bool some_axis_moves(Frame& f) {
  bool moves = false;
  for_each_device(f, [&](Tab& tab) { moves = moves || tab.now().any_axis_moving(); });
  return moves;
}

std::string_view guard_state(const Tab& tab) {
  switch (tab.now().jog_guard.state) {
    case JogGuard::State::absent: return "The guard is not installed. The program memory is empty.";
    case JogGuard::State::no_room:
      return "Save and clear the program in the program memory if this guard is to replace it.";
    case JogGuard::State::installed: break;
    case JogGuard::State::unknown: return "The program memory is read while the axes are at rest.";
  }
  return {};
}

std::string_view why_not(Frame& f) {
  if (!f.connected()) return f.no_link();
  if (some_axis_moves(f)) return "Stop the axes first.";
  const Tab& tab = weakest(f);
  const bool may = tab.now().jog_guard.state == JogGuard::State::absent ||
                   tab.now().jog_guard.state == JogGuard::State::installed;
  return may ? std::string_view() : guard_state(tab);
}

}  // namespace

void GuardOffer::draw(Frame& f) {
  if (!open_) return;
  Ui& ui = f.ui;
  if (!begin_modal(ui, "jog/guard", open_, guard_words_width + 48)) return;
  if (ImGui::IsWindowAppearing()) ui.focus.move_to("jog/guard/close");
  const JogGuardFacts& facts = f.catalog.jog_guard;
  const bool installed = weakest(f).now().jog_guard.state == JogGuard::State::installed;
  text(ui, Face::title_bold, Tone::ink, "Let the controller watch the line");
  gap(ui, 8);
  for (const std::string* part : {&facts.what, &facts.where, &facts.doubt}) {
    wrapped(ui, Face::body, Tone::ink2, *part, guard_words_width);
    gap(ui, 8);
  }
  const Path silence("The guard is installed, and stops a held jog after a silence of {} ms.",
                     f.now.jog_guard.silence.count());
  const std::string_view state = installed ? silence.view() : guard_state(weakest(f));
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::body_bold, Tone::ink, state, guard_words_width);
  show(ui, {"jog/guard/state", Kind::text, "Guard", state},
       {from, ImVec2(from.x + ui.px(guard_words_width), ImGui::GetCursorScreenPos().y)});
  gap(ui, 16);
  draw_buttons(f, installed);
  end_modal();
}

void GuardOffer::draw_buttons(Frame& f, bool installed) {
  Ui& ui = f.ui;
  const std::string_view verb = installed ? "Remove it" : "Install it";
  const ButtonOptions close{.style = ButtonStyle::outlined};
  const ButtonOptions act{.style = ButtonStyle::primary, .disabled = why_not(f)};
  const float both = ui.px(button_width(ui, "Close", close) + button_width(ui, verb, act) + 8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + std::max(0.0f, ImGui::GetContentRegionAvail().x - both), at.y));
  bool done = button(ui, "jog/guard/close", "Close", close).clicked || ui.cancelled();
  ImGui::SameLine();
  if (button(ui, installed ? "jog/guard/remove" : "jog/guard/install", verb, act).clicked) {
    const JogGuard::State from = installed ? JogGuard::State::installed : JogGuard::State::absent;
    for_each_device(f, [&](Tab& tab) {
      if (tab.now().jog_guard.state == from) tab.send_followed(intent::GuardJogs(!installed));
    });
    done = true;
  }
  if (!done) return;
  open_ = false;
  ImGui::CloseCurrentPopup();
}

}  // namespace hw::panels
