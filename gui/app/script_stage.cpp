#include "gui/app/script_stage.h"

#include "gui/outside.h"
#include "panels/panel_list.h"

namespace hw::app {

gui::Outside ScriptStage::outside(WireOpener opener) {
  gui::Outside outside(scheduler_, std::move(opener), [] {});
  outside.worker = &worker_;
  return outside;
}

ScriptStage::ScriptStage(Scheduler& scheduler, WireOpener opener)
    : scheduler_(scheduler),
      console_(panels::panel_list(), outside(std::move(opener))),
      automation_(
          surface_, [this] { runner_->run_one_frame(); }, [this] { return seconds(scheduler_.now()); }) {
  console_.attach(surface_.screen().keyboard());
  frame(scheduler_.now());  // a script may look at the screen before it waits for the first time
}

ScriptStage::~ScriptStage() = default;

void ScriptStage::opened(const std::shared_ptr<SessionGroup>& group) {
  for (const auto& session : group->members()) console_.adopt(session);
}

void ScriptStage::frame(Instant now) {
  if (console_.dark() != console_was_dark_) surface_.screen().set_theme(console_was_dark_ = console_.dark());
  worker_.deliver();
  surface_.frame(seconds(now), [this](gui::Ui& ui) { console_.draw(ui); });
}

Result<> ScriptStage::set_theme(const std::string& name) {
  auto set = automation_.theme(name);
  if (set) console_.set_dark(console_was_dark_ = name == "dark");
  return set;
}

// The runner closes the sessions; a held button lets go before.
void ScriptStage::script_over() { console_.let_go(); }

}  // namespace hw::app
