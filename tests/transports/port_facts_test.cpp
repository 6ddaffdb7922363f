#include "transports/port_facts.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace hw {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A machine's /sys, /proc and /dev, as the kernel lays them out.
class PortFacts : public ::testing::Test {
 protected:
  PortFacts() { fs::create_directories(root / "dev"); }
  ~PortFacts() override { fs::remove_all(root); }

  void write(const fs::path& file, const std::string& text) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << text << "\n";
  }
  void open_by(const std::string& process, const std::string& name) {
    write("proc/" + process + "/comm", name);
    fs::create_directories(root / "proc" / process / "fd");
    fs::create_symlink(port, root / "proc" / process / "fd" / "7");
  }

  fs::path root = fs::canonical(fs::temp_directory_path()) / ("hw-port-facts-" + std::to_string(::getpid()));
  std::string port = root / "dev/ttyUSB0", sys = root / "sys", proc = root / "proc";
};

TEST_F(PortFacts, ReadsAndSetsTheLatencyTimer) {
  write("dev/ttyUSB0", "");
  write("sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "16");
  const std::string file = adapter_timer_file(port, sys);
  ASSERT_FALSE(file.empty());
  EXPECT_EQ(read_adapter_timer(file), 16);
  EXPECT_TRUE(may_set_adapter_timer(file));
  EXPECT_TRUE(set_adapter_timer(file, 1));
  EXPECT_EQ(read_adapter_timer(file), 1);
}

TEST_F(PortFacts, FollowsALinkToThePort) {
  write("dev/ttyUSB0", "");
  write("sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "4");
  fs::create_symlink(port, root / "dev/stage");
  EXPECT_EQ(read_adapter_timer(adapter_timer_file(root / "dev/stage", sys)), 4);
}

TEST_F(PortFacts, APortWithoutATimerHasNone) {
  write("dev/ttyS0", "");
  EXPECT_EQ(adapter_timer_file(root / "dev/ttyS0", sys), "");
  EXPECT_FALSE(read_adapter_timer(""));
  EXPECT_FALSE(may_set_adapter_timer(""));
}

TEST_F(PortFacts, ShowsWhatToTypeWhereTheTimerCannotBeSet) {
  const std::string file = root / "no such folder/latency_timer";
  const auto set = set_adapter_timer(file, 1);
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().sentence(), HasSubstr("Type: echo 1 | sudo tee " + file));
}

TEST_F(PortFacts, NamesTheOtherProgramOnThePort) {
  write("dev/ttyUSB0", "");
  fs::create_directories(proc);
  EXPECT_EQ(other_user_of(port, proc), "");
  open_by(std::to_string(::getpid()), "handwheel");
  EXPECT_EQ(other_user_of(port, proc), "") << "this program itself does not count";
  open_by("4182", "minicom");
  EXPECT_EQ(other_user_of(port, proc), "minicom (process 4182)");
}

}  // namespace
}  // namespace hw
