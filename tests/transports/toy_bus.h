#pragma once
// A line with several toy controllers, each with an id, and the driver that talks to one of them. For tests
// of what a bus is, whatever hangs on it.
//   @NNP<CR> -> 0400<CR>     @NNS<CR> -> OK<CR>, counts as a stop     @00S<CR>: a stop of all, nobody answers
#include "core/device/driver.h"
#include "core/emulation/emulator.h"

namespace hw::test {

class BusToy final : public Emulator {
 public:
  explicit BusToy(std::string id, int rate = 115200) : id_(std::move(id)), rate_(rate) {}

  void receive(std::string_view bytes) override {
    for (const char c : bytes) {
      if (c != '\r') {
        line_ += c;
        continue;
      }
      if (powered_) obey(line_);
      line_.clear();
    }
  }
  void take_output(std::string& sink) override { sink += std::exchange(output_, {}); }
  std::optional<Instant> next_event() const override { return std::nullopt; }
  void advance_to(Instant) override {}
  Result<> operate(const BenchCommand& command) override {
    if (const auto* power = std::get_if<bench::Power>(&command)) powered_ = power->on;
    return {};
  }
  void look(BenchView& view) const override { view.powered = powered_; }
  const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  int rate() const override { return rate_; }
  std::string save_memory() const override { return "toy " + id_; }
  Result<> load_memory(std::string_view text) override {
    if (text != "toy " + id_) return fail(FaultKind::text, "It is the memory of another toy.");
    return {};
  }
  std::uint64_t memory_version() const override { return static_cast<std::uint64_t>(stops); }
  std::unique_ptr<Emulator> clone() const override { return std::make_unique<BusToy>(*this); }

  int polls = 0, stops = 0;

 private:
  void obey(std::string_view line) {
    if (line == "@00S") ++stops;
    if (line.substr(0, 3) != "@" + id_) return;
    if (line.substr(3) == "P") ++polls, output_ += "0400\r";
    if (line.substr(3) == "S") ++stops, output_ += "OK\r";
  }
  std::string id_, line_, output_;
  std::vector<TriggerPulse> pulses_;
  int rate_;
  bool powered_ = true;
};

class BusToyDriver final : public Driver {
 public:
  explicit BusToyDriver(DriverContext context) : context_(std::move(context)) {}

  void attach(Station& station) override { station_ = &station; }
  Task<Result<>> connect() override { return poll(Round::usual); }
  Task<Result<>> poll(Round) override {
    auto polled = co_await ask("P", Priority::poll);
    if (polled) context_.snapshot.axes[0].seen_at = context_.scheduler.now();
    co_return polled;
  }
  Task<Result<>> perform(const IntentBody&) override { return ask("P", Priority::intent); }
  Task<Result<std::string>> stop(const StopOrder& order) override {
    const bool to_all = order.what == StopOrder::What::broadcast;
    Result<> sent;
    if (to_all)
      sent = co_await broadcast();
    else
      sent = co_await ask("S", Priority::stop);
    if (!sent) co_return fail(sent.error());
    co_return std::string();
  }
  [[nodiscard]] LastWill last_will(unsigned) const override { return {}; }
  StopProgress stop_progress(const StopOrder&) override { return StopProgress::stands(); }
  void wire_lost() override { station_ = nullptr; }
  Task<Result<std::string>> query(std::string, Duration) override { co_return std::string(); }
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText&) const override { return {}; }
  [[nodiscard]] Duration moving_period() const override { return Millis(1); }
  [[nodiscard]] Duration idle_period() const override { return Millis(1); }

 private:
  Task<Result<>> broadcast() {
    Transaction t("@00S\r", ReplyShape::nothing(), Priority::stop);
    auto sent = co_await station_->transact(std::move(t));
    if (!sent) co_return fail(sent.error());
    co_return Result<>();
  }
  Task<Result<>> ask(std::string what, Priority priority) {
    if (!station_) co_return fail(FaultKind::lost, "There is no connection.");
    Transaction t("@" + context_.catalog.id() + what + "\r", ReplyShape::line(), priority);
    auto reply = co_await station_->transact(std::move(t));
    if (!reply) co_return fail(reply.error());
    co_return Result<>();
  }
  DriverContext context_;
  Station* station_ = nullptr;
};

}  // namespace hw::test
