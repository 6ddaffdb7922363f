// Traffic into the terminal: entries as the link records them, through the ring between the threads, into the
// log and its rows. Bytes of the wire per second.
#include <string>

#include <benchmark/benchmark.h>

#include "gui/model/traffic_log.h"

namespace hw {
namespace {

std::string nothing(std::string_view, Way, TrafficKind, std::string_view) { return {}; }

void traffic_into_the_log(benchmark::State& state) {
  const std::string part(static_cast<std::size_t>(state.range(0)), 'x');
  TrafficRing ring(1 << 16);
  gui::TrafficLog log(nothing);
  std::int64_t bytes = 0;
  Instant now{};
  for (auto _ : state) {  // a frame's worth at a time
    for (int i = 0; i < 4096; ++i) {
      TrafficEntry entry;
      entry.at = now += Duration(1000);
      entry.way = i % 2 ? Way::received : Way::sent;
      entry.kind = TrafficKind::unsolicited;
      entry.bytes = part;
      bytes += state.range(0);
      ring.push(std::move(entry));
    }
    log.drain(ring);
    log.update_rows();
    if (log.row_count() > 0) benchmark::DoNotOptimize(log.line(log.row(log.row_count() - 1)));
  }
  state.SetBytesProcessed(bytes);
}
BENCHMARK(traffic_into_the_log)->Arg(9)->Arg(64)->Arg(512);

}  // namespace
}  // namespace hw
