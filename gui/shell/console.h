#pragma once
// The console: its controllers, which one is in front, what is shown, and what reaches all of them (Stop).
// Knows no device and no panel by name. GUI thread only; what it needs of the world is given in Outside.
#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/recent.h"
#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/model/toasts.h"
#include "gui/shell/device_finder.h"
#include "gui/shell/dialogs.h"
#include "gui/shell/panel_entry.h"
#include "gui/shell/port_finder.h"
#include "gui/surface/layout.h"

namespace hw {
struct RehearsedPieces;  // core/session/rehearse_together.h
struct RehearsedTogether;
namespace sequence {
struct Sequence;
}
}  // namespace hw

namespace hw::gui {

enum class Command : std::uint8_t;
/// Whether the lower part of the right column is open. Automatic: where there is room for it.
enum class Fold : std::uint8_t { automatic, open, folded };
struct CommandEdge;
class Keyboard;
struct Outside;  // what it needs of the world: outside.h

class Console {
 public:
  Console(PanelList list, Outside outside);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // ---- controllers
  /// Opens it as the newest tab, in front. The fault says why the address makes no sense; whether somebody
  /// answers there is told by the snapshot later.
  Result<Tab*> open(std::string_view address);
  /// The same for a session that somebody else has opened (a script). It is closed with the tab.
  Tab& adopt(std::shared_ptr<Session> session);
  /// The same for all of a wire: one controller, or one tab for all of a bus. The tab of the first is
  /// returned.
  Tab& adopt(std::shared_ptr<SessionGroup> group);
  /// The same for one that is not a session's (tests).
  Tab& add(std::unique_ptr<Tab> tab);
  /// Puts tabs that were added before onto one bus.
  void join(std::vector<Tab*> members, std::string name, std::shared_ptr<SessionGroup> group = nullptr);
  void close(Tab& tab);  ///< and all others of its bus
  void close_all();      ///< as the console ends: what was open is that of last time
  /// What controllers had to say while they were closed, one sentence each; told once.
  std::vector<std::string> take_last_words();
  /// Sessions that were told to close and are not done yet. The scheduler must run until it is 0.
  [[nodiscard]] int closing() const { return *closing_; }
  void rename(Tab& tab, std::string name);  ///< of a bus: names the bus
  void reconnect(Tab& tab);
  [[nodiscard]] const std::vector<std::unique_ptr<Tab>>& tabs() const { return tabs_; }
  /// Has a tab in the top bar: alone, or the chosen one of its bus.
  [[nodiscard]] static bool is_face(const Tab& tab);
  [[nodiscard]] int faces() const;
  /// Null: a page is in front.
  [[nodiscard]] Tab* active();
  void activate(Tab& tab);  ///< of a bus: chooses this one
  void activate_next(int direction);

  // ---- what is shown
  void show_page(std::string_view id);
  /// The first page, with this controller's link looked into.
  void examine_link(const Tab& tab);
  /// The controller whose link is to be looked into; once. Null: none, or it was closed.
  [[nodiscard]] Tab* take_link_to_examine();
  void toggle_help() { help_open_ = !help_open_ && list_.make_help; }
  [[nodiscard]] bool help_open() const { return help_open_; }
  [[nodiscard]] std::string_view page() const { return page_; }  ///< empty: a controller is in front
  /// Brings a panel of the active controller to the front; `widget`: brought into view and focused as well.
  void show_panel(std::string_view id, std::string_view widget = {});
  /// Starts one emulator of each controller.
  void start_demo();
  /// `about`: what it speaks of; Toasts::withdraw() takes it back when that has changed.
  void toast(Mood mood, std::string sentence, const void* about = nullptr) {
    toasts_.add(mood, std::move(sentence), about);
  }
  /// Of that controller: it is named when another one is looked at.
  void toast(const Tab& of, Mood mood, std::string sentence, const void* about = nullptr);
  [[nodiscard]] bool dark() const { return dark_; }  ///< whoever owns the screen follows it between frames
  void set_dark(bool dark) { dark_ = dark; }
  /// How much larger than usual everything is: 1 = 100 %. Followed like dark().
  [[nodiscard]] float size() const { return size_; }
  void set_size(float size);
  void step_size(int direction);  ///< to the next larger or smaller of the usual ones; 0: 100 %
  Splitters splitters;
  /// A dialog that is open, over whichever controller it is about.
  Dialogs dialogs;
  bool right_open = false;  ///< medium: the right column lies over the centre
  Fold lower_right = Fold::automatic;

