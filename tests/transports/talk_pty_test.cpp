// The transcripts of tests/talk once more, through what other software gets: a real pseudo-terminal and a
// file descriptor. The emulator's time is virtual, so that minutes of motion pass at once and at the same
// instants.
#include <algorithm>
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "core/time/virtual_scheduler.h"
#include "tests/core/device/emulator_around.h"
#include "tests/talk/talk_test.h"
#include "tests/transports/pseudo_terminal.h"
#include "transports/pty_endpoint.h"
#include "transports/serve.h"

namespace hw {
namespace {

using namespace std::chrono_literals;

/// Counts the bytes both ways, to know when a kernel's buffer holds none of them any more.
class Counted final : public test::EmulatorAround {
 public:
  struct Bytes {
    std::size_t received = 0, sent = 0;
  };
  Counted(std::unique_ptr<Emulator> inner, Bytes& bytes) : EmulatorAround(std::move(inner)), bytes_(bytes) {}

  void receive(std::string_view text) override {
    bytes_.received += text.size();
    inner_->receive(text);
  }
  void take_output(std::string& sink) override {
    const std::size_t before = sink.size();
    inner_->take_output(sink);
    bytes_.sent += sink.size() - before;
  }

 private:
  Bytes& bytes_;
};

class PtyPartner final : public talk::Partner {
 public:
  PtyPartner(const DeviceType& type, const DeviceOptions& options) {
    std::filesystem::create_directories(folder_);
    auto emulator = type.make_emulator(options);
    auto made = EmulatorHost::make(clock_, std::make_unique<Counted>(std::move(*emulator), bytes_), {});
    host_ = *made;
    bench_ = host_->bench();
    // An endless bench, and the lamps of the start are over.
    const std::size_t axes = type.make_catalog(options)->axes.size();
    for (std::size_t i = 0; i < axes; ++i)
      (void)bench_->operate(bench::Place(AxisId{static_cast<std::uint8_t>(i)}, {}));
    host_->attach(std::move(*open_pty_endpoint(clock_, link_, bench_->emulator().rate())));
    pass(10s);
    fd_ = ::open(link_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  }
  ~PtyPartner() override {
    if (fd_ >= 0) ::close(fd_);
    bench_.reset();
    host_.reset();
    std::filesystem::remove_all(folder_);
  }

  void send(std::string_view text) override {
    const std::size_t wanted = bytes_.received + text.size();
    EXPECT_EQ(::write(fd_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    settle([&] { return bytes_.received >= wanted; });
  }
  std::string receive(std::size_t count) override {
    const Instant limit = clock_.now() + 24h;
    for (; came_.size() < count; pass_on()) {
      const auto next = bench_->emulator().next_event();
      if (!next || *next > limit) break;
      clock_.run_until(std::max(*next, clock_.now() + Duration(1)));
    }
    std::string taken = came_.substr(0, count);
    came_.erase(0, count);
    return taken;
  }
  std::string leftover() override {
    pass_on();
    return std::exchange(came_, {});
  }
  void pass(Duration time) override {
    clock_.run_for(time);
    pass_on();
  }
  Result<> operate(const BenchCommand& command) override { return bench_->operate(command); }

 private:
  // The kernel carries bytes between the two ends in its own time; the emulator's stands still meanwhile.
  template <class Done>
  void settle(Done done) {
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (clock_.run_until(clock_.now(), done), !done()) {
      ASSERT_LT(std::chrono::steady_clock::now(), end) << "the terminal does not carry what was sent";
      io_.restart();
      io_.run_one_for(1ms);
    }
    pass_on();
  }
  // Until everything that was said has come. Before a client is there it goes nowhere.
  void pass_on() {
    if (fd_ < 0) {
      read_ = bytes_.sent;
      return;
    }
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (read_ < bytes_.sent) {
      ASSERT_LT(std::chrono::steady_clock::now(), end) << "the terminal does not carry what was answered";
      clock_.run_until(clock_.now());
      char part[512];
      if (const ssize_t n = ::read(fd_, part, sizeof part); n > 0) {
        came_.append(part, static_cast<std::size_t>(n));
        read_ += static_cast<std::size_t>(n);
      } else {
        pollfd client{fd_, POLLIN, 0};
        ::poll(&client, 1, 1);
      }
    }
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("hw-talk-" + std::to_string(::getpid()));
  std::string link_ = folder_ / "controller";
  IoContext io_{1};
  VirtualScheduler clock_{io_};
  Counted::Bytes bytes_;
  std::shared_ptr<EmulatorHost> host_;
  std::shared_ptr<BenchAccess> bench_;
  int fd_ = -1;
  std::size_t read_ = 0;
  std::string came_;
};

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    if (catalog && catalog->can.window) continue;  // no line to speak over
    const auto of_model = talk::transcripts(type.model);
    names.insert(names.end(), of_model.begin(), of_model.end());
  }
  return names;
}

class TalkOverPty : public ::testing::TestWithParam<std::string> {};

TEST_P(TalkOverPty, GoesAsWritten) {
  HW_NEEDS_PSEUDO_TERMINAL();
  const DeviceType& type = *find_device_type(GetParam().substr(0, GetParam().find('/')));
  talk::goes_as_written(GetParam(), [&](const DeviceOptions& options) { return PtyPartner(type, options); });
}

INSTANTIATE_TEST_SUITE_P(Transcripts, TalkOverPty, ::testing::ValuesIn(transcripts()), talk::test_name);

}  // namespace
}  // namespace hw
