#pragma once
// A link and a station on a wire whose other end is the test.
#include <gtest/gtest.h>

#include "core/link/station.h"
#include "core/time/virtual_scheduler.h"

namespace hw {

/// A wire whose other end is the test.
class FakeStream : public Stream {
 public:
  void listen(Listener* l) override { listener = l; }
  void discard_unsent() override {}
  void send(std::string_view bytes) override { sent.emplace_back(bytes); }
  Result<> set_rate(int baud) override { return rate_ = baud, Result<>(); }
  [[nodiscard]] int rate() const override { return rate_; }
  [[nodiscard]] std::string describe() const override { return "a test"; }

  Listener* listener = nullptr;
  std::vector<std::string> sent;
  int rate_ = 0;
};

struct LinkTest : testing::Test {
  IoContext io;
  VirtualScheduler time{io};
  TrafficRing traffic{64};
  FakeStream* wire = new FakeStream;
  std::shared_ptr<Link> link = std::make_shared<Link>(time, std::unique_ptr<Stream>(wire));
  Station station{link, &traffic};

  struct Answer {
    bool came = false;
    Result<std::string> result{std::string()};
  };
  static Task<> ask(Station& station, Transaction t, Answer& answer) {
    answer.result = co_await station.transact(std::move(t));
    answer.came = true;
  }
  void start(std::string bytes, ReplyShape shape, Priority p, Answer& answer) {
    Transaction t(std::move(bytes), shape, p);
    asio::co_spawn(io, ask(station, std::move(t), answer), asio::detached);
    time.run_for(Duration::zero());
  }
  void arrive(std::string_view bytes) {
    wire->listener->bytes_arrived(bytes);
    time.run_for(Duration::zero());
  }
};

}  // namespace hw
