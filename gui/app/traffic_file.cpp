#include "gui/app/traffic_file.h"

#include <cerrno>
#include <utility>

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/session/user_files.h"

namespace hw::app {
namespace {

std::string readable(std::string_view bytes) {
  std::string all;
  for (const char c : bytes) {
    if (c == '\r')
      all += "\\r";
    else if (c == '\n')
      all += "\\n";
    else if (c == '\\')
      all += "\\\\";
    else if (c >= ' ' && c < 127)
      all += c;
    else
      all += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return all;
}

class Tapped final : public Stream, private Stream::Listener {
 public:
  Tapped(std::unique_ptr<Stream> inner, Scheduler& scheduler, std::shared_ptr<TrafficFile> file, int wire)
      : inner_(std::move(inner)), scheduler_(scheduler), file_(std::move(file)), wire_(wire) {}
  void listen(Stream::Listener* listener) override {
    listener_ = listener;
    inner_->listen(listener ? this : nullptr);
  }
  void send(std::string_view bytes) override {
    file_->write(scheduler_.now(), wire_, '>', bytes);
    inner_->send(bytes);
  }
  void discard_unsent() override { inner_->discard_unsent(); }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] bool carries_messages() const override { return inner_->carries_messages(); }
  [[nodiscard]] WireShare share() const override { return inner_->share(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void bytes_arrived(std::string_view bytes) override {
    file_->write(scheduler_.now(), wire_, '<', bytes);
    listener_->bytes_arrived(bytes);
  }
  void stream_closed(const Fault& why) override {
    file_->note(scheduler_.now(), wire_, why.what);
    listener_->stream_closed(why);
  }

  std::unique_ptr<Stream> inner_;
  Scheduler& scheduler_;
  std::shared_ptr<TrafficFile> file_;
  int wire_;
  Stream::Listener* listener_ = nullptr;
};

/// Writes each bus cycle on a line: "r8 0FE3 02", "w16 0804 0041".
class TappedWindow final : public Window, private Window::Listener {
 public:
  TappedWindow(std::unique_ptr<Window> inner, Scheduler& scheduler, std::shared_ptr<TrafficFile> file,
               int wire)
      : inner_(std::move(inner)), scheduler_(scheduler), file_(std::move(file)), wire_(wire) {}
  void listen(Window::Listener* listener) override {
    listener_ = listener;
    inner_->listen(listener ? this : nullptr);
  }
  Task<Result<>> run(std::span<BusCycle> cycles) override {
    auto done = co_await inner_->run(cycles);
    for (const BusCycle& c : cycles)
      file_->write(scheduler_.now(), wire_, c.write ? '>' : '<',
                   fmt::format("{}{} {:04X} {:0{}X}", c.write ? 'w' : 'r', 8 * c.width, c.offset, c.value,
                               2 * c.width));
    if (!done) file_->note(scheduler_.now(), wire_, done.error().what);
    co_return done;
  }
  void abandon() override { inner_->abandon(); }
  [[nodiscard]] bool reports_interrupts() const override { return inner_->reports_interrupts(); }
  [[nodiscard]] WireShare share() const override { return inner_->share(); }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void window_closed(const Fault& why) override {
    file_->note(scheduler_.now(), wire_, why.what);
    listener_->window_closed(why);
  }
  void interrupted(std::uint8_t vector) override {
    file_->note(scheduler_.now(), wire_, fmt::format("interrupt, vector {:02X}", vector));
    listener_->interrupted(vector);
  }

  std::unique_ptr<Window> inner_;
  Scheduler& scheduler_;
  std::shared_ptr<TrafficFile> file_;
  int wire_;
  Window::Listener* listener_ = nullptr;
};

Task<Result<Wire>> open_tapped(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again,
                               std::shared_ptr<const WireOpener> inner, std::shared_ptr<TrafficFile> file,
                               int wire) {
  file->note(scheduler.now(), wire, address.text());
  auto opened = co_await (*inner)(scheduler, std::move(address), std::move(again));
  if (!opened) {
    file->note(scheduler.now(), wire, opened.error().what);
    co_return opened;
  }
  if (opened->window)
    opened->window =
        std::make_unique<TappedWindow>(std::move(opened->window), scheduler, std::move(file), wire);
  else
    opened->stream = std::make_unique<Tapped>(std::move(opened->stream), scheduler, std::move(file), wire);
  co_return opened;
}

}  // namespace

Result<std::shared_ptr<TrafficFile>> TrafficFile::create(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
    return fail(FaultKind::port,
                fmt::format("{} cannot be written: {}.", shown_path(path), reason_of(errno)));
  return std::shared_ptr<TrafficFile>(new TrafficFile(file, path));
}
TrafficFile::~TrafficFile() {
  if (file_) std::fclose(file_);
}

WireOpener TrafficFile::tap(std::shared_ptr<TrafficFile> file, WireOpener inner) {
  auto shared = std::make_shared<const WireOpener>(std::move(inner));
  return [file, shared](Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
    return open_tapped(scheduler, std::move(address), std::move(again), shared, file, ++file->wires_);
  };
}

void TrafficFile::write(Instant at, int wire, char way, std::string_view bytes) {
  put(fmt::format("{:12.6f} {} {} {}\n", seconds(at), wire, way, readable(bytes)));
}
void TrafficFile::note(Instant at, int wire, std::string_view event) {
  put(fmt::format("{:12.6f} {} # {}\n", seconds(at), wire, event));
}

void TrafficFile::put(std::string_view line) {
  if (error_ != 0 || !file_ || std::fwrite(line.data(), 1, line.size(), file_) == line.size()) return;
  error_ = errno;
  if (on_failure) on_failure(not_written());
}

Result<> TrafficFile::finish() {
  on_failure = nullptr;
  // Network file systems report a full disk only here.
  if (file_ && std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) error_ = errno;
  if (error_ == 0) return {};
  return fail(not_written());
}

Fault TrafficFile::not_written() const {
  return Fault(FaultKind::port,
               fmt::format("{} cannot be written: {}.", shown_path(path_), reason_of(error_)));
}

}  // namespace hw::app
