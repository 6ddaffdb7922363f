#include "tests/bench/responder.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/emulation/emulator.h"

namespace hw {
namespace {

void pin(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (core >= 0)
    CPU_SET(core, &set);
  else
    for (int i = 0; i < CPU_SETSIZE; ++i) CPU_SET(i, &set);
  sched_setaffinity(0, sizeof set, &set);
}

// A VXM that rests: its time stands still, so an answer costs next to nothing.
std::unique_ptr<Emulator> resting() {
  auto emulator = *find_device_type("vxm")->make_emulator({});
  emulator->advance_to(Instant(std::chrono::seconds(10)));
  return emulator;
}

void serve(int client) {
  const auto emulator = resting();
  std::string answer;
  char in[4096];
  for (;;) {
    const ssize_t got = read(client, in, sizeof in);
    if (got <= 0) return;
    emulator->receive({in, static_cast<std::size_t>(got)});
    answer.clear();
    emulator->take_output(answer);
    if (!answer.empty() && write(client, answer.data(), answer.size()) < 0) return;
  }
}

}  // namespace

Responder::Responder() {
  pin(0);
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof here;
  if (bind(listener, reinterpret_cast<sockaddr*>(&here), size) != 0 || listen(listener, 8) != 0) {
    perror("responder");
    exit(1);
  }
  getsockname(listener, reinterpret_cast<sockaddr*>(&here), &size);
  port_ = ntohs(here.sin_port);
  child_ = fork();
  if (child_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (;;) {
      const int client = accept(listener, nullptr, nullptr);
      if (client < 0) _exit(0);
      const int on = 1;
      setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      serve(client);
      close(client);
    }
  }
  close(listener);
}

Responder::~Responder() {
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  pin(-1);
}

}  // namespace hw
