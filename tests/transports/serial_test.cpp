#include "transports/serial.h"

#include <fstream>

#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "transports/port_holder.h"
#include "transports/tty.h"

namespace hw {
namespace {

using test::Ear;
using test::poll_until;

// The controller's end is the master of a pty, the port its slave.
class Serial : public ::testing::Test {
 protected:
  void SetUp() override {
    HW_NEEDS_PSEUDO_TERMINAL();
    int slave = -1;
    char name[64];
    ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
    port = name;
    ::close(slave);
    ::fcntl(master, F_SETFL, O_NONBLOCK);
  }
  ~Serial() override {
    if (master >= 0) ::close(master);
  }

  std::string read_master(std::size_t enough) {
    std::string got;
    poll_until(io, [&] {
      char part[256];
      if (const ssize_t n = ::read(master, part, sizeof part); n > 0)
        got.append(part, static_cast<std::size_t>(n));
      return got.size() >= enough;
    });
    return got;
  }
  std::string refusal_sentence(const std::string& path, PortRefusal expected) {
    PortRefusal sentence = PortRefusal::none;
    const auto stream = open_serial(clock, path, 9600, &sentence);
    EXPECT_FALSE(stream);
    EXPECT_EQ(sentence, expected);
    if (stream) return {};
    EXPECT_EQ(stream.error().kind, FaultKind::port);
    EXPECT_EQ(stream.error().done, "Nothing was sent.");
    return stream.error().sentence();
  }

  IoContext io{1};
  RealScheduler clock{io};
  int master = -1;
  std::string port;
};

TEST_F(Serial, CarriesEveryByteBothWaysUnchanged) {
  auto stream = *open_serial(clock, port, 9600);
  Ear ear(*stream);
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  stream->send(all);
  EXPECT_EQ(read_master(256), all);
  ASSERT_EQ(::write(master, all.data(), all.size()), 256);
  EXPECT_TRUE(poll_until(io, [&] { return ear.received.size() == 256; }));
  EXPECT_EQ(ear.received, all);
}

TEST_F(Serial, HasEveryRate) {
  auto stream = *open_serial(clock, port, 9600);
  for (const int baud : {300, 1200, 9600, 19200, 38400, 57600, 115200}) {
    ASSERT_TRUE(stream->set_rate(baud)) << baud;
    termios settings{};
    ::tcgetattr(master, &settings);
    EXPECT_EQ(baud_of(::cfgetospeed(&settings)), baud);
    EXPECT_EQ(settings.c_cflag & (CSIZE | PARENB | CSTOPB | CRTSCTS), static_cast<tcflag_t>(CS8));
    EXPECT_EQ(settings.c_iflag & (IXON | IXOFF), 0u);
    EXPECT_EQ(stream->rate(), baud);
  }
  EXPECT_EQ(stream->describe(), port + ", 115200 baud");
}

TEST_F(Serial, AnUnknownRateIsRefusedAndTheOldOneStays) {
  auto stream = *open_serial(clock, port, 9600);
  const auto set = stream->set_rate(12345);
  ASSERT_FALSE(set);
  EXPECT_NE(set.error().what.find("12345"), std::string::npos);
  EXPECT_EQ(stream->rate(), 9600);
  EXPECT_FALSE(open_serial(clock, port + "", 7));
}

// These run as root in most test machines, whom TIOCEXCL alone does not bind.
TEST_F(Serial, TheSecondOfTwoOpensIsRefused) {
  auto first = open_serial(clock, port, 9600);
  ASSERT_TRUE(first);
  const std::string sentence = refusal_sentence(port, PortRefusal::busy);
  EXPECT_NE(sentence.find(port), std::string::npos);
  EXPECT_NE(sentence.find("this program itself"), std::string::npos);
  first->reset();
  EXPECT_TRUE(open_serial(clock, port, 9600));
}

TEST_F(Serial, SetsTheKernelsExclusiveModeAndClearsIt) {
  const int other = ::open(port.c_str(), O_RDWR | O_NOCTTY);
  auto stream = open_serial(clock, port, 9600);
  int exclusive = 0;
  ::ioctl(other, TIOCGEXCL, &exclusive);
  EXPECT_EQ(exclusive, 1);
  stream->reset();
  ::ioctl(other, TIOCGEXCL, &exclusive);
  EXPECT_EQ(exclusive, 0);
  ::close(other);
}

TEST_F(Serial, TheProgramThatHoldsItIsNamed) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const int fd = ::open(port.c_str(), O_RDWR | O_NOCTTY);
    ::flock(fd, LOCK_EX);
    (void)!::write(ready[1], "x", 1);
    ::pause();
    ::_exit(0);
  }
  char c;
  ASSERT_EQ(::read(ready[0], &c, 1), 1);
  const std::string sentence = refusal_sentence(port, PortRefusal::busy);
  std::string self;
  std::ifstream comm("/proc/self/comm");
  std::getline(comm, self);
  EXPECT_NE(sentence.find(self + " (process " + std::to_string(holder) + ") holds it"), std::string::npos)
      << sentence;
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  ::close(ready[0]), ::close(ready[1]);
}

