// The search for devices on a shared line, with emulated ones behind a pseudo-terminal.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/time/real_scheduler.h"
#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "transports/pty_endpoint.h"
#include "transports/scan.h"
#include "transports/serve.h"

namespace hw {
namespace {

using test::run_task;
using testing::ElementsAre;
using testing::HasSubstr;

class SearchOnALine : public ::testing::Test {
 protected:
  SearchOnALine() { std::filesystem::create_directories(folder); }
  void SetUp() override { HW_NEEDS_PSEUDO_TERMINAL(); }
  ~SearchOnALine() override { std::filesystem::remove_all(folder); }

  /// A line of DMX-K-SA whose rate was stored before. Names that are equal: as they come out of a careless
  /// broadcast.
  void serve(const std::vector<std::string>& ids, int baud_code = 3) {
    std::vector<HostedDevice> devices;
    for (const std::string& id : ids) {
      auto emulator = find_device_type("dmx-k-sa")->make_emulator({{"id", id}}).value();
      emulator->receive("@" + id + "DB=" + std::to_string(baud_code) + "\r@" + id + "STORE\r");
      ASSERT_TRUE(emulator->operate(bench::PowerCycle()));
      std::string sentence;
      emulator->take_output(sentence);
      devices.push_back(HostedDevice{id, std::move(emulator)});
    }
    HostOptions options;
    options.byte_times = true;
    host = *EmulatorHost::make(clock, std::move(devices), options);
    host->attach(std::move(*open_pty_endpoint(clock, folder / "line", host->bench()->emulator().rate())));
  }
  DeviceSearch what(std::vector<int> bauds, int first, int last) {
    DeviceSearch search;
    SerialPort port;
    port.path = folder / "line";
    search.ports = {port};
    search.bauds = std::move(bauds);
    search.first_id = first, search.last_id = last;
    return search;
  }
  std::vector<PortReport> search(DeviceSearch search) {
    std::function<bool(const SearchProgress&)> go_on = [this](const SearchProgress& at) {
      last = at;
      return !end_it || !end_it(at);
    };
    std::function<void(const PortReport&)> on_report = [this](const PortReport& r) {
      reported.push_back(r.sentence());
    };
    return run_task(io, search_devices(clock, std::move(search), go_on, on_report), Millis(30'000));
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hw-search-" + std::to_string(::getpid()));
  IoContext io{1};
  RealScheduler clock{io};
  std::shared_ptr<EmulatorHost> host;
  std::function<bool(const SearchProgress&)> end_it;
  std::vector<std::string> reported;
  SearchProgress last;
};

TEST_F(SearchOnALine, FindsEachDeviceWithItsIdAndRate) {
  serve({"07", "11"});
  const auto found = search(what({9600, 38400}, 5, 12));
  ASSERT_EQ(found.size(), 2u);
  const std::string line = folder / "line";
  EXPECT_EQ(found[0].address(), "dmx-k-sa@serial:" + line + ",baud=38400,id=07");
  EXPECT_EQ(found[1].address(), "dmx-k-sa@serial:" + line + ",baud=38400,id=11");
  EXPECT_THAT(reported, ElementsAre(HasSubstr("with id 07 answers at 38400 baud"), HasSubstr("with id 11")));
  EXPECT_EQ(last.of, 16);
  for (std::size_t i = 0; i < host->device_count(); ++i) {
    BenchView view;
    host->bench(i)->look(view);
    EXPECT_EQ(view.load_position[0], Steps(0)) << "asking moves nothing";
  }
}

TEST_F(SearchOnALine, WithoutAnAnswerNothingIsFound) {
  serve({"07"});
  EXPECT_TRUE(search(what({38400}, 20, 23)).empty());
  EXPECT_TRUE(reported.empty());
  EXPECT_EQ(last.asked, 3) << "told before the last of four";
}

TEST_F(SearchOnALine, IsEndedByItsCaller) {
  serve({"07", "11"});
  end_it = [](const SearchProgress& at) { return at.id == "09"; };
  const auto found = search(what({38400}, 5, 99));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().id, "07");
}

TEST_F(SearchOnALine, APortThatIsNotThereIsReported) {
  DeviceSearch nowhere = what({38400}, 1, 2);
  nowhere.ports.front().path = "/dev/ttyUSB77";
  EXPECT_TRUE(search(std::move(nowhere)).empty());
  EXPECT_THAT(reported, ElementsAre(HasSubstr("/dev/ttyUSB77")));
}

}  // namespace
}  // namespace hw
