#include "transports/rfc2217.h"

#include <boost/asio/ip/tcp.hpp>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <spawn.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "core/base/asio.h"
#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "transports/tcp_endpoint.h"
#include "transports/tty.h"

namespace hw {
namespace {

using test::Ear;
using test::poll_until;
using test::run_task;

class Rfc2217 : public ::testing::Test {
 protected:
  IoContext io{1};
  RealScheduler clock{io};
};

/// A real ser2net in front of a pty, whose master plays the controller.
class Ser2net : public Rfc2217 {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/sbin/ser2net")) GTEST_SKIP() << "ser2net is not installed";
    HW_NEEDS_PSEUDO_TERMINAL();
    char name[64];
    ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
    ::fcntl(master, F_SETFL, O_NONBLOCK);
    where = "127.0.0.1:" + std::to_string(free_port());
    const std::string config = "%YAML 1.1\n---\nconnection: &c\n  accepter: telnet(rfc2217),tcp," +
                               where.substr(0, where.find(':')) + "," + where.substr(where.find(':') + 1) +
                               "\n  connector: serialdev," + name + ",9600n81,local\n";
    file = std::filesystem::temp_directory_path() / ("hw-ser2net-" + std::to_string(::getpid()) + ".yaml");
    std::ofstream(file) << config;
    std::string words[] = {"ser2net", "-n", "-u", "-c", file};
    char* argv[] = {words[0].data(), words[1].data(), words[2].data(),
                    words[3].data(), words[4].data(), nullptr};
    ASSERT_EQ(::posix_spawn(&server, "/usr/sbin/ser2net", nullptr, nullptr, argv, environ), 0);
  }
  void TearDown() override {
    if (server > 0) {
      ::kill(server, SIGKILL);
      ::waitpid(server, nullptr, 0);
    }
    if (master >= 0) ::close(master), ::close(slave);
    std::filesystem::remove(file);
  }
  int free_port() {
    asio::ip::tcp::acceptor probe(io, asio::ip::tcp::endpoint(asio::ip::address_v4::loopback(), 0));
    return probe.local_endpoint().port();
  }
  std::unique_ptr<Stream> open(int baud) {
    for (int tries = 0;; ++tries) {  // until the server is up
      auto stream = run_task(io, open_rfc2217(clock, where, baud));
      if (stream) return std::move(*stream);
      if (tries == 100 || stream.error().what.find("nothing listens") == std::string::npos) {
        ADD_FAILURE() << stream.error().sentence();
        return nullptr;
      }
      poll_until(
          io, [] { return false; }, Millis(20));
    }
  }
  int rate_of_port() const {
    termios settings{};
    ::tcgetattr(master, &settings);
    return baud_of(::cfgetospeed(&settings));
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

  int master = -1, slave = -1;
  pid_t server = -1;
  std::string where, file;
};

TEST_F(Ser2net, SetsTheRateWhenItOpens) {
  auto stream = open(38400);
  ASSERT_TRUE(stream);
  EXPECT_EQ(rate_of_port(), 38400);
  termios settings{};
  ::tcgetattr(master, &settings);
  EXPECT_EQ(settings.c_cflag & (CSIZE | PARENB | CSTOPB), static_cast<tcflag_t>(CS8));
  EXPECT_EQ(stream->describe(), "rfc2217:" + where + ", 38400 baud");
}

TEST_F(Ser2net, CarriesEveryByteBothWays) {
  auto stream = open(9600);
  ASSERT_TRUE(stream);
  Ear ear(*stream);
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  stream->send(all);
  EXPECT_EQ(read_master(256), all);
  ASSERT_EQ(::write(master, all.data(), all.size()), 256);
  EXPECT_TRUE(poll_until(io, [&] { return ear.received.size() >= 256; }));
  EXPECT_EQ(ear.received, all);
}

TEST_F(Ser2net, ChangesTheRateLater) {
  auto stream = open(9600);
  ASSERT_TRUE(stream);
  Ear ear(*stream);
  for (const int baud : {38400, 19200, 115200}) {
    ASSERT_TRUE(stream->set_rate(baud));
    EXPECT_TRUE(poll_until(io, [&] { return rate_of_port() == baud; })) << baud;
    EXPECT_EQ(stream->rate(), baud);
  }
  stream->send("V");
  EXPECT_EQ(read_master(1), "V");
  EXPECT_FALSE(ear.closed);
}

TEST_F(Ser2net, TheServerGoingAwayIsReported) {
  auto stream = open(9600);
  ASSERT_TRUE(stream);
  Ear ear(*stream);
  ::kill(server, SIGKILL);
  ASSERT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  EXPECT_EQ(ear.closed->kind, FaultKind::lost);
}

/// Servers that answer something else, played by the test.
class OddServer : public Rfc2217 {
 protected:
  Result<std::unique_ptr<Stream>> open_against(std::function<void(Stream&, Ear&)> answer,
                                               Millis patience = Millis(200)) {
    Ear ear;
    std::unique_ptr<Stream> accepted;
    auto endpoint = *TcpEndpoint::open(clock, "127.0.0.1:0", false, [&](std::unique_ptr<Stream> s) {
      accepted = std::move(s);
      accepted->listen(&ear);
      ear.on_bytes = [&] { answer(*accepted, ear); };
    });
    where = endpoint->address();
    return run_task(io, open_rfc2217(clock, where, 9600, patience));
  }
  std::string where;
};

TEST_F(OddServer, OneThatRefuses) {
  const auto stream = open_against([](Stream& s, Ear&) { s.send("\xFF\xFE\x2C"); }, Millis(5000));
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().what, where + " does not speak RFC 2217.");
  EXPECT_NE(stream.error().advice.find("tcp:" + where), std::string::npos);
}

TEST_F(OddServer, OneThatKnowsNoTelnet) {
  const auto stream = open_against([](Stream& s, Ear&) { s.send("login:"); });
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().what, where + " does not speak RFC 2217.");
}

