#include "tests/bench/responder.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

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

// What a resting VXM says; words ("getD0", "lst") are told from single letters by their first one.
const char* answer(const char* word) {
  if (strcmp(word, "V") == 0) return "R";
  if (strchr("XYZT*", word[0]) && !word[1]) return "+0000400\r";
  if (strcmp(word, "?") == 0 || strcmp(word, "~") == 0) return "\xff";
  if (strcmp(word, "$") == 0) return "\x01";
  if (strcmp(word, "@") == 0) return "512\r";
  if (strcmp(word, "M") == 0) return "256\r";
  if (strcmp(word, "#") == 0) return "1\r";
  if (strcmp(word, "K") == 0) return "^";
  if (strcmp(word, "getD0") == 0) return "1.30\r";
  if (strcmp(word, "getD1") == 0) return "12-29-04\r";
  if (strcmp(word, "getD2") == 0) return "2\r";
  if (strcmp(word, "lst") == 0) return "PM0 M256\r";
  return nullptr;
}

void serve(int client) {
  char in[4096], word[64];
  size_t n = 0;
  for (;;) {
    const ssize_t got = read(client, in, sizeof in);
    if (got <= 0) return;
    for (ssize_t i = 0; i < got; ++i) {
      const char c = in[i];
      const char* reply = nullptr;
      if (c == '\r' || c == ',' || c == '\n') {
        word[n] = 0;
        if (strcmp(word, "PM") == 0)
          reply = "0\r";
        else if (strcmp(word, "B") == 0 || strcmp(word, "O") == 0)
          reply = "0\r";
        else if (strncmp(word, "get", 3) == 0)
          reply = "1\r";
        n = 0;
      } else {
        if (n + 1 < sizeof word) word[n++] = c;
        word[n] = 0;
        reply = answer(word);
        if (reply || strchr("EFGNCQHD", word[0])) n = 0;
      }
      if (reply && write(client, reply, strlen(reply)) < 0) return;
    }
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
