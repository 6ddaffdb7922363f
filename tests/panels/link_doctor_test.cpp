// The connection page with controllers on a real line of emulators: what the link doctor finds there, that it
// raises the rate and takes it back, an address that is changed, an emulator that is served, all of last
// time.
#include <filesystem>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/registry.h"
#include "gui/shell/emulator_server.h"
#include "gui/shell/port_examiner.h"
#include "panels/connect/rate_raise.h"
#include "panels/connect/usual_catalogs.h"
#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"
#include "transports/serve.h"

namespace hw::panels {
namespace {

using gui::ExaminedPort;
using gui::ServedEmulator;
using testing::HasSubstr;
using testing::StartsWith;

class Examiner final : public gui::PortExaminer {
 public:
  std::vector<std::string> asked;
  ExaminedPort port;
  void examine(const std::string& path) override { asked.push_back(path); }
  const ExaminedPort* find(const std::string&) override { return asked.empty() ? nullptr : &port; }
  void set_adapter_timer(const std::string& path, int ms) override {
    asked.push_back(fmt::format("{} to {}", path, ms));
    port.adapter_waits = Millis(ms);
  }
};

class Server final : public gui::EmulatorServer {
 public:
  std::map<std::string, ServedEmulator, std::less<>> all;
  std::vector<std::string> asked;
  void serve(const std::string& key, const Address& address, std::shared_ptr<Session> session) override {
    asked.push_back(fmt::format("{} {}", address.text(), session ? "as it is open" : "of its own"));
    all[key] = {"127.0.0.1:5801", "/tmp/handwheel-vxm", 1, {}};
  }
  void end(std::string_view key) override { all.erase(all.find(key)); }
  const ServedEmulator* find(std::string_view key) override {
    const auto at = all.find(key);
    return at == all.end() ? nullptr : &at->second;
  }
};

class Machine final : public gui::PortFinder {
 public:
  std::vector<gui::FoundPort> list;
  Examiner eyes;
  Server service;
  const std::vector<gui::FoundPort>& ports() override { return list; }
  void look() override {}
  void watch(bool) override {}
  void ask(const std::string&) override {}
  [[nodiscard]] bool busy() const override { return false; }
  [[nodiscard]] gui::PortExaminer* examiner() override { return &eyes; }
  [[nodiscard]] gui::EmulatorServer* server() override { return &service; }
};

Task<Result<Wire>> plug_into(std::shared_ptr<EmulatorHost> host, Address address) {
  if (address.where == "nowhere:1")
    co_return fail(FaultKind::port, "nowhere:1 takes no connection.", {}, "Look at its address.");
  auto stream = host->plug_in(address.number("baud", 0).value_or(0));
  if (!stream) co_return fail(stream.error());
  Wire wire;
  wire.stream = std::move(*stream);
  if (address.emulated())
    for (std::size_t i = 0; i < host->device_count(); ++i) wire.benches.push_back(host->bench(i));
  co_return wire;
}

/// A console whose every address leads to the one line.
struct Desk {
  explicit Desk(const char* model, const std::vector<std::string>& ids = {}, int width = 1440,
                int height = 900, const UserFolders& folders = UserFolders::none())
      : host(make_host(model, ids)),
        console(panel_list(), outside(folders)),
        stage([this](gui::Ui& ui) { draw(ui); }, width, height) {}
  ~Desk() {
    console.close_all();
    clock.run_until(clock.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  std::shared_ptr<EmulatorHost> make_host(const char* model, const std::vector<std::string>& ids) {
    const DeviceType& type = *find_device_type(model);
    std::vector<HostedDevice> devices;
    for (const std::string& id : ids) devices.push_back({id, *type.make_emulator({{"id", id}})});
    if (ids.empty()) devices.push_back({"", *type.make_emulator({})});
    HostOptions options;
    options.byte_times = true;
    return *EmulatorHost::make(clock, std::move(devices), options);
  }
  gui::Outside outside(const UserFolders& folders) {
    gui::Outside o(
        clock,
        [host = host](Scheduler&, Address address, const std::shared_ptr<BenchAccess>&) {
          return plug_into(host, std::move(address));
        },
        [] {});
    o.ports = &machine;
    o.folders = folders;
    return o;
  }
  void draw(gui::Ui& ui) {
    clock.run_until(Instant(from_seconds(stage.now_s)));
    console.draw(ui);
  }
  void run(double seconds) {
    constexpr double step = 0.05;
    for (double t = 0; t < seconds; t += step) {
      stage.now_s += step - 1.0 / 60;
      stage.frame();
    }
  }
  void open(const std::string& address) {
    const auto opened = console.open(address);
    ASSERT_TRUE(opened) << opened.error().sentence();
    run(4);
    console.show_page("connect");
    run(0.2);
  }
  void click(const std::string& id) {
    MUST(stage.hand.click(id));
    run(0.2);
  }
  std::string value(const std::string& id) { return stage.hand.value(id).value_or("(none)"); }
  /// Of the button with these words; empty: there is none.
  std::string fix(std::string_view label) {
    for (const gui::Widget& w : stage.surface.screen().registry().widgets())
      if (w.id.starts_with("connect/doctor/fix/") && w.label == label) return std::string(w.id);
    return {};
  }
  std::string findings() {
    std::string all;
    for (int i = 1; stage.find(fmt::format("connect/doctor/finding/{}", i)); ++i)
      all += value(fmt::format("connect/doctor/finding/{}", i)) + "\n";
    return all;
  }
  gui::Tab& tab() { return *console.tabs().front(); }
  void switch_power() {
    for (std::size_t i = 0; i < host->device_count(); ++i)
      ASSERT_TRUE(host->bench(i)->operate(bench::PowerCycle()));
  }

  IoContext io;
  VirtualScheduler clock{io};
  std::shared_ptr<EmulatorHost> host;
  Machine machine;
  gui::Console console;
  gui::Stage stage;
};

TEST(LinkDoctorCard, ShowsWhereTheTimeOfAQuestionGoes) {
  Desk d("vxm");
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  EXPECT_EQ(d.value("status/text"),
            "One controller is open. Plug in another controller, type its address, or start an emulator.");
  d.click("connect/here/0/doctor");
  d.run(1);
  EXPECT_THAT(d.value("connect/doctor"), StartsWith("One query takes "));
  EXPECT_THAT(d.value("connect/doctor"), HasSubstr(" ms is possible: "));
  EXPECT_THAT(d.value("connect/doctor/now"), HasSubstr("query 1.0"));
  EXPECT_THAT(d.value("connect/doctor/round_trip"), HasSubstr("queries measured"));
  EXPECT_THAT(d.findings(), HasSubstr("The wire runs at 9600 baud, the controller can do 38400 baud"));
  EXPECT_THAT(d.findings(), HasSubstr("No echo, no second reply, no wrong bytes"));
  d.click("connect/here/0/doctor");
  EXPECT_FALSE(d.stage.find("connect/doctor")) << "the same button folds the card";
}

TEST(LinkDoctorCard, SetsTheTimerOfTheAdapter) {
  Desk d("vxm");
  d.machine.eyes.port.adapter_waits = Millis(16);
  d.machine.eyes.port.adapter_timer_can_be_set = true;
  d.machine.eyes.port.holder = "minicom (process 4182)";
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  d.click("connect/here/0/doctor");
  EXPECT_THAT(d.findings(), HasSubstr("minicom (process 4182) has the port open too"));
  const std::string button = d.fix("Set timer to 1 ms");
  ASSERT_FALSE(button.empty()) << d.findings();
  d.click(button);
  d.run(1.2);
  EXPECT_THAT(d.machine.eyes.asked.back(), "/dev/ttyS9 to 1");
  EXPECT_THAT(d.findings(), HasSubstr("The USB adapter passes bytes on at once"));
}

TEST(LinkDoctorCard, LooksAgainForAnotherProgramOnThePort) {
  Desk d("vxm");
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  d.click("connect/here/0/doctor");
  d.run(1);
  const std::size_t asked = d.machine.eyes.asked.size();
  EXPECT_THAT(d.findings(), HasSubstr("No other program has the port open"));
  d.machine.eyes.port.holder = "minicom (process 4182)";
  d.run(4);
  EXPECT_GT(d.machine.eyes.asked.size(), asked);
  EXPECT_THAT(d.findings(), HasSubstr("minicom (process 4182) has the port open too"));
}

TEST(LinkDoctorCard, RaisesTheRateOfOneThatFollowsAtOnce) {
  Desk d("vxm");
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  d.click("connect/here/0/doctor");
  d.run(1);
  const std::string button = d.fix("Raise to 38400");
  ASSERT_FALSE(button.empty()) << d.findings();
  d.click(button);
  d.run(15);
  EXPECT_EQ(d.value("connect/doctor/raise"), "It answers at 38400 baud, and keeps that rate.");
  EXPECT_EQ(d.tab().address().text(), "vxm@serial:/dev/ttyS9,baud=38400");
  EXPECT_TRUE(d.tab().now().link.connected());
  EXPECT_EQ(d.console.page(), "connect") << "whoever mends a link goes on looking at it";
  EXPECT_EQ(d.fix("Raise to 38400"), "");
}

TEST(LinkDoctorCard, RaisesTheRateOfALineOverItsPowerSwitch) {
  Desk d("dmx-k-sa", {"01", "02"});
  d.open("dmx-k-sa@serial:/dev/ttyS9,baud=9600,id=01-02");
  d.click("connect/here/0/doctor");
  d.run(1);
  const std::string button = d.fix("Raise to 115200");
  ASSERT_FALSE(button.empty()) << d.findings();
  d.click(button);
  d.run(12);
  EXPECT_EQ(d.value("connect/doctor/raise"),
            "Switch the controller off and on. The console asks until it answers.");
  d.switch_power();
  d.run(20);
  EXPECT_EQ(d.value("connect/doctor/raise"), "It answers at 115200 baud, and keeps that rate.");
  ASSERT_EQ(d.console.tabs().size(), 2u);
  for (const auto& tab : d.console.tabs()) EXPECT_TRUE(tab->now().link.connected()) << tab->id();
  EXPECT_THAT(d.findings(), HasSubstr("No echo, no second reply, no wrong bytes"))
      << "what came at the other rate does not count";
}

TEST(LinkDoctorCard, GoesBackToTheOldRateWithoutAnAnswer) {
  Desk d("dmx-k-sa", {"01"});
  d.open("dmx-k-sa@serial:/dev/ttyS9,baud=9600,id=01");
  d.click("connect/here/0/doctor");
  d.run(1);
  d.click(d.fix("Raise to 115200"));
  d.run(12);
  d.click("connect/doctor/back");
  d.run(15);
  EXPECT_EQ(d.value("connect/doctor/raise"),
            "It did not answer at 115200 baud, so it was set back to 9600 baud.");
  EXPECT_TRUE(d.tab().now().link.connected());
  EXPECT_EQ(rate_of(d.tab()), 9600);
  d.switch_power();
  d.run(15);
  EXPECT_TRUE(d.tab().now().link.connected()) << "the stored rate is the old one again";
}

TEST(LinkDoctorCard, OpensFromTheLinkSignOfAController) {
  Desk d("vxm");
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  d.console.activate(d.tab());
  d.run(0.5);
  EXPECT_EQ(d.console.page(), "");
  d.click("link/health");
  d.run(0.5);
  EXPECT_EQ(d.console.page(), "connect");
  EXPECT_TRUE(d.stage.find("connect/doctor"));
}

TEST(ChangeAddress, TriesAnotherPlaceWithoutGoingBack) {
  Desk d("vxm");
  d.open("vxm@tcp:nowhere:1");
  EXPECT_FALSE(d.tab().now().link.connected());
  d.click("connect/here/0/change");
  EXPECT_EQ(d.value("connect/doctor/address"), "vxm@tcp:nowhere:1");
  MUST(d.stage.hand.type("connect/doctor/address", "teapot@stove\n"));
  d.run(0.5);
  EXPECT_THAT(d.value("connect/doctor/refused"), HasSubstr("teapot"));
  ASSERT_EQ(d.console.tabs().size(), 1u);
  EXPECT_EQ(d.tab().address().text(), "vxm@tcp:nowhere:1") << "it stays open where it was";
  MUST(d.stage.hand.type("connect/doctor/address", "vxm@serial:/dev/ttyS9,baud=9600\n"));
  d.run(4);
  ASSERT_EQ(d.console.tabs().size(), 1u);
  EXPECT_EQ(d.tab().address().text(), "vxm@serial:/dev/ttyS9,baud=9600");
  EXPECT_TRUE(d.tab().now().link.connected());
  EXPECT_EQ(d.console.page(), "connect");
}

TEST(ChangeAddress, IsOfferedOnce) {
  const auto offers = [](Desk& d) {
    const auto& all = d.stage.surface.screen().registry().widgets();
    return std::count_if(all.begin(), all.end(),
                         [](const gui::Widget& w) { return w.label == "Change address"; });
  };
  Desk d("vxm");
  d.open("vxm@tcp:nowhere:1");
  EXPECT_EQ(offers(d), 1);
  d.click("connect/here/0/doctor");
  d.run(1.5);
  EXPECT_TRUE(d.stage.find("connect/doctor/finding/1"));
  EXPECT_TRUE(d.stage.find("connect/doctor/address"));
  EXPECT_EQ(offers(d), 1) << "by its row, not by what was found too";
}

TEST(ChangeAddress, APlaceThatAnotherControllerHasIsRefused) {
  Desk d("vxm");
  d.open("vxm@serial:/dev/ttyS9,baud=9600");
  d.open("vxm@tcp:nowhere:1");
  d.click("connect/here/1/change");
  MUST(d.stage.hand.type("connect/doctor/address", "vxm@serial:/dev/ttyS9\n"));
  d.run(0.5);
  EXPECT_THAT(d.value("connect/doctor/refused"), HasSubstr("/dev/ttyS9 is open already, as VXM."));
  EXPECT_EQ(d.console.tabs().size(), 2u);
}

TEST(ServeEmulator, TheOpenOneIsServedAndShowsWhere) {
  Desk d("vxm");
  d.open("vxm@emulator");
  d.click("connect/here/0/serve");
  EXPECT_EQ(d.machine.service.asked, std::vector<std::string>{"vxm@emulator as it is open"});
  EXPECT_EQ(d.value("connect/here/0/tcp"), "127.0.0.1:5801");
  EXPECT_EQ(d.value("connect/here/0/port"), "/tmp/handwheel-vxm");
  EXPECT_THAT(d.value("connect/here/0/clients"), StartsWith("1 program is connected by TCP."));
  d.click("connect/here/0/serve");
  EXPECT_TRUE(d.machine.service.all.empty());
  EXPECT_FALSE(d.stage.find("connect/here/0/tcp"));
}

TEST(ServeEmulator, TheOpenOneWithByteTimesIsNotServed) {  // two would take each other's answers
  for (const char* model : {"vxm", "pmx-4ex-sa", "dmx-k-sa"}) {
    Desk d(model);
    d.open(fmt::format("{}@emulator,wire=real", model));
    const gui::Widget* serve = d.stage.find("connect/here/0/serve");
    ASSERT_TRUE(serve) << model;
    EXPECT_THAT(serve->reason, HasSubstr("Serve another emulator at the right")) << model;
  }
}

TEST(ServeEmulator, OneOfItsOwnIsServedAndCanBeOpenedHere) {
  Desk d("vxm");
  d.console.show_page("connect");
  d.run(0.2);
  d.click("connect/emulator/vxm/serve");
  EXPECT_EQ(d.machine.service.asked, std::vector<std::string>{"vxm@emulator of its own"});
  EXPECT_EQ(d.value("connect/emulator/vxm/tcp"), "127.0.0.1:5801");
  d.click("connect/emulator/vxm");
  ASSERT_EQ(d.console.tabs().size(), 1u);
  EXPECT_EQ(d.tab().address().text(), "vxm@tcp:127.0.0.1:5801");
}

TEST(LastTime, AllIsOpenedAgainAtOnce) {
  const test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  {
    Desk yesterday("vxm", {}, 1440, 900, folders);
    yesterday.open("vxm@emulator");
    yesterday.open("vxm@tcp:127.0.0.1:9");
  }
  Desk d("vxm", {}, 1440, 900, folders);
  d.console.show_page("connect");
  d.run(0.2);
  d.click("connect/open_all");
  ASSERT_EQ(d.console.tabs().size(), 2u);
  EXPECT_EQ(d.tab().address().text(), "vxm@emulator") << "in the order of then";
  d.console.show_page("connect");
  d.run(3);
  const gui::Widget* all = d.stage.find("connect/open_all");
  ASSERT_TRUE(all);
  EXPECT_FALSE(all->enabled);
  EXPECT_EQ(d.stage.find("connect/recent/0")->label, "Show");
}

TEST(LastTime, APlaceOfTheNetworkStandsInTheCentre) {
  const test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  Desk(  // it has been used once
      "vxm", {}, 1440, 900, folders)
      .open("vxm@tcp:127.0.0.1:9");
  Desk d("vxm", {}, 1440, 900, folders);
  d.console.show_page("connect");
  d.run(0.2);
  d.click("connect/place/0");
  ASSERT_EQ(d.console.tabs().size(), 1u);
  EXPECT_EQ(d.tab().address().text(), "vxm@tcp:127.0.0.1:9");
}

TEST(LastTime, OnlyAPortThatWouldBeListedIsReportedAsGone) {
  const test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  {
    Desk yesterday("vxm", {}, 1440, 900, folders);
    yesterday.open("vxm@serial:/dev/ttyUSB7,baud=9600");
    yesterday.open("vxm@serial:/tmp/a-pseudo-terminal,baud=9600");
  }
  Desk d("vxm", {}, 1440, 900, folders);
  gui::FoundPort other;
  other.path = "/dev/ttyS0";
  d.machine.list.push_back(other);
  d.console.show_page("connect");
  d.run(0.2);
  EXPECT_EQ(d.value("connect/recent/0/state"), "") << "a pseudo-terminal is in no list of ports";
  EXPECT_EQ(d.value("connect/recent/1/state"), "not plugged in");
}

TEST(LastTime, ABusHasTheNameOfItsTab) {
  const test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  Desk("dmx-k-sa", {}, 1440, 900, folders).open("dmx-k-sa@serial:/dev/ttyUSB1,baud=9600,id=01-04");
  Desk d("dmx-k-sa", {}, 1440, 900, folders);
  d.console.show_page("connect");
  d.run(0.2);
  ASSERT_TRUE(d.stage.find("connect/recent/0/state"));
  EXPECT_EQ(d.stage.find("connect/recent/0/state")->label, "DMX 01\u201304");
}

int catalogs_made = 0;

TEST(UsualCatalogs, EachIsMadeOnceAndNotInEachFrame) {
  DeviceType counted{};
  counted.model = "counted";
  counted.make_catalog = [](const DeviceOptions&) -> Result<Catalog> {
    ++catalogs_made;
    return Catalog();
  };
  const std::array<DeviceType, 2> types = {counted, counted};
  const UsualCatalogs catalogs(types);
  EXPECT_EQ(catalogs_made, 0) << "a console that shows no connection page makes none";
  for (int frame = 0; frame < 10; ++frame) EXPECT_EQ(catalogs.all().size(), 2u);
  EXPECT_EQ(catalogs_made, 2);
}

TEST(ServeEmulator, ABusThatIsOpenIsServedAsAWhole) {
  Desk d("dmx-k-sa", {"01", "02"});
  d.open("dmx-k-sa@emulator,id=01-02");
  d.click("connect/here/0/serve");
  EXPECT_EQ(d.machine.service.asked, std::vector<std::string>{"dmx-k-sa@emulator,id=01-02 as it is open"});
  EXPECT_EQ(d.value("connect/here/0/tcp"), "127.0.0.1:5801");
  EXPECT_THAT(d.value("connect/here/0/clients"), HasSubstr("It shares the wire with this console"));
}

TEST(ServeEmulator, ABusWithByteTimesReportsWhyItIsNotServed) {
  Desk d("dmx-k-sa", {"01", "02"});
  d.open("dmx-k-sa@emulator,id=01-02,wire=real");
  const gui::Widget* serve = d.stage.find("connect/here/0/serve");
  ASSERT_TRUE(serve);
  EXPECT_FALSE(serve->enabled);
  EXPECT_THAT(std::string(serve->reason), HasSubstr("Serve another emulator at the right"));
}

TEST(ServeEmulator, EndsWhenItsControllerIsClosed) {
  Desk d("vxm");
  d.open("vxm@emulator");
  d.click("connect/here/0/serve");
  ASSERT_FALSE(d.machine.service.all.empty());
  d.console.close(d.tab());
  d.run(0.2);
  EXPECT_TRUE(d.machine.service.all.empty()) << "its switch is gone, too";
}

// To be looked at: build/pictures/doctor-*.png
TEST(LinkDoctorCard, Pictures) {
  const std::filesystem::path folder = HW_BINARY_DIR "/pictures";
  std::filesystem::create_directories(folder);
  for (const auto& [width, height] : {std::pair{1440, 900}, {1366, 768}, {1024, 700}}) {
    Desk d("dmx-k-sa", {"01", "02"}, width, height);
    d.machine.eyes.port.adapter_waits = Millis(16);
    d.machine.eyes.port.adapter_timer_can_be_set = true;
    d.open("dmx-k-sa@serial:/dev/ttyS9,baud=9600,id=01-02");
    d.open("dmx-k-sa@tcp:nowhere:1");
    d.click("connect/emulator/vxm/serve");
    EXPECT_TRUE(d.stage.surface.screenshot((folder / fmt::format("doctor-rows-{}.png", width)).string()));
    d.click("connect/here/0/doctor");
    d.run(1.2);
    EXPECT_TRUE(d.stage.surface.screenshot((folder / fmt::format("doctor-slow-{}.png", width)).string()));
    d.click("connect/here/1/doctor");
    d.run(1.2);
    EXPECT_TRUE(d.stage.surface.screenshot((folder / fmt::format("doctor-failed-{}.png", width)).string()));
  }
}

}  // namespace
}  // namespace hw::panels
