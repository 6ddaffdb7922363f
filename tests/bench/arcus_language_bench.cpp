// The standalone language: a full memory compiled, while typing and with mistakes on every line; statements
// per second of the interpreter; an hour of a program that waits for an input.
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/decompiler.h"
#include "core/devices/arcus/language/vm.h"

namespace hw::arcus::language {
namespace {

constexpr const char* piece =
    "HSPD=20000      ;* Set the high speed\n"
    "WHILE V1<10     ;* Loop\n"
    "  IF DI1=1\n"
    "    X1000Y2000  ;* Move\n"
    "    WAITX\n"
    "  ELSEIF MSTX!=0\n"
    "    V2=V1&7\n"
    "    DO1=1\n"
    "  ENDIF\n"
    "  V1=V1+1\n"
    "ENDWHILE\n"
    "V1=0\n";  // 18 low-level lines

std::string full_memory() {
  std::string text;
  for (int i = 0; i < 70; ++i) text += piece;
  for (int i = 0; i < 14; ++i) text += "ABS\n";
  return text + "END\n";
}

void compile_1275_lines(benchmark::State& state) {
  const std::string text = full_memory();
  for (auto _ : state) {
    const Compilation compiled = compile(text, pmx_4ex_sa());
    if (!compiled.ok() || compiled.lines.size() != program_lines)
      return state.SkipWithError("not a full memory");
  }
}
BENCHMARK(compile_1275_lines)->Unit(benchmark::kMillisecond);

void compile_1275_mistakes(benchmark::State& state) {
  std::string text;
  for (int i = 0; i < program_lines; ++i) text += "HSPDD=1000\n";
  for (auto _ : state) benchmark::DoNotOptimize(compile(text, pmx_4ex_sa()));
}
BENCHMARK(compile_1275_mistakes)->Unit(benchmark::kMillisecond);

void decode_1275_lines(benchmark::State& state) {
  const auto lines = compile(full_memory(), pmx_4ex_sa()).lines;
  for (auto _ : state) benchmark::DoNotOptimize(decode(lines, pmx_4ex_sa()));
}
BENCHMARK(decode_1275_lines)->Unit(benchmark::kMillisecond);

/// Says yes to everything; each reading differs from the last, so that no loop is idle.
class Restless final : public VmHost {
 public:
  [[nodiscard]] std::int32_t read(Quantity, int) const override { return steady ? 0 : ++reading_; }
  Outcome write(Quantity, int, std::int32_t) override { return Outcome::done; }
  Outcome move(const Move&) override { return Outcome::done; }
  Outcome arc(const Arc&) override { return Outcome::done; }
  Outcome home(int, HomeMode, Sign) override { return Outcome::done; }
  Outcome jog(int, Sign) override { return Outcome::done; }
  void stop(AxisSet) override {}
  void abort(AxisSet) override {}
  void set_absolute(bool) override {}
  [[nodiscard]] bool moving(int) const override { return false; }
  [[nodiscard]] bool in_error(int) const override { return false; }
  [[nodiscard]] AxisSet moved_with(int) const override { return {}; }
  void clear_error(int) override {}
  void arm_sync(int, bool) override {}
  void store() override {}
  [[nodiscard]] bool error_returns_to_start() const override { return false; }
  bool steady = false;

 private:
  mutable std::int32_t reading_ = 0;
};

Vm loaded(const char* text) {
  Vm vm;
  vm.load(std::make_shared<const Program>(compile(text, pmx_4ex_sa()).program));
  return vm;
}

void statements_per_second(benchmark::State& state) {
  Vm vm = loaded("WHILE 1=1\nV1=V1+1\nIF MSTX=0\nV2=V1&7\nELSE\nDO=V1\nENDIF\nENDWHILE\nEND");
  Restless host;
  Instant now{};
  vm.control(0, 1, now);
  for (auto _ : state) {
    now = *vm.next_turn(now, host);
    vm.run_turn(now, host);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(statements_per_second);

void hour_of_waiting_for_an_input(benchmark::State& state) {
  const Vm fresh = loaded("WHILE 1=1\nIF DI1=1\nX1000\nWAITX\nENDIF\nENDWHILE\nEND");
  Restless host;
  host.steady = true;
  for (auto _ : state) {
    Vm vm = fresh;
    Instant now{};
    vm.control(0, 1, now);
    for (auto turn = vm.next_turn(now, host); turn && *turn < Instant(std::chrono::hours(1));
         turn = vm.next_turn(now, host)) {
      now = *turn;
      vm.run_turn(now, host);
    }
  }
}
BENCHMARK(hour_of_waiting_for_an_input)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hw::arcus::language