TEST_F(OddServer, OneThatHangsUp) {
  std::unique_ptr<Stream> accepted;
  auto endpoint =
      *TcpEndpoint::open(clock, "127.0.0.1:0", false, [&](std::unique_ptr<Stream> s) { s.reset(); });
  const auto stream = run_task(io, open_rfc2217(clock, endpoint->address(), 9600));
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().kind, FaultKind::lost);
}

TEST_F(OddServer, OneThatAgreesAndThenIsSilent) {
  const auto stream = open_against([](Stream& s, Ear&) { s.send("\xFF\xFD\x2C"); });
  ASSERT_FALSE(stream);
  EXPECT_NE(stream.error().what.find("did not confirm"), std::string::npos);
}

TEST_F(OddServer, OneThatHasAnotherRate) {
  const auto stream = open_against([](Stream& s, Ear&) {
    s.send(std::string("\xFF\xFD\x2C\xFF\xFA\x2C\x65\0\0\x04\xB0\xFF\xF0", 13));
    s.send("\xFF\xFA\x2C\x66\x08\xFF\xF0\xFF\xFA\x2C\x67\x01\xFF\xF0\xFF\xFA\x2C\x68\x01\xFF\xF0");
  });
  ASSERT_FALSE(stream);
  EXPECT_NE(stream.error().what.find("does not accept 9600 baud (it uses 1200)"), std::string::npos)
      << stream.error().sentence();
}

std::string rate_answer(int baud) {
  std::string answer("\xFF\xFA\x2C\x65");
  for (int shift = 24; shift >= 0; shift -= 8) answer += static_cast<char>(baud >> shift & 0xFF);
  return answer + "\xFF\xF0";
}

// Its answer to the first rate comes when the second was asked for already.
TEST_F(OddServer, OneThatAnswersLate) {
  std::unique_ptr<Stream> server;
  Ear questions;
  auto endpoint = *TcpEndpoint::open(clock, "127.0.0.1:0", false, [&](std::unique_ptr<Stream> s) {
    server = std::move(s);
    server->listen(&questions);
    server->send("\xFF\xFD\x2C" + rate_answer(9600) +
                 "\xFF\xFA\x2C\x66\x08\xFF\xF0\xFF\xFA\x2C\x67\x01\xFF\xF0\xFF\xFA\x2C\x68\x01\xFF\xF0");
  });
  const auto stream = run_task(io, open_rfc2217(clock, endpoint->address(), 9600));
  ASSERT_TRUE(stream);
  Ear ear(**stream);
  const auto answers = [&](int baud) {
    server->send(rate_answer(baud) + "!");
    const std::size_t received = ear.received.size();
    poll_until(io, [&] { return ear.closed || ear.received.size() > received; });
  };
  ASSERT_TRUE((*stream)->set_rate(38400));
  ASSERT_TRUE((*stream)->set_rate(19200));
  answers(38400);
  answers(19200);
  EXPECT_FALSE(ear.closed) << ear.closed->sentence();
  ASSERT_TRUE((*stream)->set_rate(115200));
  answers(9600);
  poll_until(io, [&] { return ear.closed.has_value(); });
  ASSERT_TRUE(ear.closed);
  EXPECT_NE(ear.closed->what.find("does not accept 115200 baud (it uses 9600)"), std::string::npos);
}

}  // namespace
}  // namespace hw
