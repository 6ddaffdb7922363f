#include "tests/bench/served_pty.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/time/real_scheduler.h"
#include "transports/pty_endpoint.h"
#include "transports/serve.h"
#include "transports/tty.h"

namespace hw {
namespace {

constexpr int factory_baud = 9600;

[[noreturn]] void serve(const std::string& path, int ready) {
  IoContext io(1);
  RealScheduler clock(io);
  HostOptions options;
  options.byte_times = true;
  auto emulator = find_device_type("vxm")->make_emulator({});
  auto host = EmulatorHost::make(clock, std::move(*emulator), options);
  auto terminal = open_pty_endpoint(clock, path, factory_baud);
  if (!host || !terminal) _exit(1);
  (*host)->attach(std::move(*terminal));
  if (write(ready, "r", 1) != 1) _exit(1);
  io.run();
  _exit(0);
}

}  // namespace

ServedPty::ServedPty(int baud)
    : path_(std::filesystem::temp_directory_path() / ("hw-bench-" + std::to_string(getpid()))) {
  int ready[2];
  if (pipe(ready) != 0) abort();
  child_ = fork();
  if (child_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    serve(path_, ready[1]);
  }
  close(ready[1]);
  char word = 0;
  if (read(ready[0], &word, 1) != 1) {
    fprintf(stderr, "no emulator on %s\n", path_.c_str());
    exit(1);
  }
  close(ready[0]);
  usleep(9'000'000);  // the lamps of the start are over
  const int fd = open_client(factory_baud);
  const std::string words = "FsetB" + std::to_string(baud / 1000) + ",";
  if (fd < 0 || write(fd, words.data(), words.size()) < 0) exit(1);
  usleep(200'000);
  close(fd);
}

int ServedPty::open_client(int baud) const {
  const int fd = open(path_.c_str(), O_RDWR | O_NOCTTY);
  termios settings{};
  if (fd < 0 || tcgetattr(fd, &settings) != 0) return -1;
  make_raw_8n1(settings);
  cfsetspeed(&settings, *speed_constant(baud));
  return tcsetattr(fd, TCSANOW, &settings) == 0 ? fd : -1;
}

ServedPty::~ServedPty() {
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  unlink(path_.c_str());
}

}  // namespace hw
