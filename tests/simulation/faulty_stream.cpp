#include "tests/simulation/faulty_stream.h"

#include <deque>
#include <string>

namespace hw::simulation {
namespace {

/// What is late on one way, in its order.
class Late {
 public:
  Late(Scheduler& scheduler, std::function<void(std::string_view)> arrive)
      : scheduler_(scheduler), arrive_(std::move(arrive)), timer_(scheduler, [this] { due(); }) {}

  void put(std::string bytes, Instant when) {
    if (bytes.empty()) return;
    if (queue_.empty() && when <= scheduler_.now()) return arrive_(bytes);
    if (!queue_.empty()) when = std::max(when, queue_.back().when);
    queue_.push_back({when, std::move(bytes)});
    if (!timer_.armed()) timer_.arm(queue_.front().when);
  }
  void clear() {
    queue_.clear();
    timer_.disarm();
  }
  [[nodiscard]] Instant last() const { return queue_.empty() ? Instant{} : queue_.back().when; }

 private:
  struct Piece {
    Instant when;
    std::string bytes;
  };
  // All that is due at once comes in one piece: that is how replies merge.
  void due() {
    std::string bytes;
    while (!queue_.empty() && queue_.front().when <= scheduler_.now()) {
      bytes += queue_.front().bytes;
      queue_.pop_front();
    }
    if (!queue_.empty()) timer_.arm(queue_.front().when);
    arrive_(bytes);
  }

  Scheduler& scheduler_;
  std::function<void(std::string_view)> arrive_;
  Timer timer_;
  std::deque<Piece> queue_;
};

class FaultyStream final : public Stream, public Stream::Listener {
 public:
  FaultyStream(Scheduler& scheduler, std::unique_ptr<Stream> inner, WireFaults& faults)
      : scheduler_(scheduler),
        inner_(std::move(inner)),
        faults_(faults),
        out_(scheduler, [this](std::string_view bytes) { inner_->send(bytes); }),
        in_(scheduler, [this](std::string_view bytes) {
          if (listener_ != nullptr) listener_->bytes_arrived(bytes);
        }) {
    inner_->listen(this);
    if (faults_.babbles_until > scheduler.now()) babble();
    faults_.begin_babble = [this] { babble(); };
  }
  ~FaultyStream() override {
    inner_->listen(nullptr);
    faults_.begin_babble = nullptr;
  }

  void listen(Stream::Listener* listener) override { listener_ = listener; }
  void send(std::string_view bytes) override {
    pass(faults_.unknown.to_controller(bytes), faults_.out, out_);
  }
  void discard_unsent() override {
    out_.clear();
    inner_->discard_unsent();
  }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void bytes_arrived(std::string_view bytes) override {
    pass(faults_.unknown.to_console(bytes), faults_.in, in_);
  }
  void stream_closed(const Fault& why) override {
    in_.clear();
    if (listener_ != nullptr) listener_->stream_closed(why);
  }
  // As many bytes as 9,600 baud let through.
  void babble() {
    const Instant now = scheduler_.now();
    if (now >= faults_.babbles_until) return;
    faults_.in.talked_into(now);
    babble_.arm(now + Millis(10));
    if (listener_ != nullptr) listener_->bytes_arrived("U*U*U*U*U*");
  }
  void pass(std::string_view bytes, WayFaults& way, Late& late) const {
    const Instant now = scheduler_.now();
    if (now < way.gaps_until) {
      Instant next = std::max(now, late.last() + way.gap);
      for (const char c : bytes) {
        late.put(way.treat(std::string_view(&c, 1), now), next);
        way.held_until(next);
        next += way.gap;
      }
      return;
    }
    const Instant when = std::max(now + way.delay_at(now), std::max(way.merge_until, now));
    late.put(way.treat(bytes, now), when);
    if (late.last() > now) way.held_until(late.last());
  }

  Scheduler& scheduler_;
  std::unique_ptr<Stream> inner_;
  WireFaults& faults_;
  Late out_, in_;
  Stream::Listener* listener_ = nullptr;
  Timer babble_{scheduler_, [this] { babble(); }};
};

}  // namespace

std::unique_ptr<Stream> make_faulty_stream(Scheduler& scheduler, std::unique_ptr<Stream> inner,
                                           WireFaults& faults) {
  return std::make_unique<FaultyStream>(scheduler, std::move(inner), faults);
}

}  // namespace hw::simulation
