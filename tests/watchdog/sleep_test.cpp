// The sleep of the computer, as a logind of the test's own tells of it on a bus of the test's own.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include "core/time/real_scheduler.h"
#include "transports/sleep_watch.h"

namespace hw {
namespace {

/// A message bus for this test alone.
class Bus {
 public:
  Bus() {
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    std::array<std::string, 4> words{"dbus-daemon", "--session", "--print-address=1", "--nofork"};
    char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    EXPECT_EQ(::posix_spawnp(&child_, "dbus-daemon", &files, nullptr, arguments, environ), 0);
    ::posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    for (char c = 0; ::read(ends[0], &c, 1) == 1 && c != '\n';) address_ += c;
    ::close(ends[0]);
    ::setenv("DBUS_SYSTEM_BUS_ADDRESS", address_.c_str(), 1);
  }
  ~Bus() {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

 private:
  pid_t child_ = 0;
  std::string address_;
};

/// Gives locks, and knows which are still held.
class Logind {
 public:
  Logind() {
    EXPECT_GE(sd_bus_open_system(&bus_), 0);
    static const sd_bus_vtable methods[] = {
        SD_BUS_VTABLE_START(0), SD_BUS_METHOD("Inhibit", "ssss", "h", inhibit, SD_BUS_VTABLE_UNPRIVILEGED),
        SD_BUS_SIGNAL("PrepareForSleep", "b", 0), SD_BUS_VTABLE_END};
    EXPECT_GE(sd_bus_add_object_vtable(bus_, nullptr, "/org/freedesktop/login1",
                                       "org.freedesktop.login1.Manager", methods, this),
              0);
    EXPECT_GE(sd_bus_request_name(bus_, "org.freedesktop.login1", 0), 0);
  }
  ~Logind() {
    for (const auto& [mode, fd] : held_) ::close(fd);
    sd_bus_flush_close_unref(bus_);
  }
  Logind(const Logind&) = delete;
  Logind& operator=(const Logind&) = delete;
  void serve() {
    while (sd_bus_process(bus_, nullptr) > 0) continue;
  }
  void signal_sleep(bool sleeps) {
    sd_bus_emit_signal(bus_, "/org/freedesktop/login1", "org.freedesktop.login1.Manager", "PrepareForSleep",
                       "b", static_cast<int>(sleeps));
    sd_bus_flush(bus_);
  }
  /// "delay", "block": whether somebody holds such a lock.
  bool holds(const std::string& mode) {
    const auto lock = held_.find(mode);
    if (lock == held_.end()) return false;
    char nothing = 0;  // the other end of a lock that is given back is closed
    if (::read(lock->second, &nothing, 1) != 0) return true;
    ::close(lock->second);
    held_.erase(lock);
    return false;
  }

 private:
  static int inhibit(sd_bus_message* call, void* data, sd_bus_error*) {
    const char *what = nullptr, *who = nullptr, *why = nullptr, *mode = nullptr;
    if (sd_bus_message_read(call, "ssss", &what, &who, &why, &mode) < 0) return -EINVAL;
    EXPECT_STREQ(what, "sleep");
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) return -errno;
    static_cast<Logind*>(data)->held_[mode] = ends[0];
    const int sent = sd_bus_reply_method_return(call, "h", ends[1]);
    ::close(ends[1]);
    return sent;
  }
  sd_bus* bus_ = nullptr;
  std::map<std::string, int> held_;
};

class Sleep : public testing::Test {
 protected:
  bool run_until(const std::function<bool()>& done) {
    const Instant until = scheduler.now() + Millis(5000);
    while (!done() && scheduler.now() < until) {
      io.run_one_for(std::chrono::milliseconds(2));
      logind.serve();
    }
    return done();
  }
  Bus bus;
  Logind logind;
  IoContext io{1};
  RealScheduler scheduler{io};
  int sleeps = 0, wakes = 0;
  SleepWatch watch{scheduler, {[this] { ++sleeps; }, [this] { ++wakes; }}};
};

TEST_F(Sleep, WaitsForUs) {
  ASSERT_TRUE(run_until([this] { return logind.holds("delay"); }));
  logind.signal_sleep(true);
  ASSERT_TRUE(run_until([this] { return sleeps == 1; }));
  EXPECT_TRUE(logind.holds("delay")) << "the stop is still on its way";
  watch.may_sleep();
  EXPECT_TRUE(run_until([this] { return !logind.holds("delay"); }));
  logind.signal_sleep(false);
  ASSERT_TRUE(run_until([this] { return wakes == 1; }));
  EXPECT_TRUE(run_until([this] { return logind.holds("delay"); })) << "for the next time";
}

TEST_F(Sleep, IsHeldOffWhileSomethingMoves) {
  ASSERT_TRUE(run_until([this] { return logind.holds("delay"); }));
  EXPECT_FALSE(logind.holds("block"));
  watch.keep_awake(true);
  EXPECT_TRUE(run_until([this] { return logind.holds("block"); }));
  watch.keep_awake(false);
  EXPECT_TRUE(run_until([this] { return !logind.holds("block"); }));
}

TEST(SleepWithoutLogind, IsNoTrouble) {
  ::setenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere/at/all", 1);
  IoContext io{1};
  RealScheduler scheduler{io};
  SleepWatch watch(scheduler, {});
  watch.keep_awake(true);
  watch.may_sleep();
  io.run_for(std::chrono::milliseconds(20));
}

}  // namespace
}  // namespace hw
