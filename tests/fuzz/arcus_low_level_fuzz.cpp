// Any lines as a stored program. Loading never fails; running them needs no more than one statement per
// thread and turn, stays inside its memory, and reads and writes only what the model has.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/arcus/language/decompiler.h"
#include "core/devices/arcus/language/vm.h"

namespace {

using hw::Instant;
using hw::Sign;
using namespace hw::arcus::language;

void require(bool condition) {
  if (!condition) std::abort();
}

/// Answers with what the input has left, and checks what it is asked for.
class FuzzedController final : public VmHost {
 public:
  FuzzedController(const Dialect& dialect, std::string_view bytes) : dialect_(dialect), bytes_(bytes) {}
  [[nodiscard]] std::int32_t read(Quantity q, int index) const override {
    require(!spell(dialect_, q, index).empty());
    return static_cast<std::int8_t>(next()) * 70000;
  }
  Outcome write(Quantity q, int index, std::int32_t) override {
    require(!spell(dialect_, q, index).empty());
    return outcome();
  }
  Outcome move(const Move& move) override {
    check(move.axes);
    return outcome();
  }
  Outcome arc(const Arc&) override {
    require(dialect_.arcs);
    return outcome();
  }
  Outcome home(int axis, HomeMode, Sign) override { return check(one_axis(axis)), outcome(); }
  Outcome jog(int axis, Sign) override { return check(one_axis(axis)), outcome(); }
  void stop(AxisSet axes) override { check(axes); }
  void abort(AxisSet axes) override { check(axes); }
  void set_absolute(bool) override {}
  [[nodiscard]] bool moving(int) const override { return next() % 4 == 0; }
  [[nodiscard]] bool in_error(int) const override { return next() % 16 == 0; }
  [[nodiscard]] AxisSet moved_with(int axis) const override { return check(one_axis(axis)), AxisSet{next()}; }
  void clear_error(int axis) override { check(one_axis(axis)); }
  void arm_sync(int axis, bool) override { check(one_axis(axis)); }
  void store() override {}
  [[nodiscard]] bool error_returns_to_start() const override { return next() & 1; }
  [[nodiscard]] std::uint8_t next() const {
    if (bytes_.empty()) return 1;
    const auto byte = static_cast<std::uint8_t>(bytes_[at_ % bytes_.size()]);
    ++at_;
    return byte;
  }

 private:
  void check(AxisSet axes) const { require(!axes.empty() && (axes.bits & ~dialect_.all_axes().bits) == 0); }
  [[nodiscard]] Outcome outcome() const { return static_cast<Outcome>(next() % 3); }

  const Dialect& dialect_;
  std::string_view bytes_;
  mutable std::size_t at_ = 0;
};

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  }
  return lines;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Dialect& dialect = data[0] & 1 ? dmx_k_sa() : pmx_4ex_sa();
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::vector<std::string> lines = split(text);
  (void)decompile(lines, dialect);

  Vm vm;
  FuzzedController host(dialect, text);
  vm.load(std::make_shared<const Program>(decode(lines, dialect)));
  Instant now{};
  for (int program = 0; program < max_programs; ++program) vm.control(program, 1, now);
  (void)vm.call(host.next() % subroutines, now);
  for (int turn = 0; turn < 300; ++turn) {
    const auto next = vm.next_turn(now, host);
    if (!next) break;
    require(*next >= now);
    now = *next;
    vm.run_turn(now, host);
    if (host.next() % 32 == 0) vm.control(host.next() % 4, host.next() % 4, now);
    for (int program = 0; program < max_programs; ++program)
      require(vm.line(program, now) >= 0 && vm.line(program, now) <= hw::arcus::program_lines);
  }
  return 0;
}
