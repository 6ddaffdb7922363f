// A wire that takes its time, in wall-clock time: how true the served emulator's byte times are to a client
// in plain C, and how much of such a wire the console's polling fills.
#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

#include <benchmark/benchmark.h>
#include <poll.h>
#include <unistd.h>

#include "tests/bench/served_pty.h"
#include "tests/bench/stack.h"
#include "transports/byte_line.h"

namespace hw {
namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point began) {
  return std::chrono::duration<double>(WallClock::now() - began).count();
}

bool ask(int fd, char question, std::size_t reply) {
  if (write(fd, &question, 1) != 1) return false;
  char part[64];
  while (reply > 0) {
    pollfd client{fd, POLLIN, 0};
    if (::poll(&client, 1, 1000) != 1) return false;
    const ssize_t n = read(fd, part, sizeof part);
    if (n <= 0) return false;
    reply -= std::min(reply, static_cast<std::size_t>(n));
  }
  return true;
}

// X, Y and V, each asked when the answer before is in: 22 bytes.
void three_questions(benchmark::State& state) {
  const int baud = static_cast<int>(state.range(0));
  ServedPty served("vxm", baud);
  const int fd = served.open_client(baud);
  if (fd < 0 || !ask(fd, 'V', 1)) return state.SkipWithError("no answer");
  std::vector<double> times;
  for (auto _ : state) {
    const auto began = WallClock::now();
    if (!ask(fd, 'X', 9) || !ask(fd, 'Y', 9) || !ask(fd, 'V', 1)) return state.SkipWithError("no answer");
    times.push_back(seconds_since(began));
  }
  close(fd);
  const double all = std::accumulate(times.begin(), times.end(), 0.0);
  std::sort(times.begin(), times.end());
  const double wire = 22 * seconds(byte_time(baud));
  state.counters["percent_of_the_wire"] = 100 * wire * static_cast<double>(times.size()) / all;
  const auto over = [&](double share) {
    return 100 * (times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))] / wire - 1);
  };
  state.counters["wire_ms"] = 1e3 * wire;
  state.counters["median_percent_over"] = over(0.5);
  state.counters["p90_percent_over"] = over(0.9);
}
BENCHMARK(three_questions)
    ->Arg(9600)
    ->Arg(19200)
    ->Arg(38400)
    ->UseRealTime()
    ->MinTime(2)
    ->Unit(benchmark::kMillisecond);

// Rounds of status one after the other for some seconds: bytes on the wire against what it can carry.
void polling_share_of_the_wire(benchmark::State& state, const std::string& model, const std::string& id) {
  const int baud = static_cast<int>(state.range(0));
  ServedPty served(model, baud);
  IoContext io(1);
  Stack stack(io, model + "@serial:" + served.path() + ",baud=" + std::to_string(baud) + id);
  if (stack.ended) return state.SkipWithError(stack.trouble.c_str());
  const auto bytes_before = stack.wire_bytes;
  const auto rounds_before = stack.station->statistics().transactions;
  const auto began = WallClock::now();
  for (auto _ : state) {
    const auto before = stack.wire_bytes;
    while (stack.wire_bytes == before && !stack.ended) io.run_one();
  }
  const double passed = seconds_since(began);
  const double carried = static_cast<double>(stack.wire_bytes - bytes_before);
  state.counters["percent_of_the_wire"] = 100 * carried * seconds(byte_time(baud)) / passed;
  state.counters["polls_per_second"] =
      static_cast<double>(stack.station->statistics().transactions - rounds_before) / passed;
}
BENCHMARK_CAPTURE(polling_share_of_the_wire, vxm, "vxm", "")
    ->Arg(9600)
    ->Arg(19200)
    ->Arg(38400)
    ->UseRealTime()
    ->MinTime(2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(polling_share_of_the_wire, pmx_4ex_sa, "pmx-4ex-sa", ",id=00")
    ->Arg(57600)
    ->Arg(115200)
    ->UseRealTime()
    ->MinTime(2)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hw
