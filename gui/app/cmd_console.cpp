// Runs the console in a window: io thread, console, panels. `demo` adds emulated controllers.
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "core/base/log.h"
#include "core/session/assets.h"
#include "core/session/user_files.h"
#include "gui/app/cli.h"
#include "gui/app/demo.h"
#include "gui/app/device_search.h"
#include "gui/app/kept_units.h"
#include "gui/app/output.h"
#include "gui/app/port_watch.h"
#include "gui/app/sleep_handling.h"
#include "gui/app/wiring.h"
#include "gui/model/worker.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "gui/surface/display_loss.h"
#include "gui/surface/window.h"
#include "panels/panel_list.h"
#include "transports/open.h"

namespace hw::app {
namespace {

bool has_display() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

std::string_view name_of_signal(int number) {
  return number == SIGTERM ? "SIGTERM" : number == SIGHUP ? "SIGHUP" : "SIGINT";
}

// All parts of a console, in the order of their construction; they end in the reverse order.
class ConsoleApp {
 public:
  ConsoleApp(bool keeps_files, std::shared_ptr<WillKeeper> watchdog)
      : watchdog_(std::move(watchdog)),
        worker_([this] { wake(); }, true),
        ports_(io_.scheduler(), [this] { wake(); }),
        devices_(io_.scheduler(), [this] { wake(); }),
        console_(panels::panel_list(), outside(keeps_files)) {}
  ~ConsoleApp() {
    leave_controllers();
    io_.stop();  // before the objects that its thread may still use
    window_ = nullptr;
  }

  /// Stops held jogs and closes every controller. Reports motions and programs that continue.
  void leave_controllers() {
    console_.let_go();
    console_.save();
    console_.close_all();
    while (console_.closing() > 0) std::this_thread::sleep_for(Millis(2));
    for (const std::string& sentence : console_.take_closing_messages()) complain(sentence);
  }

  /// Call when the user's session ends. Stops the motions and programs begun here, including held jogs.
  void shut_down(std::string_view how) { console_.shut_down(how); }

  /// Waits until the worker has written all texts. Call before an exit without destructors.
  void keep_texts() { worker_.finish(); }

  gui::Console& console() { return console_; }
  Scheduler& scheduler() { return io_.scheduler(); }
  void draw(gui::Ui& ui) {
    worker_.deliver();
    sleep_.follow(console_);
    console_.draw(ui);
  }
  void show_in(gui::Window& window) { window_ = &window; }

 private:
  void wake() {
    if (gui::Window* window = window_) window->wake();
  }
  gui::Outside outside(bool keeps_files) {
    gui::Outside o(io_.scheduler(), wire_opener(watchdog_), [this] { wake(); });
    o.ports = &ports_;
    o.devices = &devices_;
    o.worker = &worker_;
    if (keeps_files) o.folders = UserFolders::standard();
    o.usb_serial = usb_serial_behind;
    o.day = gui::DayClock::local(io_.scheduler().now());
    return o;
  }

  std::atomic<gui::Window*> window_{nullptr};
  std::shared_ptr<WillKeeper> watchdog_;
  IoThread io_;
  SleepHandling sleep_{io_.scheduler(), [this] { wake(); }};
  gui::Worker worker_;
  PortWatch ports_;
  DeviceSearcher devices_;
  gui::Console console_;
};

void keep_log() {
  const UserFolders folders = UserFolders::standard();
  if (!folders.enabled) return;
  make_private_folder(folders.state);
  if (const auto kept = log::keep_in(folders.state / "handwheel.log"); !kept)
    log::warning("gui", kept.error().sentence());
}

/// The folder beside a program built here; for an installed program, the present folder of the user.
std::string folder_for_pictures() {
  const std::string folder = folder_of_program();
  return is_installed(folder) ? "handwheel-demo" : folder + "/demo";
}

int run_window(const std::vector<std::string>& addresses, bool demo) {
  auto watchdog = start_jog_watchdog();
  gui::WindowOptions options;
  auto window = gui::Window::open(options);
  if (!window) return complain(window.error());
  keep_log();
  ConsoleApp app(true, std::move(watchdog));
  gui::Console& console = app.console();
  gui::Window& w = **window;
  app.show_in(w);
  w.screen().set_theme(console.dark());
  float size = console.size();
  w.set_user_scale(size);
  console.attach(w.screen().keyboard());
  w.on_drop = [&](const std::vector<std::string>& paths) { console.drop(paths); };
  w.on_first_frame = [] { log::debug("gui", "first frame"); };
  w.on_close = [&] {
    console.let_go();
    return console.dialogs.may_end(console);
  };
  const gui::DisplayGuard guard(
      [&app] {
        app.shut_down("the display went away");
        app.leave_controllers();
        app.keep_texts();
        complain(
            "The display is gone. What this console had started was stopped, as far as a controller was "
            "connected.");
      },
      [&console] {
        console.let_go();
        console.toast(gui::Severity::warn,
                      "The display refused a request of this window. Held jogs were stopped.");
      });
  for (const std::string& address : addresses)
    if (auto opened = console.open(address); !opened) return complain(opened.error(), usage);
  if (demo) console.start_demo();
  std::atomic<int> signal{0};
  Interruption interrupted(app.scheduler(), [&](int number) {
    signal = number;
    w.close();
    w.wake();
  });
  w.run([&](gui::Ui& ui) {
    app.draw(ui);
    if (console.ended()) w.close();
    if (w.screen().dark() != console.dark()) {
      w.screen().set_theme(console.dark());
      ui.wake_in(0);
    }
    if (size != console.size()) w.set_user_scale(size = console.size());
  });
  if (signal != 0) app.shut_down(name_of_signal(signal));
  return done;
}

}  // namespace

static int open_console(const Given& given) {
  for (const std::string& word : given.words)
    if (const auto address = Address::parse(word); !address) return complain(address.error(), usage);
  return run_window(given.words, false);
}

static int demo(const Given& given) {
  if (has_display() && !given.has("headless")) return run_window({}, true);
  if (!has_display())
    print_result("There is no display: emulated controllers run a demonstration in text and pictures.\n");
  return headless_demo(given.one("pictures", folder_for_pictures()));
}

const Subcommand open_subcommand{
    "open",
    "the console (also without any subcommand)",
    {{"ADDRESS", "controllers to open; none: the connection page", 0, -1}},
    {},
    open_console,
};

const Subcommand demo_subcommand{
    "demo",
    "the console with emulated controllers; without a display a headless demonstration",
    {},
    {{"pictures", "FOLDER",
      "where the headless demonstration leaves its pictures (default: demo beside the program that was "
      "built, or "
      "handwheel-demo)"},
     {"headless", "", "no window, even with a display"}},
    demo,
};

}  // namespace hw::app
