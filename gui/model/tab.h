#pragma once
// The GUI thread's side of one open controller: its newest snapshot, the user's names, display settings and
// texts, the hold on its jog pad, and its panels. GUI thread only; all contact with the io thread goes
// through the Session.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/device/registry.h"
#include "core/session/address.h"
#include "gui/model/bus.h"
#include "gui/model/desk.h"
#include "gui/model/jog_hold.h"
#include "gui/model/motion_bar.h"
#include "gui/model/panel.h"
#include "gui/model/tab_messages.h"
#include "gui/model/tab_view.h"
#include "gui/model/units_format.h"
#include "gui/model/user_settings.h"
#include "gui/model/watched_groups.h"

namespace hw {
class Session;  // only declared: panels need not compile coroutines
}

namespace hw::gui {

class Tab {
 public:
  /// The two ways to the controller. Tests of panels pass their own and check the calls.
  struct Backend {
    std::function<IntentId(IntentBody, std::optional<double> user_acted_s_ago)> send;
    std::function<void(BenchCommand)> operate_bench;
  };

  /// `on_bus`: a controller of one axis, and its widgets, are named by its id.
  Tab(std::shared_ptr<Session> session, std::string profile_key, bool on_bus = false);
  Tab(Address address, Catalog catalog, Backend backend, const Language* language = nullptr,
      TrafficLog::Explain explain = nullptr);
  Tab(const Tab&) = delete;
  Tab& operator=(const Tab&) = delete;

  /// Once a frame: takes over the session's news.
  void refresh();
  /// For tests: shows a snapshot without a session.
  void show(const Snapshot& snapshot, const BenchView& bench, Instant clock);

  [[nodiscard]] const Catalog& catalog() const { return catalog_; }
  [[nodiscard]] const Snapshot& now() const { return *latest_.now; }
  [[nodiscard]] const BenchView& bench() const { return *latest_.bench; }
  [[nodiscard]] Instant clock() const { return latest_.clock; }
  [[nodiscard]] const Address& address() const { return address_; }
  [[nodiscard]] bool emulated() const { return address_.emulated(); }
  [[nodiscard]] const std::shared_ptr<Session>& session() const { return session_; }

  /// How long ago the user made the input that ImGui receives in this frame; none: no input. Stop times are
  /// measured from there.
  void user_acted(std::optional<double> ago_s) { user_acted_s_ago_ = ago_s; }
  IntentId send(IntentBody body);
  /// As send(), and a refusal or failure is reported in TabMessages::complaints().
  IntentId send_followed(IntentBody body);
  void operate_bench(BenchCommand command) { backend_.operate_bench(std::move(command)); }
  /// Why nothing may be moved now (no link, a program runs), as a sentence that says when this ends; empty:
  /// motion is allowed. Valid until the next refresh().
  [[nodiscard]] std::string_view why_not_move() const { return bar_.why(); }
  /// The same for one axis, whose motor may have no current.
  [[nodiscard]] std::string_view why_not_move(AxisId axis) const { return bar_.why(axis, *latest_.now); }
  /// Sends a stop to this controller and drops a held jog, which the stop ends.
  void stop_all(StoppedBy by = StoppedBy::button);
  /// The same after a stop that was sent with those of others, as this intent.
  void stopped_with(IntentId stop);
  /// Traffic, program texts, edited set-up: data that outlive the panel that shows them.
  [[nodiscard]] Desk& desk() { return desk_; }
  /// The user's name for this controller or its bus; else the default.
  [[nodiscard]] std::string_view name() const;
  [[nodiscard]] std::string_view id() const { return id_; }  ///< its device on the wire; may be empty

 private:
  // first, as the public members refer to them
  const std::shared_ptr<Session> session_;  ///< null in tests
  const Address address_;
  const Catalog catalog_;
  const std::string id_;
  Backend backend_;
  std::optional<double> user_acted_s_ago_;
  Desk desk_;

 public:
  std::shared_ptr<Bus> bus;  ///< null: alone on its wire
  UserSettings settings;
  JogHold jog;
  TabMessages messages;
  WatchedGroups watched;
  TabView view;
  OpenPanels panels;

 private:
  [[nodiscard]] std::function<IntentId(IntentBody)> followed_sender();
  void follow_snapshot();
  void take(Notice& notice);

  MotionBar bar_;
  /// The controller's state as of the latest refresh().
  struct Latest {
    const Snapshot* now;
    const BenchView* bench;
    Instant clock{};
  };
  Latest latest_;
};

}  // namespace hw::gui