TEST_F(Serial, APortThatDoesNotExist) {
  const std::string sentence = refusal_sentence("/dev/ttyUSB77", PortRefusal::missing);
  EXPECT_NE(sentence.find("no port /dev/ttyUSB77"), std::string::npos);
  EXPECT_NE(sentence.find("handwheel scan"), std::string::npos);
}

TEST_F(Serial, ADeviceOrFolderThatIsNoSerialPortIsRefused) {
  EXPECT_NE(refusal_sentence("/dev/null", PortRefusal::not_serial).find("not a serial port"),
            std::string::npos);
  EXPECT_NE(refusal_sentence("/tmp", PortRefusal::not_serial).find("not a serial port"), std::string::npos);
}

TEST_F(Serial, ThePermissionSentenceNamesGroupAndCommand) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to give the port to a group";
  const group* dialout = ::getgrnam("dialout");
  ASSERT_TRUE(dialout);
  ASSERT_EQ(::chown(port.c_str(), 0, dialout->gr_gid), 0);
  ASSERT_EQ(::chmod(port.c_str(), 0660), 0);
  ASSERT_EQ(::seteuid(65534), 0);  // nobody
  const std::string sentence = refusal_sentence(port, PortRefusal::not_permitted);
  ASSERT_EQ(::seteuid(0), 0);
  EXPECT_NE(sentence.find("the group dialout"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("`sudo usermod -aG dialout nobody`"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("log out and in again"), std::string::npos);
}

TEST_F(Serial, AGroupWithoutRightsIsNotAdvised) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root to take the rights away";
  ASSERT_EQ(::chown(port.c_str(), 0, 0), 0);
  ASSERT_EQ(::chmod(port.c_str(), 0600), 0);
  ASSERT_EQ(::seteuid(65534), 0);
  const std::string sentence = refusal_sentence(port, PortRefusal::not_permitted);
  ASSERT_EQ(::seteuid(0), 0);
  EXPECT_EQ(sentence.find("usermod"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("chgrp dialout"), std::string::npos) << sentence;
}

TEST_F(Serial, APulledCableIsReported) {
  auto stream = *open_serial(clock, port, 9600);
  Ear ear(*stream);
  ear.on_close = [&] { stream.reset(); };
  ::close(master);
  ASSERT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  master = -1;
  EXPECT_EQ(ear.closed->kind, FaultKind::lost);
  EXPECT_NE(ear.closed->what.find(port), std::string::npos);
  EXPECT_NE(ear.closed->what.find("pulled"), std::string::npos);
}

TEST_F(Serial, SendingAfterThePullIsHarmless) {
  auto stream = *open_serial(clock, port, 9600);
  Ear ear(*stream);
  ::close(master);
  master = -1;
  stream->send("X");
  EXPECT_FALSE(ear.closed) << "never from inside a call";
  EXPECT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  stream->send("X");
  EXPECT_FALSE(stream->set_rate(9600));
}

TEST_F(Serial, BytesFromBeforeTheOpeningAreNotRead) {
  const int early = ::open(port.c_str(), O_RDWR | O_NOCTTY);
  termios raw{};
  ::tcgetattr(early, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(early, TCSANOW, &raw);
  ASSERT_EQ(::write(master, "old", 3), 3);
  auto stream = *open_serial(clock, port, 9600);
  ::close(early);
  Ear ear(*stream);
  ASSERT_EQ(::write(master, "new", 3), 3);
  ASSERT_TRUE(poll_until(io, [&] { return !ear.received.empty(); }));
  EXPECT_EQ(ear.received, "new");
}

TEST_F(Serial, AFloodArrivesWhole) {
  auto stream = *open_serial(clock, port, 115200);
  Ear ear(*stream);
  const std::string block(2048, 'x');
  std::size_t sent = 0;
  const bool whole = poll_until(
      io,
      [&] {
        if (sent < 4'000'000)
          if (const ssize_t n = ::write(master, block.data(), block.size()); n > 0)
            sent += static_cast<std::size_t>(n);
        return sent >= 4'000'000 && ear.received.size() == sent;
      },
      Millis(8000));
  EXPECT_TRUE(whole);
}

TEST(PortHolder, NamesNoHolderOfAFreePort) {
  EXPECT_EQ(port_holder("/dev/full", "/proc/self/no-such-folder"), "");
  EXPECT_EQ(port_holder("/dev/ttyUSB77"), "");
}

}  // namespace
}  // namespace hw
