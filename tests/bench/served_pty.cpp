#include "tests/bench/served_pty.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/time/real_scheduler.h"
#include "transports/pty_endpoint.h"
#include "transports/serve.h"

namespace hw {
namespace {

[[noreturn]] void serve(const std::string& path, int baud, int ready) {
  IoContext io(1);
  RealScheduler clock(io);
  HostOptions options;
  options.byte_times = true;
  auto emulator = find_device_type("vxm")->make_emulator({{"baud", std::to_string(baud)}});
  auto host = EmulatorHost::make(clock, std::move(*emulator), options);
  auto terminal = open_pty_endpoint(clock, path, baud);
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
    serve(path_, baud, ready[1]);
  }
  close(ready[1]);
  char word = 0;
  if (read(ready[0], &word, 1) != 1) {
    fprintf(stderr, "no emulator on %s\n", path_.c_str());
    exit(1);
  }
  close(ready[0]);
  usleep(9'000'000);  // the lamps of the start are over
}

ServedPty::~ServedPty() {
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  unlink(path_.c_str());
}

}  // namespace hw
