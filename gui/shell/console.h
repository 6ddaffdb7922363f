#pragma once
// The console owns its controllers, knows which controller is in front, and sends commands to all of them
// (Stop). It knows no device and no panel by name. GUI thread only. Outside gives it access to the rest of
// the program.
#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/recent.h"
#include "core/session/user_files.h"
#include "gui/model/log_lines.h"
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
/// State of the lower part of the right column. Automatic: open where it fits.
enum class Fold : std::uint8_t { automatic, open, folded };
struct CommandEdge;
class Keyboard;
struct Outside;  // access to the rest of the program: outside.h

class Console {
 public:
  Console(PanelList list, Outside outside);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // ---- controllers
  /// Opens the controller in a new tab, in front. The fault says why the address is invalid. Whether the
  /// controller answers is seen later, in its snapshot.
  Result<Tab*> open(std::string_view address);
  /// Adds a tab for a session that a script has opened. Closing the tab closes the session.
  Tab& adopt(std::shared_ptr<Session> session);
  /// Adds all controllers of a wire, in one tab for the whole bus. Returns the tab of the first controller.
  Tab& adopt(std::shared_ptr<SessionGroup> group);
  /// Adds a tab without a session, for tests.
  Tab& add(std::unique_ptr<Tab> tab);
  /// Joins tabs that were added before on one bus.
  void join(std::vector<Tab*> members, std::string name, std::shared_ptr<SessionGroup> group = nullptr);
  void close(Tab& tab);  ///< closes all controllers of its bus
  void close_all();  ///< call when the console ends; the open controllers are recorded as those of the last
                     ///< session
  /// Returns, once, the messages of controllers that were being closed, one sentence each.
  std::vector<std::string> take_closing_messages();
  /// The number of sessions that are closing. The scheduler must run until it is 0.
  [[nodiscard]] int closing() const { return *closing_.left; }
  void rename(Tab& tab, std::string name);  ///< a controller on a bus names the bus
  void reconnect(Tab& tab);
  [[nodiscard]] const std::vector<std::unique_ptr<Tab>>& tabs() const { return tabs_; }
  /// Whether the controller has a tab in the top bar: it is alone, or it is chosen on its bus.
  [[nodiscard]] static bool is_face(const Tab& tab);
  [[nodiscard]] int faces() const;
  /// The controller in front; null: a page is in front.
  [[nodiscard]] Tab* active();
  void activate(Tab& tab);  ///< on a bus it becomes the chosen controller
  void activate_next(int direction);

  // ---- messages and views
  void show_page(std::string_view id);
  /// Shows the first page, which then examines this controller's link.
  void examine_link(const Tab& tab);
  /// Returns, once, the controller whose link is to be examined. Null: none, or it was closed.
  [[nodiscard]] Tab* take_link_to_examine();
  void toggle_help() { help_.open = !help_.open && list_.make_help; }
  [[nodiscard]] bool help_open() const { return help_.open; }
  [[nodiscard]] std::string_view page() const { return page_; }  ///< empty: a controller is in front
  /// Brings a panel of the active controller to the front, and scrolls `widget` into view and focuses it.
  void show_panel(std::string_view id, std::string_view widget = {});
  /// Starts one emulator of each model.
  void start_demo();
  /// `about` is the subject of the toast; Toasts::withdraw() removes the toast when the subject has changed.
  void toast(Severity severity, std::string sentence, const void* about = nullptr) {
    toasts_.add(severity, std::move(sentence), about);
  }
  /// A toast of a controller, which it names while another controller is in front.
  void toast(const Tab& of, Severity severity, std::string sentence, const void* about = nullptr);
  [[nodiscard]] bool dark() const { return dark_; }  ///< applied between frames by the owner of the screen
  void set_dark(bool dark) { dark_ = dark; }
  /// Scale of all widgets and texts: 1 is 100 %. Applied like dark().
  [[nodiscard]] float size() const { return size_; }
  void set_size(float size);
  void step_size(int direction);  ///< +1, -1: to the next larger or smaller usual size; 0: to 100 %
  Splitters splitters;
  /// The open dialog, whichever controller it is about.
  Dialogs dialogs;
  LogLines log;
  bool right_open = false;  ///< medium width: the right column is unfolded
  /// Whether the right column lies over the centre, which is too narrow to shrink.
  [[nodiscard]] bool right_covers() const { return right_covers_; }
  Fold lower_right = Fold::automatic;

