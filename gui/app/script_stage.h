#pragma once
// The screen of `run --gui`: a script drives the real console and panels without a display.
#include "core/script/module.h"
#include "gui/app/device_search.h"
#include "gui/app/kept_units.h"
#include "gui/model/worker.h"
#include "gui/shell/console.h"
#include "gui/surface/automation.h"
#include "gui/surface/offscreen.h"

namespace hw::app {

/// Makes time real when a search starts, because the connection page then opens real ports.
class SearchInRealTime final : public gui::DeviceFinder {
 public:
  SearchInRealTime(Scheduler& scheduler, std::function<void()> go_real)
      : searcher_(scheduler, [] {}), go_real_(std::move(go_real)) {}
  void start(const std::string& path, int baud, int first_id, int last_id) override {
    go_real_();
    searcher_.start(path, baud, first_id, last_id);
  }
  void cancel() override { searcher_.cancel(); }
  const gui::DeviceSearchState& state() override { return searcher_.state(); }

 private:
  DeviceSearcher searcher_;
  std::function<void()> go_real_;
};

class ScriptStage final : public script::Stage {
 public:
  ScriptStage(Scheduler& scheduler, WireOpener opener);
  ~ScriptStage() override;

  void bind(lua_State* L) override;  ///< bind_ui.cpp
  void opened(const std::shared_ptr<SessionGroup>& group) override;
  [[nodiscard]] std::vector<std::shared_ptr<Session>> controllers() const override;
  void frame(Instant now) override;
  void script_over() override;

  /// The length unit that the console shows for that axis.
  [[nodiscard]] std::optional<script::AxisUnit> unit_of(const Session& session, int axis) const;
  /// Switches from virtual to real time, for good.
  void time_is_real();

  gui::Automation& automation() { return automation_; }
  /// Sets the theme as the user's switch does, so that the console shows it as chosen.
  Result<> set_theme(const std::string& name);

 private:
  gui::Outside outside(WireOpener opener);
  Scheduler& scheduler_;
  gui::Offscreen surface_;
  SearchInRealTime devices_;
  gui::Worker worker_;  // without a thread, so that every run has the same order
  gui::Console console_;
  bool console_was_dark_ = true;
  float size_ = 1;  ///< size chosen by the user; the surface's scale includes it
  script::Runner* runner_ = nullptr;
  gui::Automation automation_;
};

}  // namespace hw::app
