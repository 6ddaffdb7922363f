#include "tests/core/devices/arcus/rig.h"

#include <algorithm>
#include <cmath>

#include "core/devices/dmx_k_sa/emulator.h"
#include "core/devices/pmx_4ex_sa/emulator.h"

namespace hw::arcus::proof {

Rig::Rig(Which which, const Options& options) : which_(which), address_(which == Which::pmx ? "00" : "01") {
  auto made = which == Which::pmx ? pmx_4ex_sa::make_emulator(options) : dmx_k_sa::make_emulator(options);
  if (!made) {
    ADD_FAILURE() << made.error().sentence();
    std::abort();
  }
  emulator_ = std::move(*made);
  if (options.count("id") != 0) address_ = options.at("id");
}

std::string Rig::output() {
  std::string out = std::exchange(unsolicited_, {});
  emulator_->take_output(out);
  return out;
}

std::string Rig::raw(std::string_view bytes) {
  emulator_->receive(bytes);
  return output();
}

std::string Rig::ask(std::string_view command) {
  unsolicited_ = output();
  emulator_->receive("@" + address_ + std::string(command) + "\r");
  std::string reply;
  emulator_->take_output(reply);
  const char end = which_ == Which::pmx ? '\r' : '\0';
  if (reply.empty() || reply.back() != end || std::count(reply.begin(), reply.end(), end) != 1) {
    ADD_FAILURE() << command << " was not answered by one whole reply: " << ::testing::PrintToString(reply);
    return reply;
  }
  reply.pop_back();
  return reply;
}

std::int64_t Rig::number(std::string_view command) {
  const std::string reply = ask(command);
  if (reply.empty() || reply.find_first_not_of("-0123456789") != std::string::npos) {
    ADD_FAILURE() << command << " gave no number: " << reply;
    return INT64_MIN;
  }
  return std::stoll(reply);
}

void Rig::ok(std::string_view command) { EXPECT_EQ(ask(command), "OK") << command; }

void Rig::run_for(Duration d) {
  now_ += d;
  emulator_->advance_to(now_);
}

Duration Rig::run_to_rest(int axis, Duration patience) {
  const Instant begin = now_;
  const std::string query = which_ == Which::pmx ? std::string("MST") + "XYZU"[axis] : "MST";
  while (number(query) & 7) {
    const auto next = emulator_->next_event();
    if (!next || *next - begin > patience) {
      ADD_FAILURE() << "the axis does not come to rest";
      break;
    }
    now_ = std::max(now_, *next);
    emulator_->advance_to(now_);
  }
  return now_ - begin;
}

void Rig::must(const BenchCommand& command) {
  const auto done = emulator_->operate(command);
  if (!done) ADD_FAILURE() << done.error().sentence();
}

void Rig::power_cycle() { must(bench::PowerCycle{}); }

BenchView Rig::view() const {
  BenchView view;
  emulator_->look(view);
  return view;
}

Duration trapezoid_time(double length, double high, double low, double accel_ms, double decel_ms) {
  const double up = (high + low) / 2 * accel_ms / 1000, down = (high + low) / 2 * decel_ms / 1000;
  if (up <= length / 2 && down <= length / 2)
    return from_seconds((accel_ms + decel_ms) / 1000 + (length - up - down) / high);
  const double slope = (high - low) / (accel_ms / 1000);
  const double top = std::min(high, std::sqrt(low * low + slope * length));
  const double ramp = (top - low) / slope;
  return from_seconds(2 * ramp + (length - (top + low) * ramp) / top);
}

::testing::AssertionResult same_time(Duration got, Duration expected, Duration tolerance) {
  if (got - expected <= tolerance && expected - got <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << seconds(got) << " s instead of " << seconds(expected) << " s";
}

}  // namespace hw::arcus::proof
