// The window: io thread, console, panels. `demo` adds emulated controllers; without a display it lets them do a
// real job in words and leaves pictures of the console.
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include <fmt/format.h>

#include "core/base/log.h"
#include "gui/app/cli.h"
#include "gui/app/port_watch.h"
#include "gui/app/wiring.h"
#include "gui/console.h"
#include "gui/offscreen.h"
#include "gui/outside.h"
#include "gui/window.h"
#include "gui/worker.h"
#include "panels/panel_list.h"
#include "transports/open.h"

namespace hw::app {
namespace {

bool has_display() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

// Everything a console hangs on, in the order in which it must end.
class ConsoleHouse {
 public:
  explicit ConsoleHouse(bool keeps_files)
      : worker_([this] { wake(); }, true),
        ports_(io_.scheduler(), [this] { wake(); }),
        console_(panels::panel_list(), outside(keeps_files)) {}
  ~ConsoleHouse() {
    console_.let_go();
    console_.save();
    console_.close_all();
    while (console_.closing() > 0) std::this_thread::sleep_for(Millis(2));
    window_ = nullptr;
  }

  gui::Console& console() { return console_; }
  Scheduler& scheduler() { return io_.scheduler(); }
  void draw(gui::Ui& ui) {
    worker_.deliver();
    console_.draw(ui);
  }
  void show_in(gui::Window& window) { window_ = &window; }

 private:
  void wake() {
    if (gui::Window* window = window_) window->wake();
  }
  gui::Outside outside(bool keeps_files) {
    gui::Outside o(io_.scheduler(), wire_opener(), [this] { wake(); });
    o.ports = &ports_;
    o.worker = &worker_;
    if (keeps_files) o.folders = UserFolders::standard();
    o.usb_serial = [](const Address& address) {
      for (const SerialPort& port : list_serial_ports())
        if (address.transport == "serial" && port.path == address.where) return port.serial;
      return std::string();
    };
    std::tm local{};
    const std::time_t now = std::time(nullptr);
    localtime_r(&now, &local);
    const double began = local.tm_hour * 3600 + local.tm_min * 60 + local.tm_sec - seconds(io_.scheduler().now());
    o.second_of_day = [began](Instant when) { return began + seconds(when); };
    return o;
  }

  std::atomic<gui::Window*> window_{nullptr};
  IoThread io_;
  gui::Worker worker_;
  PortWatch ports_;
  gui::Console console_;
};

int run_window(const std::vector<std::string>& addresses, bool demo) {
  gui::WindowOptions options;
  auto window = gui::Window::open(options);
  if (!window) return complain(window.error());
  ConsoleHouse house(true);
  gui::Console& console = house.console();
  gui::Window& w = **window;
  house.show_in(w);
  w.screen().set_theme(console.dark());
  console.attach(w.screen().keyboard());
  w.on_close = [&] {
    console.let_go();
    return true;
  };
  for (const std::string& address : addresses)
    if (auto opened = console.open(address); !opened) return complain(opened.error(), usage);
  if (demo) console.start_demo();
  Interruption interrupted(house.scheduler(), [&] {
    w.close();
    w.wake();
  });
  w.run([&](gui::Ui& ui) {
    house.draw(ui);
    if (w.screen().dark() != console.dark()) {
      w.screen().set_theme(console.dark());
      ui.wake_in(0);
    }
  });
  return done;
}

// ---- without a display


Task<int> do_jobs(Scheduler& scheduler) {
  for (const DeviceType& type : device_types()) {
    auto address = Address::parse(std::string(type.model) + "@emulator");
    auto session = co_await connect(scheduler, *address, wire_opener());
    if (!session) co_return complain(session.error());
    Session& s = **session;
    fmt::print("{}: connected, {} axes\n", s.catalog().name, s.catalog().axes.size());
    for (const std::int64_t target : {400, 1200, 0}) {
      std::vector<AxisTarget> targets{{AxisId{0}, Steps(target)}};
      IntentBody move = intent::MoveTo(std::move(targets));
      auto sent = co_await s.perform(std::move(move));
      if (sent) sent = co_await s.wait_until_idle(std::chrono::seconds(20));
      if (!sent) co_return complain(sent.error());
      fmt::print("{}: axis {} is at {} {}\n", s.catalog().name, s.catalog().axes[0].name,
                 s.known().axes[0].position.value, s.catalog().step_word);
    }
    co_await s.close();
  }
  co_return done;
}

int headless_demo() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  fmt::print("There is no display: the emulators do a job in words, then the console is drawn into pictures.\n");
  if (const int status = run_here(do_jobs); status != done) return status;
  const std::filesystem::path folder = "build/demo";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return complain(fmt::format("{} cannot be made: {}.", folder.string(), error.message()));
  for (const bool dark : {true, false}) {
    ConsoleHouse house(false);
    gui::Offscreen screen(1440, 900, 1, dark);
    house.console().set_dark(dark);
    house.console().start_demo();
    const Instant begin = house.scheduler().now();
    while (house.scheduler().now() - begin < Millis(2500)) {
      screen.frame(seconds(house.scheduler().now()), [&](gui::Ui& ui) { house.draw(ui); });
      std::this_thread::sleep_for(Millis(30));
    }
    const auto file = folder / (dark ? "console-dark.png" : "console-light.png");
    if (auto saved = screen.screenshot(file.string()); !saved) return complain(saved.error());
    fmt::print("{}\n", file.string());
  }
  return done;
}

}  // namespace

int open_console(const Given& given) { return run_window(given.words, false); }

int demo(const Given&) { return has_display() ? run_window({}, true) : headless_demo(); }

}  // namespace hw::app