  // ---- hands
  /// Ramp down everything, everywhere; a second time: at once.
  void stop_all(StoppedBy by = StoppedBy::button);
  /// Has this keyboard's edges act on arrival, before the next frame.
  void attach(Keyboard& keyboard);
  void on_edge(const CommandEdge& edge);
  /// The window lost the focus or is about to close: nothing is held any more.
  void let_go();

  /// The window shall close, and nothing is to be asked any more: whoever owns it closes it.
  void end() { ended_ = true; }
  [[nodiscard]] bool ended() const { return ended_; }
  /// The user's session ends without a question (a signal, a display that has gone): what this console began
  /// is stopped, and what was done is written where the next start tells it. Waits up to five seconds for it
  /// to come to rest. `how`: "SIGTERM".
  void depart(std::string_view how);
  /// Closed by the user: what was begun here and no stop reaches is told at the next start too.
  void note_unreached(std::span<Tab* const> closed, std::string_view how);
  /// Files let fall on the window are opened in the editor of the controller in front; under a dialog or a
  /// menu none is, for what it asks comes first.
  void drop(const std::vector<std::string>& paths);

  // ---- frame
  void draw(Ui& ui);
  /// Writes what the user has named, chosen and dragged. Also done by the way; call it before the end.
  void save();

  // ---- for pages and panels
  [[nodiscard]] Instant clock() const;
  [[nodiscard]] std::string time_of_day(Instant when) const;  ///< "14:20:08"
  void set_day(DayClock day);                                 ///< from now on it is this time
  [[nodiscard]] PortFinder& ports();
  [[nodiscard]] DeviceFinder& devices();
  [[nodiscard]] RecentConnections& recent() { return recent_; }
  [[nodiscard]] const UserFolders& folders() const;
  [[nodiscard]] const PanelList& list() const { return list_; }
  [[nodiscard]] Toasts& toasts() { return toasts_; }
  /// The open controller that uses this port; null: none.
  [[nodiscard]] const Tab* open_at(std::string_view where) const;
  /// For a worker: a sequence that the controllers of a bus do together, from how they stand now. Null: no
  /// controllers are behind their tabs.
  using Together = std::function<Result<RehearsedTogether>(const sequence::Sequence&)>;
  [[nodiscard]] Together rehearsal_of(const Bus& bus) const;
  /// The same of one controller's pieces. Null: none is behind the tab.
  using InPieces = std::function<Result<RehearsedPieces>(std::shared_ptr<const Pieces>)>;
  [[nodiscard]] InPieces rehearsal_of(Tab& tab) const;
  /// The object behind a page, made when it is first shown.
  [[nodiscard]] Page& page_object(std::string_view id);
  [[nodiscard]] Sheet& help_object();

 private:
  void refresh(Ui& ui);
  [[nodiscard]] std::string free_name(const std::string& wanted) const;
  [[nodiscard]] std::string free_key(const std::string& wanted) const;
  Tab& make_tab(std::shared_ptr<Session> session, bool on_bus);
  void close_with_bus(Tab& tab);
  void close_one(Tab& tab);
  void close_as_asked();
  void tell_last_ends();
  void tell_news(Tab& tab);
  void tell(const Result<>& outcome);
  void jog_key(Tab& tab, const CommandEdge& edge);
  void confirm_held_key(Ui& ui);
  void load_choices();
  void save_choices();

  PanelList list_;
  std::unique_ptr<Outside> outside_;
  NoPorts no_ports_;
  NoDevices no_devices_;
  RecentConnections recent_;
  std::vector<std::unique_ptr<Tab>> tabs_;
  Tab* active_ = nullptr;
  std::string page_;
  std::vector<std::unique_ptr<Page>> pages_;
  std::unique_ptr<Sheet> help_;
  bool help_open_ = false;
  Toasts toasts_;
  bool dark_ = true;
  float size_ = 1;
  Splitters kept_;  ///< as written last
  bool kept_dark_ = true;
  float kept_size_ = 1;
  Fold kept_fold_ = Fold::automatic;
  const Tab* examined_ = nullptr;  ///< its link is asked about; only compared
  bool ended_ = false, covered_ = false, close_asked_ = false, list_open_ = false;
  std::string asked_;  ///< by a dialog, of which no toast need tell
  std::shared_ptr<std::atomic<int>> closing_ = std::make_shared<std::atomic<int>>(0);
  /// What controllers say while they are closed: their tabs have gone by then. Written on the io thread.
  std::shared_ptr<Ring<Notice>> last_words_ = std::make_shared<Ring<Notice>>(16);
  std::string wanted_widget_;
};

}  // namespace hw::gui
