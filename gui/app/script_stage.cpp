#include "gui/app/script_stage.h"

#include "gui/shell/outside.h"
#include "panels/panel_list.h"

namespace hw::app {

// Virtual time has no time of day. It always starts at nine in the morning, so that replays look the same.
constexpr gui::DayClock virtual_day{std::chrono::hours(9)};

gui::Outside ScriptStage::outside(WireOpener opener) {
  // A controller on a real port switches to real time, as with hw.open.
  WireOpener on_screen = [this, opener = std::move(opener)](Scheduler& scheduler, Address address,
                                                            std::shared_ptr<BenchAccess> again) {
    if (!address.emulated()) runner_->go_real();
    return opener(scheduler, std::move(address), std::move(again));
  };
  gui::Outside outside(scheduler_, std::move(on_screen), [] {});
  outside.devices = &devices_;
  outside.worker = &worker_;
  outside.day = virtual_day;
  return outside;
}

ScriptStage::ScriptStage(Scheduler& scheduler, WireOpener opener)
    : scheduler_(scheduler),
      devices_(scheduler, [this] { runner_->go_real(); }),
      console_(panels::panel_list(), outside(std::move(opener))),
      automation_(
          surface_, [this] { runner_->run_one_frame(); }, [this] { return seconds(scheduler_.now()); },
          [this] { return runner_->over(); }) {
  console_.attach(surface_.screen().keyboard());
  frame(scheduler_.now());  // the script may read the screen before its first wait
}

ScriptStage::~ScriptStage() = default;

void ScriptStage::opened(const std::shared_ptr<SessionGroup>& group) { console_.adopt(group); }

std::vector<std::shared_ptr<Session>> ScriptStage::controllers() const {
  std::vector<std::shared_ptr<Session>> all;
  for (const auto& tab : console_.tabs())
    if (tab->session()) all.push_back(tab->session());
  return all;
}

void ScriptStage::frame(Instant now) {
  if (console_.dark() != console_was_dark_) surface_.screen().set_theme(console_was_dark_ = console_.dark());
  if (console_.size() != size_) {
    surface_.screen().set_scale(surface_.screen().scale() * console_.size() / size_);
    size_ = console_.size();
  }
  worker_.deliver();
  surface_.frame(seconds(now), [this](gui::Ui& ui) { console_.draw(ui); });
}

Result<> ScriptStage::set_theme(const std::string& name) {
  auto set = automation_.theme(name);
  if (set) console_.set_dark(console_was_dark_ = name == "dark");
  return set;
}

std::optional<script::AxisUnit> ScriptStage::unit_of(const Session& session, int axis) const {
  for (const auto& tab : console_.tabs())
    if (tab->session().get() == &session) return unit_of_profile(tab->catalog(), tab->settings.profile, axis);
  return {};
}

void ScriptStage::time_is_real() { console_.set_day(gui::DayClock::local(scheduler_.now())); }

// The runner closes the sessions.
void ScriptStage::script_over() { console_.let_go(); }

}  // namespace hw::app
