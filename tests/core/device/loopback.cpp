#include "tests/core/device/loopback.h"

#include <algorithm>

namespace hw::test {

class Loopback::End final : public Stream {
 public:
  explicit End(Loopback& loop) : loop_(&loop) {}
  ~End() override {
    if (loop_ && loop_->end_ == this) loop_->end_ = nullptr;
  }
  void listen(Listener* l) override { listener = l; }
  void discard_unsent() override {}
  void send(std::string_view bytes) override {
    if (loop_) loop_->sent(bytes);
  }
  Result<> set_rate(int baud) override {
    if (loop_) loop_->client_rate = baud;
    return {};
  }
  [[nodiscard]] int rate() const override {
    if (!loop_ || !loop_->byte_times_) return 0;
    return loop_->client_rate ? loop_->client_rate : loop_->emulator_->rate();
  }
  [[nodiscard]] std::string describe() const override { return "an emulated controller"; }
  void leave() { loop_ = nullptr; }
  Listener* listener = nullptr;

 private:
  Loopback* loop_;
};

Loopback::Loopback(Scheduler& scheduler, std::unique_ptr<Emulator> emulator, bool byte_times)
    : scheduler_(scheduler),
      emulator_(std::move(emulator)),
      byte_times_(byte_times),
      timer_(scheduler, [this] { step(); }) {
  schedule();
}
Loopback::~Loopback() {
  if (end_) end_->leave();
}

std::unique_ptr<Stream> Loopback::plug() {
  auto end = std::make_unique<End>(*this);
  end_ = end.get();
  return end;
}

void Loopback::pull() {
  if (!end_) return;
  End* end = std::exchange(end_, nullptr);
  end->leave();
  out_.clear();
  if (end->listener) end->listener->stream_closed(Fault(FaultKind::lost, "The cable was pulled."));
}

void Loopback::inject(std::string_view bytes) {
  for (const char c : bytes) out_.push_back({out_free_ = std::max(out_free_, scheduler_.now()), c});
  schedule();
}

Result<> Loopback::operate(const BenchCommand& command) {
  step();
  auto done = emulator_->operate(command);
  step();
  return done;
}

Duration Loopback::byte_time() const {
  return byte_times_ ? Duration(10'000'000'000LL / emulator_->rate()) : Duration::zero();
}

void Loopback::sent(std::string_view bytes) {
  to_controller += bytes;
  for (const char c : bytes) {
    if (silent_ || lose_ > 0) {
      if (lose_ > 0) --lose_;
      continue;
    }
    in_free_ = std::max(in_free_, scheduler_.now()) + byte_time();
    in_.push_back({in_free_, c});
  }
  schedule();
}

void Loopback::step() {
  const Instant now = scheduler_.now();
  for (;;) {
    Instant next = now;
    if (const auto event = emulator_->next_event()) next = std::min(next, *event);
    if (!in_.empty()) next = std::min(next, in_.front().at);
    emulator_->advance_to(next);
    char sentence = 0;
    if (!in_.empty() && in_.front().at <= next) {
      char c = in_.front().value;
      in_.pop_front();
      sentence = c;
      if (byte_times_ && client_rate && client_rate != emulator_->rate()) c = static_cast<char>(c * 7 + 129);
      if (other_)
        for (const char answer : other_(std::string_view(&c, 1))) out_.push_back({now, answer});
      else
        emulator_->receive(std::string_view(&c, 1));
    }
    std::string output;
    emulator_->take_output(output);
    if (on_its_way && sentence != 0) {
      OnItsWay changed = on_its_way(sentence, std::move(output));
      output = std::move(changed.bytes);
      if (changed.late > Duration::zero()) out_free_ = std::max(out_free_, next + changed.late);
    }
    for (char c : output) {
      if (silent_ || drop_ > 0) {
        if (drop_ > 0) --drop_;
        continue;
      }
      if (garble_ > 0) --garble_, c = static_cast<char>(c ^ 0x91);
      if (byte_times_ && client_rate && client_rate != emulator_->rate()) c = static_cast<char>(c * 7 + 129);
      out_free_ = std::max(out_free_, next) + byte_time();
      out_.push_back({out_free_, c});
    }
    const bool more = (!in_.empty() && in_.front().at <= now) ||
                      (emulator_->next_event() && *emulator_->next_event() <= now);
    if (!more) break;
  }
  std::string arrived;
  while (!out_.empty() && out_.front().at <= now) {
    arrived += out_.front().value;
    out_.pop_front();
  }
  schedule();
  if (!arrived.empty() && end_ && end_->listener) end_->listener->bytes_arrived(arrived);
}

void Loopback::schedule() {
  Instant next = Instant::max();
  if (const auto event = emulator_->next_event()) next = *event;
  if (!in_.empty()) next = std::min(next, in_.front().at);
  if (!out_.empty()) next = std::min(next, out_.front().at);
  if (next == Instant::max()) return timer_.disarm();
  timer_.arm(std::max(next, scheduler_.now()));
}

}  // namespace hw::test
