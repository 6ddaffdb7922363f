#include "transports/sleep_watch.h"

#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <cerrno>
#include <optional>

#include <fcntl.h>
#include <poll.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include "core/base/log.h"

namespace hw {
namespace {

constexpr const char *service = "org.freedesktop.login1", *object = "/org/freedesktop/login1",
                     *manager_interface = "org.freedesktop.login1.Manager";

/// A logind lock, held while its descriptor is open.
struct Lock {
  int fd = -1;
  bool wanted = false;
  const char* why = nullptr;
  const char* mode = nullptr;

  Lock(const char* w, const char* m) : why(w), mode(m) {}
  ~Lock() { release(); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  void release() {
    wanted = false;
    if (fd >= 0) ::close(std::exchange(fd, -1));
  }
};

}  // namespace

class SleepWatch::Logind : public std::enable_shared_from_this<Logind> {
 public:
  Logind(Scheduler& scheduler, Callbacks callbacks)
      : callbacks_(std::move(callbacks)), descriptor_(scheduler.executor()) {}
  ~Logind() {
    if (descriptor_.is_open()) descriptor_.release();  // the bus closes it
    sd_bus_close_unref(bus_);
  }
  Logind(const Logind&) = delete;
  Logind& operator=(const Logind&) = delete;

  void start() {
    if (sd_bus_open_system(&bus_) < 0) return log::debug("sleep", "no system bus");
    const int matched = sd_bus_match_signal_async(bus_, nullptr, service, object, manager_interface,
                                                  "PrepareForSleep", on_sleep, nullptr, this);
    const int fd = sd_bus_get_fd(bus_);
    if (matched < 0 || fd < 0) return log::debug("sleep", "the system bus does not answer");
    descriptor_.assign(fd);
    take(delay_);
    serve();
  }
  void stop() {
    callbacks_ = {};
    delay_.release();
    block_.release();
    if (descriptor_.is_open()) descriptor_.release();
  }
  void may_sleep() { delay_.release(); }
  void keep_awake(bool moves) {
    if (moves)
      take(block_);
    else
      block_.release();
  }

 private:
  /// The reply comes to on_lock().
  void take(Lock& lock) {
    if (lock.wanted || !descriptor_.is_open()) return;
    lock.wanted = true;
    const int asked =
        sd_bus_call_method_async(bus_, nullptr, service, object, manager_interface, "Inhibit", on_lock, &lock,
                                 "ssss", "sleep", "Handwheel", lock.why, lock.mode);
    if (asked < 0) lock.wanted = false;
    serve();
  }
  static int on_lock(sd_bus_message* answer, void* data, sd_bus_error*) {
    Lock& lock = *static_cast<Lock*>(data);
    int fd = -1;
    if (sd_bus_message_is_method_error(answer, nullptr) > 0 || sd_bus_message_read(answer, "h", &fd) < 0) {
      log::debug("sleep", "logind gives no lock");
      lock.wanted = false;
      return 0;
    }
    if (lock.fd < 0 && lock.wanted)
      lock.fd = ::fcntl(fd, F_DUPFD_CLOEXEC, 0);  // the message closes its own descriptor
    return 0;
  }
  static int on_sleep(sd_bus_message* signal, void* data, sd_bus_error*) {
    auto& self = *static_cast<Logind*>(data);
    int begins = 0;
    if (sd_bus_message_read(signal, "b", &begins) < 0) return 0;
    log::debug("sleep", begins != 0 ? "the computer goes to sleep" : "the computer has woken");
    if (begins != 0) {
      if (self.callbacks_.wants_to_sleep) self.callbacks_.wants_to_sleep();
    } else {
      self.take(self.delay_);  // for the next sleep
      if (self.callbacks_.has_woken) self.callbacks_.has_woken();
    }
    return 0;
  }

  // Handles messages from the bus and sends queued messages.
  void serve() {
    int more = 1;
    while (more > 0) more = sd_bus_process(bus_, nullptr);
    if (more < 0) return lose();
    const int events = sd_bus_get_events(bus_);
    if (events < 0) return lose();
    wait(asio::posix::descriptor_base::wait_read, reading_);
    if ((events & POLLOUT) != 0) wait(asio::posix::descriptor_base::wait_write, writing_);
  }
  void wait(asio::posix::descriptor_base::wait_type kind, bool& waiting) {
    if (std::exchange(waiting, true)) return;
    descriptor_.async_wait(kind, [self = shared_from_this(), &waiting](auto error) {
      waiting = false;
      if (!error && self->descriptor_.is_open()) self->serve();
    });
  }
  void lose() {
    log::debug("sleep", "the system bus is gone");
    if (descriptor_.is_open()) descriptor_.release();
  }

  Callbacks callbacks_;
  sd_bus* bus_ = nullptr;
  asio::posix::basic_stream_descriptor<Executor> descriptor_;
  bool reading_ = false, writing_ = false;
  Lock delay_{"Stops a held jog first", "delay"}, block_{"A motion is under way", "block"};
};

SleepWatch::SleepWatch(Scheduler& scheduler, Callbacks callbacks)
    : scheduler_(scheduler), logind_(std::make_shared<Logind>(scheduler, std::move(callbacks))) {
  asio::post(scheduler_.executor(), [logind = logind_] { logind->start(); });
}

SleepWatch::~SleepWatch() { logind_->stop(); }

void SleepWatch::may_sleep() {
  asio::post(scheduler_.executor(), [logind = logind_] { logind->may_sleep(); });
}

void SleepWatch::keep_awake(bool something_moves) {
  asio::post(scheduler_.executor(),
             [logind = logind_, something_moves] { logind->keep_awake(something_moves); });
}

}  // namespace hw