  // ---- input
  /// Ramps down all axes of all controllers. A second call stops them at once.
  void stop_all(StoppedBy by = StoppedBy::button);
  /// Makes the edges of this keyboard act on arrival, before the next frame.
  void attach(Keyboard& keyboard);
  void on_edge(const CommandEdge& edge);
  /// Ends all holds. Call when the window loses the focus or is about to close.
  void let_go();

  /// Makes ended() true: the owner of the window closes it without further questions.
  void end() { ended_ = true; }
  [[nodiscard]] bool ended() const { return ended_; }
  /// Call when the user's session ends without a question (a signal, a lost display). Stops the motions and
  /// programs that this console began, records them for the next start, and waits up to five seconds for
  /// rest. `how` is the cause: "SIGTERM".
  void shut_down(std::string_view how);
  /// Records, for the next start too, motions and programs begun here that no stop reaches. Call when the
  /// user closes the controllers.
  void note_unreached(std::span<Tab* const> closed, std::string_view how);
  /// Opens files dropped on the window in the editor of the controller in front. Files are ignored while a
  /// dialog or menu is open.
  void drop(const std::vector<std::string>& paths);

  // ---- frame
  void draw(Ui& ui);
  /// Writes the user's names, choices and splitters. The console does it from time to time; call it before
  /// the end too.
  void save();

  // ---- for pages and panels
  [[nodiscard]] Instant clock() const;
  [[nodiscard]] std::string time_of_day(Instant when) const;  ///< "14:20:08"
  void set_day(DayClock day);                                 ///< sets the present time of day
  [[nodiscard]] PortFinder& ports();
  [[nodiscard]] DeviceFinder& devices();
  [[nodiscard]] RecentConnections& recent() { return recent_; }
  [[nodiscard]] const UserFolders& folders() const;
  [[nodiscard]] const PanelList& list() const { return list_; }
  [[nodiscard]] Toasts& toasts() { return toasts_; }
  /// The open controller that uses this port; null: the port is free here.
  [[nodiscard]] const Tab* open_at(std::string_view where) const;
  /// Rehearses, on a worker, a sequence that the controllers of a bus carry out together, from their present
  /// state. Null: the tabs have no controllers.
  using Together = std::function<Result<RehearsedTogether>(const sequence::Sequence&)>;
  [[nodiscard]] Together rehearsal_of(const Bus& bus) const;
  /// Rehearses, on a worker, the pieces of a drawing for one controller. Null: the tab has no controller.
  using InPieces = std::function<Result<RehearsedPieces>(std::shared_ptr<const Pieces>)>;
  [[nodiscard]] InPieces rehearsal_of(Tab& tab) const;
  /// The object of a page; it is created when the page is first shown.
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
  void report_last_ends();
  void report_news(Tab& tab);
  void report_failure(const Result<>& outcome);
  void jog_key(Tab& tab, const CommandEdge& edge);
  void confirm_held_key(Ui& ui);
  void load_choices();
  void save_choices();

  PanelList list_;
  std::unique_ptr<Outside> outside_;
  struct NoSearch {
    NoPorts ports;
    NoDevices devices;
  };
  NoSearch no_search_;  ///< used where Outside has no search
  RecentConnections recent_;
  std::vector<std::unique_ptr<Tab>> tabs_;
  Tab* active_ = nullptr;
  std::string page_;
  std::vector<std::unique_ptr<Page>> pages_;
  struct Help {
    std::unique_ptr<Sheet> sheet;
    bool open = false;
  };
  Help help_;
  Toasts toasts_;
  bool dark_ = true;
  float size_ = 1;
  struct Choices {
    Splitters splitters;
    bool dark = true;
    float size = 1;
    Fold fold = Fold::automatic;
    bool operator==(const Choices&) const = default;
  };
  [[nodiscard]] Choices choices() const { return {splitters, dark_, size_, lower_right}; }
  Choices kept_;  ///< choices as last written
  struct Wanted {
    const Tab* examined = nullptr;  ///< controller whose link is to be examined; the pointer is only compared
    std::string widget;             ///< id of the widget to scroll into view
  };
  Wanted wanted_;
  bool ended_ = false, covered_ = false, close_asked_ = false, list_open_ = false, right_covers_ = false;
  std::string asked_;  ///< question of the open dialog, which needs no toast
  struct Closing {
    std::shared_ptr<std::atomic<int>> left = std::make_shared<std::atomic<int>>(0);
    /// Messages of controllers whose tabs are closed. Written on the io thread.
    std::shared_ptr<Ring<Notice>> closing_messages = std::make_shared<Ring<Notice>>(16);
  };
  Closing closing_;
};

}  // namespace hw::gui
