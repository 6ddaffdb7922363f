// A log line that nobody wants, in the place where each byte of a wire passes: it must cost as good as
// nothing.
#include <benchmark/benchmark.h>

#include "core/base/log.h"

namespace hw {
namespace {

void log_line_off(benchmark::State& state) {
  log::Subject& link = log::subject("link");
  const std::string_view bytes = "PM-1\r";
  for (auto _ : state) link.debug("no reply to \"{}\"", log::Bytes{bytes});
}
BENCHMARK(log_line_off)->Unit(benchmark::kNanosecond);

}  // namespace
}  // namespace hw
