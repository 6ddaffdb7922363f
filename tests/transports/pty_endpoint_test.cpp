#include "transports/pty_endpoint.h"

#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "tests/transports/toy_emulator.h"
#include "transports/serve.h"

namespace hw {
namespace {

using test::poll_until;

class PtyEndpoint : public ::testing::Test {
 protected:
  PtyEndpoint() { std::filesystem::create_directories(folder); }
  void SetUp() override { HW_NEEDS_PSEUDO_TERMINAL(); }
  ~PtyEndpoint() override {
    host.reset();
    std::filesystem::remove_all(folder);
  }
  void serve(bool byte_times = false) {
    HostOptions options;
    options.byte_times = byte_times;
    host = *EmulatorHost::make(clock, std::make_unique<test::ToyEmulator>(), options);
    host->attach(std::move(*open_pty_endpoint(clock, link, 9600)));
  }
  int open_client(int flags = O_RDWR) { return ::open(link.c_str(), flags | O_NOCTTY | O_NONBLOCK); }
  std::string read_client(int fd, std::size_t enough, Millis patience = Millis(2000)) {
    std::string got;
    poll_until(
        io,
        [&] {
          char part[256];
          if (const ssize_t n = ::read(fd, part, sizeof part); n > 0)
            got.append(part, static_cast<std::size_t>(n));
          return got.size() >= enough;
        },
        patience);
    return got;
  }
  std::string ask(int fd, std::string_view question, std::size_t enough) {
    EXPECT_EQ(::write(fd, question.data(), question.size()), static_cast<ssize_t>(question.size()));
    return read_client(fd, enough);
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hw-pty-" + std::to_string(::getpid()));
  std::string link = folder / "stage";
  IoContext io{1};
  RealScheduler clock{io};
  std::shared_ptr<EmulatorHost> host;
};

TEST_F(PtyEndpoint, IsRawFromTheStart) {
  serve();
  const int fd = open_client();
  EXPECT_EQ(ask(fd, "X", 9), "+0000400\r");  // CR not turned into LF, nothing echoed
  termios settings{};
  ::tcgetattr(fd, &settings);
  EXPECT_EQ(settings.c_lflag & (ECHO | ICANON | ISIG), 0u);
  EXPECT_EQ(::cfgetospeed(&settings), static_cast<speed_t>(B9600));
  ::close(fd);
}

TEST_F(PtyEndpoint, SurvivesClientsThatComeAndGo) {
  serve();
  for (int i = 0; i < 20; ++i) {
    const int fd = open_client();
    ASSERT_GE(fd, 0);
    EXPECT_EQ(ask(fd, "V", 1), "R") << i;
    ::close(fd);
    if (i % 3 == 0)
      poll_until(
          io, [] { return false; }, Millis(5));
  }
}

TEST_F(PtyEndpoint, EachOfTwoClientsIsServed) {
  serve();
  const int a = open_client(), b = open_client();
  EXPECT_EQ(ask(a, "V", 1), "R");
  ::close(a);
  EXPECT_EQ(ask(b, "X", 9), "+0000400\r");
  ::close(b);
}

TEST_F(PtyEndpoint, BytesWithoutAReaderAreLost) {
  serve();
  int fd = open_client();
  ASSERT_EQ(::write(fd, "M", 1), 1);  // the prompt comes 100 ms later
  ::close(fd);
  poll_until(
      io, [] { return false; }, Millis(150));
  fd = open_client();
  EXPECT_EQ(ask(fd, "V", 1), "R");
  ::close(fd);
}

TEST_F(PtyEndpoint, AReplyLeftUnreadByAClientIsNotReadByTheNext) {
  serve();
  int fd = open_client();
  ASSERT_EQ(::write(fd, "X", 1), 1);
  poll_until(io, [&] {
    int n = 0;
    return ::ioctl(fd, FIONREAD, &n) == 0 && n == 9;
  });
  ::close(fd);
  poll_until(
      io, [] { return false; }, Millis(5));
  fd = open_client();
  EXPECT_EQ(ask(fd, "V", 1), "R");
  ::close(fd);
}

TEST_F(PtyEndpoint, ACookedExclusiveClientLeavesNoTrace) {
  serve();
  int fd = open_client();
  termios cooked{};
  ::tcgetattr(fd, &cooked);
  cooked.c_lflag |= ECHO | ICANON;
  cooked.c_oflag |= OPOST | ONLCR;
  ::tcsetattr(fd, TCSANOW, &cooked);
  ::ioctl(fd, TIOCEXCL);
  ::close(fd);
  poll_until(
      io, [] { return false; }, Millis(5));
  fd = open_client();
  int exclusive = 1;
  ASSERT_EQ(::ioctl(fd, TIOCGEXCL, &exclusive), 0);
  EXPECT_EQ(exclusive, 0);
  EXPECT_EQ(ask(fd, "X", 9), "+0000400\r");
  ::close(fd);
}

TEST_F(PtyEndpoint, AClientAtAnotherRateGetsGarbage) {
  serve(true);
  const int fd = open_client();
  EXPECT_EQ(ask(fd, "V", 1), "R");
  termios settings{};
  ::tcgetattr(fd, &settings);
  ::cfsetspeed(&settings, B38400);
  ::tcsetattr(fd, TCSANOW, &settings);
  ASSERT_EQ(::write(fd, "V", 1), 1);
  EXPECT_EQ(read_client(fd, 1, Millis(30)), "");
  const auto& received = static_cast<const test::ToyEmulator&>(host->bench()->emulator()).received();
  EXPECT_GT(received.size(), 1u);
  EXPECT_EQ(received.find('V', 1), std::string::npos);
  ::close(fd);
}

TEST_F(PtyEndpoint, AClientThatNeverReadsDoesNotStopTheOthers) {
  serve();
  const int deaf = open_client();
  auto end = *host->plug_in();
  test::Ear ear(*end);
  for (int i = 0; i < 2000; ++i) end->send("X");
  EXPECT_TRUE(poll_until(io, [&] { return ear.received.size() == 2000 * 9; }));
  ::close(deaf);
}

TEST_F(PtyEndpoint, TheLinkGoesWithIt) {
  serve();
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  host.reset();
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST_F(PtyEndpoint, AStaleLinkIsReplacedAFileIsNot) {
  std::filesystem::create_symlink("/dev/pts/no-longer", link);
  EXPECT_TRUE(open_pty_endpoint(clock, link, 9600));
  std::ofstream(link) << "my notes";
  const auto refused = open_pty_endpoint(clock, link, 9600);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("there is a file of that name"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_regular_file(link));
}

TEST_F(PtyEndpoint, AFolderThatDoesNotExist) {
  const auto refused = open_pty_endpoint(clock, folder / "no" / "stage", 9600);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("folder"), std::string::npos);
}

}  // namespace
}  // namespace hw
