#pragma once
// The GUI thread's side of one open controller: its newest snapshot, the user's names, display settings and
// texts, the hold on its jog pad, and its panels. GUI thread only; all contact with the io thread goes
// through the Session.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/refusals.h"
#include "core/device/registry.h"
#include "core/session/address.h"
#include "core/session/profile.h"
#include "gui/model/axis_units.h"
#include "gui/model/bus.h"
#include "gui/model/desk.h"
#include "gui/model/followed_intents.h"
#include "gui/model/jog_hold.h"
#include "gui/model/motion_bar.h"
#include "gui/model/panel.h"
#include "gui/model/units_format.h"

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
  [[nodiscard]] const Snapshot& now() const { return *now_; }
  [[nodiscard]] const BenchView& bench() const { return *bench_; }
  [[nodiscard]] Instant clock() const { return clock_; }
  [[nodiscard]] const Address& address() const { return address_; }
  [[nodiscard]] bool emulated() const { return address_.emulated(); }
  [[nodiscard]] const DeviceType* type() const;
  [[nodiscard]] const std::shared_ptr<Session>& session() const { return session_; }

  /// How long ago the user made the input that ImGui receives in this frame; none: no input. Stop times are
  /// measured from there.
  void user_acted(std::optional<double> ago_s) { user_acted_s_ago_ = ago_s; }
  IntentId send(IntentBody body);
  /// As send(), and a refusal or failure is reported in complaints().
  IntentId send_followed(IntentBody body);
  void operate_bench(BenchCommand command) { backend_.operate_bench(std::move(command)); }
  /// Why nothing may be moved now (no link, a program runs), as a sentence that says when this ends; empty:
  /// motion is allowed. Valid until the next refresh().
  [[nodiscard]] std::string_view why_not_move() const { return bar_.why(); }
  /// The same for one axis, whose motor may have no current.
  [[nodiscard]] std::string_view why_not_move(AxisId axis) const { return bar_.why(axis, *now_); }
  /// Sends a stop to this controller and drops a held jog, which the stop ends.
  void stop_all(StoppedBy by = StoppedBy::button);
  /// The same after a stop that was sent with those of others, as this intent.
  void stopped_with(IntentId stop);
  /// A stop requested here may still wait to be sent: closing the tab would lose it.
  [[nodiscard]] bool stop_waits() const { return followed_.stop_waits(); }

  /// A panel that shows these values is drawn in this frame. They are read in each status round as long as it
  /// is, see intent::Watch. Bit n = group n of Catalog::readout_groups.
  void look_at(std::uint32_t groups) { looked_at_ |= groups; }
  void look_at_group(int group) {
    if (group >= 0) look_at(1u << group);
  }

  /// The jog pad is drawn in this frame, and with it the card of a refused tap.
  void look_at_pad() { pad_looked_at_ = true; }

  // ---- names and units
  Profile profile;
  std::string default_name;      ///< until the user chooses a name
  std::string profile_key;       ///< key under which the profile is kept
  bool profile_changed = false;  ///< to be saved
  [[nodiscard]] std::string_view name() const;
  [[nodiscard]] const AxisUnits& units() const { return units_; }
  [[nodiscard]] const DisplayUnit& unit(AxisId axis) const { return units_.shown(axis); }
  /// After a change of the profile's units.
  void profile_edited();
  [[nodiscard]] Steps jog_step() const { return profile.jog_step; }
  /// Speed of held jogs of all axes without a choice of their own: the user's choice, else 0 (the
  /// controller's own).
  [[nodiscard]] Pps jog_speed() const { return profile.jog_speed; }
  [[nodiscard]] Pps jog_speed(AxisId axis) const;
  /// Chooses both; on a bus, whose rows share one control, for all its controllers.
  void choose_jog(Steps step, Pps speed);
  /// For all axes, replacing the choices for single axes. 0: the controller's own.
  void choose_jog_speed(Pps of_all);
  /// For this axis; 0: as for all.
  void choose_jog_speed(AxisId axis, Pps speed);

  /// Traffic, program texts, edited set-up: data that outlive the panel that shows them.
  [[nodiscard]] Desk& desk() { return desk_; }

  // ---- to be shown once
  /// Why the intent was refused or has failed, in the displayed units.
  [[nodiscard]] std::string words_of(const IntentOutcome& outcome) const;
  /// Formats a place of an axis in the displayed unit.
  [[nodiscard]] PlaceWords place_words() const;
  /// Messages since the last call; listings go to the desk.
  [[nodiscard]] std::vector<Notice> take_notices();
  [[nodiscard]] std::vector<std::string>& complaints() { return complaints_; }
  /// A tap of the jog pad that was refused because it would have gone past a limit.
  struct TapPastLimit {
    PastTravel past;
    std::string words;
  };
  std::optional<TapPastLimit> tap_past_limit;  ///< until the pad's card is closed
  using Question = FollowedIntents::Question;
  [[nodiscard]] std::optional<Question>& question() { return followed_.question(); }

  // ---- view
  std::shared_ptr<Bus> bus;                                  ///< null: alone on its wire
  [[nodiscard]] std::string_view id() const { return id_; }  ///< its device on the wire; may be empty
  JogHold jog;
  AxisId chosen_axis{0};         ///< on a controller of many axes: the axis for Go and Home
  bool unset_read = false;       ///< the choices to make before the first move have been read, or made
  bool banner_folded = false;    ///< the banner of a lost link is one line high
  std::string follow_to;         ///< address to reopen the tab at before the next frame; see shell/follow.h
  std::string follow_left;       ///< address that was offered for follow_to, and declined
  std::string centre_panel;      ///< id of the panel in front
  std::uint64_t text_turns = 0;  ///< last Desk::text_turns() seen by the console
  /// This controller's panels, parallel to the console's list; created when first drawn.
  std::vector<std::unique_ptr<Panel>> panels;
  /// The data that closing the panels would lose, see Panel::unkept(); empty: none.
  [[nodiscard]] std::string unkept() const;

 private:
  void look_at_snapshot();
  void complain(const IntentOutcome& outcome);
  void report_watched();
  void take(Notice& notice);
  void take(const Ending& ending);
  void note(std::string words);
  void report_travel();

  std::shared_ptr<Session> session_;
  const Address address_;
  const Catalog catalog_;
  const std::string id_;
  Backend backend_;
  std::optional<double> user_acted_s_ago_;
  Desk desk_;
  static const Snapshot nothing_known;
  static const BenchView no_bench;
  const Snapshot* now_ = &nothing_known;
  const BenchView* bench_ = &no_bench;
  Instant clock_{};
  AxisUnits units_;
  MotionBar bar_;
  std::uint32_t looked_at_ = 0;  ///< in this frame
  bool pad_looked_at_ = false;   ///< in this frame
  /// Last sent to the session.
  struct Sent {
    std::array<Travel, max_axes> travel;
    std::array<Backlash, max_axes> backlash;
    std::uint32_t watched = 0;
  };
  Sent sent_;
  FollowedIntents followed_;
  std::vector<Notice> notices_;
  std::vector<std::string> complaints_;
};

}  // namespace hw::gui
