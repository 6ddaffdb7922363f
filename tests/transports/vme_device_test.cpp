// A board's window through a mapped file. The file stands in for a VME device: what a bridge does is memory.
#include "transports/vme_device.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/time/virtual_scheduler.h"
#include "tests/transports/toy_board.h"

namespace hw {
namespace {

using test::WindowEar;
using testing::HasSubstr;

class VmeDeviceTest : public testing::Test {
 protected:
  VmeDeviceTest() : path(testing::TempDir() + "vme_device_test_" + std::to_string(::getpid())) {}
  ~VmeDeviceTest() override { std::filesystem::remove(path); }
  void make_file(std::size_t size) {
    std::ofstream file(path, std::ios::binary);
    file << std::string(size, '\0');
  }
  std::string contents() const {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static Task<> run_and_keep(Window& window, std::vector<BusCycle>& cycles, Result<>& result) {
    result = co_await window.run(cycles);
  }
  Result<> run(Window& window, std::vector<BusCycle>& cycles) {
    Result<> result;
    asio::co_spawn(io, run_and_keep(window, cycles, result), asio::detached);
    clock.run_for(Duration::zero());
    return result;
  }

  IoContext io{1};
  VirtualScheduler clock{io};
  std::string path;
};

TEST_F(VmeDeviceTest, TheWindowLiesAtItsBaseAndIsBigEndian) {
  make_file(0x10000);
  auto window = open_vme_device(clock, path, 0xF000);
  ASSERT_TRUE(window) << window.error().sentence();
  std::vector<BusCycle> burst{BusCycle::store(1, 0xFE1, 0x90), BusCycle::store(2, 0x804, 0x0041),
                              BusCycle::store(4, 0x400, 0x01020304), BusCycle::read(4, 0x400),
                              BusCycle::read(1, 0x403)};
  ASSERT_TRUE(run(**window, burst));
  EXPECT_EQ(burst[3].value, 0x01020304u);
  EXPECT_EQ(burst[4].value, 4u);
  window->reset();
  const std::string file = contents();
  EXPECT_EQ(static_cast<unsigned char>(file[0xFFE1]), 0x90);
  EXPECT_EQ(file[0xF805], 'A');
  EXPECT_EQ(file.substr(0xF400, 4), std::string("\1\2\3\4"));
}

TEST_F(VmeDeviceTest, AFileOfFourKibIsTheWindowItself) {
  make_file(0x1000);
  auto window = open_vme_device(clock, path, 0xF000);
  ASSERT_TRUE(window) << window.error().sentence();
  std::vector<BusCycle> burst{BusCycle::store(1, 0xFFF, 7)};
  ASSERT_TRUE(run(**window, burst));
  window->reset();
  EXPECT_EQ(contents()[0xFFF], 7);
}

TEST_F(VmeDeviceTest, OutsideTheWindowThereIsNoAnswer) {
  make_file(0x1000);
  auto window = open_vme_device(clock, path, 0);
  ASSERT_TRUE(window);
  std::vector<BusCycle> burst{BusCycle::read(1, 0x1000), BusCycle::read(2, 0x0FFF),
                              BusCycle::store(2, 0x1000, 1)};
  ASSERT_TRUE(run(**window, burst));
  EXPECT_EQ(burst[0].value, 0xFFu);
  EXPECT_EQ(burst[1].value, 0xFFFFu);
}

TEST_F(VmeDeviceTest, AWindowThatVanishesIsAFaultAndNoCrash) {
  make_file(0x1000);
  auto window = open_vme_device(clock, path, 0);
  ASSERT_TRUE(window);
  WindowEar ear(**window);
  std::filesystem::resize_file(path, 0);
  std::vector<BusCycle> burst{BusCycle::read(1, 0)};
  const auto done = run(**window, burst);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().kind, FaultKind::lost);
  ASSERT_TRUE(ear.gone);
  EXPECT_THAT(ear.gone->sentence(), HasSubstr("is gone"));
  EXPECT_FALSE(run(**window, burst)) << "it stays gone";
}

TEST_F(VmeDeviceTest, AnUnusableDeviceIsRefusedWithItsReason) {
  auto missing = open_vme_device(clock, path, 0xF000);
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().sentence(), HasSubstr("There is no " + path));
  make_file(100);
  auto small = open_vme_device(clock, path, 0xF000);
  ASSERT_FALSE(small);
  EXPECT_THAT(small.error().sentence(), HasSubstr("100 bytes"));
  auto folder = open_vme_device(clock, "/", 0xF000);
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().sentence(), HasSubstr("folder"));
  auto odd = open_vme_device(clock, path, 0xF123);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().kind, FaultKind::text);
  if (::geteuid() != 0) {
    std::filesystem::permissions(path, std::filesystem::perms::none);
    auto closed = open_vme_device(clock, path, 0);
    ASSERT_FALSE(closed);
    EXPECT_THAT(closed.error().sentence(), HasSubstr("may not open"));
  }
}

TEST_F(VmeDeviceTest, TwoProgramsAtOneBoardAreRefused) {
  make_file(0x1000);
  auto first = open_vme_device(clock, path, 0);
  ASSERT_TRUE(first);
  auto second = open_vme_device(clock, path, 0);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().sentence(), HasSubstr("in use"));
}

// The kernel's device is asked for its window before it is mapped. /dev/zero stands in for it: a device, not
// a file, that can be mapped and read back.
namespace kernel {
unsigned long request;
std::string argument;
int answer;
int listen(int, unsigned long r, void* a) {
  request = r;
  argument.assign(static_cast<const char*>(a), 32);
  if (answer == 0) return 0;
  errno = answer;
  return -1;
}
}  // namespace kernel

TEST_F(VmeDeviceTest, TheKernelIsAskedForTheShortSpace) {
  const auto open = [this](int answer) {
    kernel::answer = answer;
    auto window = open_vme_device(clock, "/dev/zero", 0, kernel::listen);
    // Another run of this test may hold it for a moment.
    for (int i = 0; i < 100 && !window && window.error().what.find("in use") != std::string::npos; ++i) {
      ::usleep(50'000);
      window = open_vme_device(clock, "/dev/zero", 0, kernel::listen);
    }
    return window;
  };
  {
    auto window = open(0);
    ASSERT_TRUE(window) << window.error().sentence();
    EXPECT_EQ(kernel::request, 0x4020AE04u) << "_IOW(0xAE, 4, 32 bytes): VME_SET_MASTER";
    std::array<std::uint32_t, 8> words{};  // packed: 32, 64, 64, 32, 32, 32 bits, as this computer counts
    ASSERT_EQ(sizeof words, kernel::argument.size());
    std::memcpy(words.data(), kernel::argument.data(), sizeof words);
    EXPECT_THAT(words, testing::ElementsAre(1u, 0u, 0u, 0x10000u, 0u, 0x1u, 0x9001u, 0x2u))
        << "on, from 0, 64 KiB, A16, single supervisory data cycles, D16";
    EXPECT_FALSE((*window)->reports_interrupts());
    std::vector<BusCycle> burst{BusCycle::store(2, 0x804, 0x41), BusCycle::read(2, 0x804)};
    ASSERT_TRUE(run(**window, burst));
    EXPECT_EQ(burst[1].value, 0x41u);
  }
  EXPECT_TRUE(open(ENOTTY)) << "a device that has no such request: it is mapped as it is";
  const auto refused = open(EBUSY);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("no window onto the short address space"));
  EXPECT_THAT(refused.error().sentence(), HasSubstr("m1"));
}

}  // namespace
}  // namespace hw
