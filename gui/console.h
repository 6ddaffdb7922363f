#pragma once
// The console: its controllers, which one is in front, what is shown, and what reaches all of them (Stop).
// Knows no device and no panel by name. GUI thread only; what it needs of the world is given in Outside.
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/recent.h"
#include "core/session/user_files.h"
#include "core/session/wire.h"
#include "gui/layout.h"
#include "gui/panel.h"
#include "gui/port_finder.h"
#include "gui/tab.h"
#include "gui/toasts.h"

namespace hw::gui {

enum class Command : std::uint8_t;
struct CommandEdge;

struct Outside {
  Scheduler& scheduler;
  WireOpener open_wire;
  std::function<void()> wake;   ///< any thread: a frame is wanted
  PortFinder* ports = nullptr;  ///< null: finds nothing
  UserFolders folders = UserFolders::none();
  std::function<std::string(const Address&)> usb_serial;  ///< of the adapter behind an address; may be null
  std::function<double(Instant)> second_of_day;           ///< wall clock; null: counts from the start
  Outside(Scheduler& s, WireOpener opener, std::function<void()> w)
      : scheduler(s), open_wire(std::move(opener)), wake(std::move(w)) {}
};

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
  void close(Tab& tab);
  void close_all();
  /// Sessions that were told to close and are not done yet. The scheduler must run until it is 0.
  [[nodiscard]] int closing() const { return *closing_; }
  void rename(Tab& tab, std::string name);
  void reconnect(Tab& tab);
  [[nodiscard]] const std::vector<std::unique_ptr<Tab>>& tabs() const { return tabs_; }
  /// Null: a page is in front.
  [[nodiscard]] Tab* active();
  void activate(Tab& tab);
  void activate_next(int direction);

  // ---- what is shown
  void show_page(std::string_view id);
  [[nodiscard]] std::string_view page() const { return page_; }  ///< empty: a controller is in front
  /// Brings a panel of the active controller to the front; `widget`: brought into view and focused as well.
  void show_panel(std::string_view id, std::string_view widget = {});
  /// Starts one emulator of each controller.
  void start_demo();
  void toast(Mood mood, std::string sentence) { toasts_.add(mood, std::move(sentence)); }
  [[nodiscard]] bool dark() const { return dark_; }  ///< whoever owns the screen follows it between frames
  void set_dark(bool dark) { dark_ = dark; }
  Splitters splitters;

  // ---- hands
  /// Ramp down everything, everywhere; a second time: at once.
  void stop_all();
  /// On arrival of a key, before the next frame.
  void on_edge(const CommandEdge& edge);
  /// The window lost the focus or is about to close: nothing is held any more.
  void let_go();

  // ---- frame
  void draw(Ui& ui);

  // ---- for pages and panels
  [[nodiscard]] Instant clock() const { return outside_.scheduler.now(); }
  [[nodiscard]] std::string time_of_day(Instant when) const;  ///< "14:20:08"
  [[nodiscard]] PortFinder& ports() { return outside_.ports ? *outside_.ports : no_ports_; }
  [[nodiscard]] RecentConnections& recent() { return recent_; }
  [[nodiscard]] const UserFolders& folders() const { return outside_.folders; }
  [[nodiscard]] const PanelList& list() const { return list_; }
  /// The address of an open controller that uses this way; null: none.
  [[nodiscard]] const Tab* open_at(std::string_view where) const;

 private:
  friend class Workspace;
  Tab& add(std::unique_ptr<Tab> tab);
  void refresh();
  void tell(Result<> outcome);
  void jog_key(Command key, bool down, double at_s);
  void save_profiles();

  PanelList list_;
  Outside outside_;
  NoPorts no_ports_;
  RecentConnections recent_;
  std::vector<std::unique_ptr<Tab>> tabs_;
  Tab* active_ = nullptr;
  std::string page_;
  std::vector<std::unique_ptr<Page>> pages_;
  Toasts toasts_;
  bool dark_ = true;
  std::shared_ptr<int> closing_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
