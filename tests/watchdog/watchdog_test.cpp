// A console that dies, or stands still, in the middle of a held jog: the watchdog stops the axis. In
// wall-clock time, with a process to kill and emulated controllers on TCP, a bus port and a shared memory.
#include <array>
#include <csignal>
#include <fstream>

#include <fcntl.h>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/time/real_scheduler.h"
#include "transports/open.h"
#include "transports/tcp_endpoint.h"
#include "transports/watchdog/will_message.h"

namespace hw {
namespace {

/// The console in short, see jog_holder.cpp.
class Holder {
 public:
  explicit Holder(const std::string& address) {
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    std::string program = HW_JOG_HOLDER, where = address, watchdog = HW_WATCHDOG;
    char* const words[] = {program.data(), where.data(), watchdog.data(), nullptr};
    EXPECT_EQ(::posix_spawn(&child_, HW_JOG_HOLDER, &files, nullptr, words, environ), 0);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    sent_ = ends[0];
    ::fcntl(sent_, F_SETFL, O_NONBLOCK);
  }
  ~Holder() {
    send_signal(SIGKILL);
    ::waitpid(child_, nullptr, 0);
    ::close(sent_);
  }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;
  void send_signal(int signal) const { ::kill(child_, signal); }
  [[nodiscard]] const std::string& words() {
    char buffer[256];
    for (ssize_t n = 0; (n = ::read(sent_, buffer, sizeof buffer)) > 0;)
      received_.append(buffer, static_cast<std::size_t>(n));
    return received_;
  }

 private:
  pid_t child_ = 0;
  int sent_ = -1;
  std::string received_;
};

class Watchdog : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const DeviceType* type = find_device_type(GetParam());
    ASSERT_NE(type, nullptr);
    DeviceOptions keys{{"wire", "off"}};
    const auto catalog = type->make_catalog({});
    if (catalog->addressed()) keys["unaddressed"] = "yes";
    const bool board = catalog->can.window;
    auto made = make_emulator_host(scheduler, *type, keys, {}, {});
    ASSERT_TRUE(made) << made.error().sentence();
    host = *made;
    auto served =
        TcpEndpoint::open(scheduler, "127.0.0.1:0", false, [this, board](std::unique_ptr<Stream> client) {
          board ? host->attach_bus(std::move(client)) : host->attach(std::move(client));
        });
    ASSERT_TRUE(served) << served.error().sentence();
    endpoint = std::move(*served);
    address = fmt::format("{}@{}:{}", GetParam(), board ? "bus" : "tcp", endpoint->address());
  }
  void run_for(Duration time) {
    const Instant until = scheduler.now() + time;
    while (scheduler.now() < until) io.run_one_for(std::chrono::milliseconds(2));
  }
  template <class Done>
  bool run_until(Done done, Duration patience) {
    const Instant until = scheduler.now() + patience;
    while (!done() && scheduler.now() < until) io.run_one_for(std::chrono::milliseconds(2));
    return done();
  }
  double place() {
    BenchView view;
    host->bench()->look(view);
    return static_cast<double>(view.load_position[0].value);
  }
  bool moves() {
    const double before = place();
    run_for(Millis(30));
    return place() != before;
  }
  void jog(Holder& holder) {
    ASSERT_TRUE(
        run_until([&] { return holder.words().find("jogging, watched") != std::string::npos; }, Millis(8000)))
        << holder.words();
    run_for(Millis(300));
    ASSERT_TRUE(moves());
  }
  /// Milliseconds until it stands, from now; -1: it does not.
  int stands_after(Duration patience) {
    const Instant began = scheduler.now();
    Instant last_moved = began;
    while (scheduler.now() - began < patience) {
      if (moves())
        last_moved = scheduler.now();
      else if (scheduler.now() - last_moved > Millis(400))
        return static_cast<int>(std::chrono::duration_cast<Millis>(last_moved - began).count());
    }
    return -1;
  }

  IoContext io{1};
  RealScheduler scheduler{io};
  std::shared_ptr<EmulatorHost> host;
  std::unique_ptr<TcpEndpoint> endpoint;
  std::string address;
  /// The longest ramp of the four as they are delivered, and what a loaded machine needs.
  static constexpr int ramp_ms = 700;
};

TEST_P(Watchdog, StopsTheJogOfAConsoleThatIsKilled) {
  Holder holder(address);
  ASSERT_NO_FATAL_FAILURE(jog(holder));
  holder.send_signal(SIGKILL);
  const int after = stands_after(Millis(6000));
  EXPECT_GE(after, 0) << "it runs on";
  EXPECT_LE(after, 300 + ramp_ms);
  RecordProperty("ms", after);
}

TEST_P(Watchdog, StopsTheJogOfAConsoleThatCrashes) {
  Holder holder(address);
  ASSERT_NO_FATAL_FAILURE(jog(holder));
  holder.send_signal(SIGSEGV);
  const int after = stands_after(Millis(6000));
  EXPECT_GE(after, 0) << "it runs on";
  EXPECT_LE(after, 300 + ramp_ms);
}

TEST_P(Watchdog, StopsTheJogOfAConsoleThatStandsStill) {
  Holder holder(address);
  ASSERT_NO_FATAL_FAILURE(jog(holder));
  holder.send_signal(SIGSTOP);
  const int after = stands_after(Millis(6000));
  EXPECT_GE(after, 500) << "a console that lives was taken for dead";
  EXPECT_LE(after, 1300 + ramp_ms);
  holder.send_signal(SIGCONT);  // it opens the wire afresh, and the jog does not come back
  EXPECT_TRUE(run_until([&] { return holder.words().find("lost") != std::string::npos; }, Millis(3000)))
      << holder.words();
  run_for(Millis(700));
  EXPECT_FALSE(moves());
}

TEST_P(Watchdog, LeavesAConsoleThatLivesAlone) {
  Holder holder(address);
  ASSERT_NO_FATAL_FAILURE(jog(holder));
  run_for(Millis(1800));
  EXPECT_TRUE(moves());
}

INSTANTIATE_TEST_SUITE_P(Controllers, Watchdog, testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace hw
