#include "tests/bench/served_pty.h"

#include <algorithm>
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

// The rate of an Arcus controller holds from the power-up after it was stored.
void start_at(Emulator& emulator, int baud) {
  constexpr int rates[] = {9600, 19200, 38400, 57600, 115200};
  const auto code = std::find(std::begin(rates), std::end(rates), baud) - std::begin(rates) + 1;
  emulator.receive("@00DB=" + std::to_string(code) + "\r@00STORE\r");
  if (!emulator.operate(bench::PowerCycle())) abort();
  std::string sentence;
  emulator.take_output(sentence);
}

[[noreturn]] void serve(std::string_view model, int baud, const std::string& path, int ready) {
  IoContext io(1);
  RealScheduler clock(io);
  HostOptions options;
  options.byte_times = true;
  auto emulator = find_device_type(model)->make_emulator({});
  const bool by_command = model == "vxm";
  if (!by_command) start_at(**emulator, baud);
  auto host = EmulatorHost::make(clock, std::move(*emulator), options);
  auto terminal = open_pty_endpoint(clock, path, by_command ? factory_baud : baud);
  if (!host || !terminal) _exit(1);
  (*host)->attach(std::move(*terminal));
  if (write(ready, "r", 1) != 1) _exit(1);
  io.run();
  _exit(0);
}

}  // namespace

ServedPty::ServedPty(std::string_view model, int baud)
    : path_(std::filesystem::temp_directory_path() / ("hw-bench-" + std::to_string(getpid()))) {
  int ready[2];
  if (pipe(ready) != 0) abort();
  child_ = fork();
  if (child_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    serve(model, baud, path_, ready[1]);
  }
  close(ready[1]);
  char word = 0;
  if (read(ready[0], &word, 1) != 1) {
    fprintf(stderr, "no emulator on %s\n", path_.c_str());
    exit(1);
  }
  close(ready[0]);
  if (model != "vxm") return;
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
