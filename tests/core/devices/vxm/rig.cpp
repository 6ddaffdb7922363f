#include "tests/core/devices/vxm/rig.h"

#include <cmath>
#include <cstdlib>

#include "core/devices/vxm/emulator.h"

namespace hw::vxm::proof {
namespace {

// The lamps are done (manual p.7: both for one second, then six flashes).
constexpr Duration power_up_time = 10s;

}  // namespace

Rig::Rig(const DeviceOptions& options) {
  auto made = make_emulator(options);
  if (!made) {
    ADD_FAILURE() << made.error().sentence();
    std::abort();
  }
  emulator_ = std::move(*made);
  for (int motor = 1; motor <= (options.count("motors") ? 4 : 2); ++motor) place(motor, {});
  run_for(power_up_time);
}

Rig Rig::with_slave() { return Rig(DeviceOptions{{"motors", "4"}}); }

Rig Rig::online() {
  Rig rig;
  rig.send("F");
  return rig;
}

Rig Rig::online_with_slave() {
  Rig rig = with_slave();
  rig.send("F");
  return rig;
}

std::string Rig::output() {
  collect();
  std::string out;
  out.swap(pending_);
  return out;
}

std::string Rig::ask(std::string_view bytes) {
  output();
  send(bytes);
  return output();
}

int Rig::free_bytes() {
  const std::string reply = ask("M");
  EXPECT_TRUE(!reply.empty() && reply.back() == '\r') << "M answered " << visible(reply);
  return std::atoi(reply.c_str());
}

void Rig::advance_to(Instant t) {
  now_ = t;
  emulator_->advance_to(t);
}

void Rig::run_for(Duration d) { advance_to(now_ + d); }

bool Rig::run_until_output(std::string_view text, Duration patience) {
  const Instant limit = now_ + patience;
  int standing_still = 0;
  for (collect(); pending_.find(text) == std::string::npos; collect()) {
    const auto next = emulator_->next_event();
    if (!next || *next > limit) {
      advance_to(limit);
      collect();
      return pending_.find(text) != std::string::npos;
    }
    standing_still = *next > now_ ? 0 : standing_still + 1;
    if (standing_still > 100'000) {
      ADD_FAILURE() << "time stands still at " << seconds(now_) << " s";
      return false;
    }
    advance_to(std::max(*next, now_));
  }
  return true;
}

Duration Rig::run_program(Duration patience) {
  output();
  const Instant start = now_;
  send("R");
  EXPECT_TRUE(run_until_output("^", patience)) << "no prompt; output so far: " << visible(pending_);
  output();
  return now_ - start;
}

Duration Rig::run(std::string_view program, Duration patience) {
  send("C");
  send(program);
  return run_program(patience);
}

void Rig::limit(int motor, char sign, bool operated) {
  operate(bench::Limit(axis(motor), sign == '+' ? Sign::plus : Sign::minus, operated));
}

void Rig::click(const std::string& button, Duration held) {
  press(button);
  run_for(held);
  release(button);
  run_for(held);
}

void Rig::pulse_input(int number, Duration held) {
  input(number, true);
  run_for(held);
  input(number, false);
  run_for(held);
}

void Rig::power_cycle() {
  operate(bench::PowerCycle{});
  run_for(power_up_time);
}

void Rig::operate(const BenchCommand& command) {
  const auto done = emulator_->operate(command);
  EXPECT_TRUE(done.has_value()) << done.error().sentence();
}

BenchView Rig::view() const {
  BenchView v;
  emulator_->look(v);
  return v;
}

std::int64_t Rig::position(int motor) {
  const std::string reply = ask(std::string(1, "XYZT"[motor - 1]));
  EXPECT_EQ(reply.size(), 9u) << "position reply " << visible(reply);
  return std::atoll(reply.c_str());
}

std::vector<std::int64_t> Rig::pulse_positions(int motor, int number) const {
  std::vector<std::int64_t> found;
  for (std::size_t i = first_pulse_; i < pulses().size(); ++i)
    if (pulses()[i].output == number)
      found.push_back(pulses()[i].position[static_cast<std::size_t>(motor - 1)].value);
  return found;
}

double ramp_steps(double speed, double a) { return speed * speed / (2 * 1000 * a); }

Duration index_time(std::int64_t steps, double speed, double a) {
  const auto n = static_cast<double>(std::llabs(steps));
  const double rate = 1000 * a;
  if (n < 2 * ramp_steps(speed, a)) return from_seconds(2 * std::sqrt(n / rate));
  return from_seconds(n / speed + speed / rate);
}

::testing::AssertionResult same_time(Duration got, Duration expected, Duration tolerance) {
  if (got - expected <= tolerance && expected - got <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "took " << seconds(got) << " s instead of " << seconds(expected) << " s";
}

std::string visible(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto u = static_cast<unsigned char>(c);
    if (c == '\r') {
      text += "<cr>";
    } else if (u >= 0x20 && u < 0x7F) {
      text += c;
    } else {
      char hex[8];
      std::snprintf(hex, sizeof hex, "<%02X>", u);
      text += hex;
    }
  }
  return text;
}

std::string position_text(std::int64_t position) {
  char text[24];
  std::snprintf(text, sizeof text, "%c%07lld\r", position < 0 ? '-' : '+',
                static_cast<long long>(std::llabs(position)));
  return text;
}

}  // namespace hw::vxm::proof
