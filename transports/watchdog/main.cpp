// The watchdog of held jogs. It knows no protocol. It keeps the bytes that the console deposits before each
// held jog, its will, and sends them when the console has died or is silent. It ends with the console.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <map>

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "transports/watchdog/wire_writer.h"

namespace hw::watchdog {
namespace {

// Includes the time that the computer sleeps.
std::int64_t now_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_BOOTTIME, &now);
  return now.tv_sec * std::int64_t{1000} + now.tv_nsec / 1'000'000;
}

class WillStore {
 public:
  void take(Message will, int fd) {
    drop(will.id);
    kept_[will.id] = {std::move(will), fd};
  }
  void drop(std::uint32_t id) {
    const auto kept = kept_.find(id);
    if (kept == kept_.end()) return;
    if (kept->second.fd >= 0) ::close(kept->second.fd);
    kept_.erase(kept);
  }
  [[nodiscard]] bool any() const { return !kept_.empty(); }

  // Sends the first bytes of all wills before any delay.
  void carry_out() {
    struct Due {
      const Words* words;
      const Kept* kept;
    };
    std::vector<Due> all;
    for (const auto& [id, kept] : kept_)
      for (const Words& words : kept.will.words) all.push_back({&words, &kept});
    std::stable_sort(all.begin(), all.end(),
                     [](const Due& a, const Due& b) { return a.words->after_ms < b.words->after_ms; });
    const std::int64_t began = now_ms();
    for (const Due& due : all) {
      const std::int64_t wait = began + due.words->after_ms - now_ms();
      if (wait > 0) ::poll(nullptr, 0, static_cast<int>(wait));
      write_to_wire(due.kept->will, due.kept->fd, due.words->bytes);
    }
    while (any()) drop(kept_.begin()->first);
  }

 private:
  struct Kept {
    Message will;
    int fd = -1;
  };
  std::map<std::uint32_t, Kept> kept_;
};

// Receives a message. Returns false when the console has ended.
bool receive(std::string& bytes, int& fd) {
  bytes.resize(longest_message);
  fd = -1;
  iovec part{bytes.data(), bytes.size()};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  const ssize_t n = ::recvmsg(socket_number, &message, MSG_CMSG_CLOEXEC);
  if (n < 0 && errno == EINTR) return bytes.clear(), true;
  if (n <= 0) return false;
  bytes.resize(static_cast<std::size_t>(n));
  for (cmsghdr* part_of = CMSG_FIRSTHDR(&message); part_of; part_of = CMSG_NXTHDR(&message, part_of))
    if (part_of->cmsg_level == SOL_SOCKET && part_of->cmsg_type == SCM_RIGHTS)
      std::copy_n(CMSG_DATA(part_of), sizeof fd, reinterpret_cast<unsigned char*>(&fd));
  return true;
}

void obey(WillStore& wills, const std::string& bytes, int fd) {
  auto message = decode(bytes);
  if (message && message->kind == Kind::will) return wills.take(std::move(*message), fd);
  if (fd >= 0) ::close(fd);
  if (!message) return;
  if (message->kind == Kind::taken_back) wills.drop(message->id);
  if (message->kind == Kind::dying) wills.carry_out();
}

int watch() {
  WillStore wills;
  std::string bytes;
  for (std::int64_t received_at = now_ms();;) {
    const std::int64_t left = received_at + longest_silence_ms - now_ms();
    pollfd socket{socket_number, POLLIN, 0};
    const int news = ::poll(&socket, 1, wills.any() ? static_cast<int>(std::max<std::int64_t>(left, 0)) : -1);
    if (news < 0 && errno != EINTR) return EXIT_FAILURE;
    if (news > 0) {
      int fd = -1;
      if (!receive(bytes, fd)) break;
      received_at = now_ms();
      obey(wills, bytes, fd);
    } else if (news == 0 && left <= 0) {
      wills.carry_out();
    }
  }
  wills.carry_out();
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace hw::watchdog

// Terminal signals that end the console must not end the watchdog first.
int main() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU})
    std::signal(number, SIG_IGN);
  ::close_range(hw::watchdog::socket_number + 1, ~0U, 0);
  ::mlockall(MCL_CURRENT | MCL_FUTURE);  // so that it never waits for the disk; optional, needs permission
  return hw::watchdog::watch();
}
