#include "transports/watchdog/jog_watchdog.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include "transports/bus_port.h"
#include "transports/watchdog/will_message.h"

namespace hw {
namespace {

using watchdog::Kind;
using watchdog::Message;

// The watchdog's clock, which includes the time that the computer sleeps.
std::int64_t boot_time_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_BOOTTIME, &now);
  return now.tv_sec * std::int64_t{1000} + now.tv_nsec / 1'000'000;
}

constexpr std::array fatal_signals{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};
std::atomic<int> crash_socket{-1};
std::array<struct sigaction, fatal_signals.size()> handled_before;

// Async-signal-safe. Restores the previous handler and raises the signal again.
void notify_watchdog(int number) {
  const char word = static_cast<char>(Kind::dying);
  (void)::send(crash_socket, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT);
  for (std::size_t i = 0; i < fatal_signals.size(); ++i)
    if (fatal_signals[i] == number) ::sigaction(number, &handled_before[i], nullptr);
  ::raise(number);
}

bool spawn(const std::string& program, int socket) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t how;
  if (::posix_spawn_file_actions_init(&files) != 0) return false;
  if (::posix_spawnattr_init(&how) != 0) return ::posix_spawn_file_actions_destroy(&files), false;
  ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSID);  // keys of the terminal reach only the console
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_RDWR, 0);
  ::posix_spawn_file_actions_adddup2(&files, socket, watchdog::socket_number);
  std::string name = program;
  char* const words[] = {name.data(), nullptr};
  pid_t child = 0;
  const bool begun = ::posix_spawn(&child, program.c_str(), &files, &how, words, environ) == 0;
  ::posix_spawnattr_destroy(&how);
  ::posix_spawn_file_actions_destroy(&files);
  return begun;
}

}  // namespace

struct JogWatchdog::Talk {
  int socket = -1;
  bool dead = false;
  int wills = 0;
  std::int64_t sent_at_ms = 0;
  bool was_silent = false;  ///< the watchdog was silent since the first of the present wills

  explicit Talk(int s) : socket(s) {}
  ~Talk() {
    int expected = socket;
    crash_socket.compare_exchange_strong(expected, -1);
    ::close(socket);
  }

  [[nodiscard]] bool is_silent() const {
    return was_silent || boot_time_ms() - sent_at_ms > watchdog::believed_for_ms;
  }
  void send(const Message& message, int fd = -1) {
    if (wills > 0) was_silent = is_silent();
    sent_at_ms = boot_time_ms();
    std::string bytes = watchdog::encode(message);
    iovec part{bytes.data(), bytes.size()};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof fd)] = {};
    msghdr packet{};
    packet.msg_iov = &part;
    packet.msg_iovlen = 1;
    if (fd >= 0) {
      packet.msg_control = control;
      packet.msg_controllen = sizeof control;
      cmsghdr* head = CMSG_FIRSTHDR(&packet);
      head->cmsg_level = SOL_SOCKET;
      head->cmsg_type = SCM_RIGHTS;
      head->cmsg_len = CMSG_LEN(sizeof fd);
      std::memcpy(CMSG_DATA(head), &fd, sizeof fd);
    }
    if (::sendmsg(socket, &packet, MSG_NOSIGNAL | MSG_DONTWAIT) < 0) dead = true;
  }
};

/// Sends `alive` as long as the will exists.
class JogWatchdog::ActiveWill final : public Will {
 public:
  ActiveWill(std::shared_ptr<Talk> talk, Scheduler& scheduler, const Message& will, int fd)
      : talk_(std::move(talk)),
        scheduler_(scheduler),
        id_(will.id),
        alive_(scheduler, [this] { send_alive(); }) {
    if (talk_->wills == 0) talk_->was_silent = false;
    talk_->send(will, fd);
    ++talk_->wills;
    send_later();
  }
  ~ActiveWill() override {
    Message back;
    back.kind = Kind::taken_back;
    back.id = id_;
    talk_->send(back);
    --talk_->wills;
  }
  ActiveWill(const ActiveWill&) = delete;
  ActiveWill& operator=(const ActiveWill&) = delete;
  [[nodiscard]] bool may_be_carried_out() const override { return talk_->is_silent(); }

 private:
  void send_later() { alive_.arm(scheduler_.now() + Millis(watchdog::alive_every_ms)); }
  void send_alive() {
    talk_->send(Message());
    send_later();
  }

  std::shared_ptr<Talk> talk_;
  Scheduler& scheduler_;
  std::uint32_t id_;
  Timer alive_;
};

std::shared_ptr<JogWatchdog> JogWatchdog::start(const std::vector<std::string>& places) {
  for (const std::string& program : places) {
    if (::access(program.c_str(), X_OK) != 0) continue;
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return nullptr;
    auto talk = std::make_shared<Talk>(ends[0]);
    const bool begun = spawn(program, ends[1]);
    ::close(ends[1]);
    if (begun) return std::shared_ptr<JogWatchdog>(new JogWatchdog(std::move(talk)));
  }
  return nullptr;
}

JogWatchdog::~JogWatchdog() = default;

bool JogWatchdog::is_there() const {
  char nothing = 0;
  const ssize_t n = ::recv(talk_->socket, &nothing, 1, MSG_PEEK | MSG_DONTWAIT);
  return !talk_->dead && n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
}

void JogWatchdog::report_fatal_signals() const {
  crash_socket = talk_->socket;
  struct sigaction action {};
  action.sa_handler = notify_watchdog;
  for (std::size_t i = 0; i < fatal_signals.size(); ++i)
    ::sigaction(fatal_signals[i], &action, &handled_before[i]);
}

std::shared_ptr<WillKeeper::Will> JogWatchdog::leave(Scheduler& scheduler, const WireShare& wire,
                                                     const LastWill& will) {
  if (will.empty() || !is_there()) return nullptr;
  Message message;
  message.kind = Kind::will;
  message.id = ++last_id_;
  message.how = wire.how;
  message.base = wire.base;
  message.place = wire.place;
  for (const WillStep& words : will) {
    std::string bytes = words.bytes;
    for (const BusCycle& cycle : words.cycles) append_bus_message(bytes, cycle);
    message.words.push_back({static_cast<std::uint32_t>(words.after.count()), std::move(bytes)});
  }
  auto left = std::make_shared<ActiveWill>(talk_, scheduler, message, wire.fd);
  if (talk_->dead) return nullptr;
  return left;
}

}  // namespace hw
