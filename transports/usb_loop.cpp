#include "transports/usb_loop.h"

#include <boost/asio/posix/basic_stream_descriptor.hpp>
#include <map>
#include <set>

#include <fmt/core.h>
#include <libusb-1.0/libusb.h>
#include <poll.h>

namespace hw {

struct UsbLoop::State : std::enable_shared_from_this<State> {
  using Descriptor = asio::posix::basic_stream_descriptor<Executor>;

  Scheduler& scheduler;
  libusb_context* context = nullptr;
  std::map<int, std::unique_ptr<Descriptor>> watched;  // libusb closes them
  std::function<void()> changed;
  libusb_hotplug_callback_handle hotplug = 0;

  std::set<int> plain;  // descriptors that epoll does not support (the file of an emulated device)
  Timer often;          // polls `plain`, which counts as always ready

  explicit State(Scheduler& s)
      : scheduler(s), often(s, [this] {
          handle_events();
          if (!plain.empty()) look_often();
        }) {}
  ~State() {
    if (!context) return;
    libusb_set_pollfd_notifiers(context, nullptr, nullptr, nullptr);
    for (auto& [fd, descriptor] : watched) descriptor->release();
    if (changed) libusb_hotplug_deregister_callback(context, hotplug);
    libusb_exit(context);
  }

  void add(int fd, short events) {
    auto& descriptor = watched[fd] = std::make_unique<Descriptor>(scheduler.executor(), fd);
    wait(*descriptor, fd, (events & POLLOUT) != 0);
  }
  void remove(int fd) {
    const auto found = watched.find(fd);
    if (found == watched.end()) return;
    found->second->release();
    watched.erase(found);
    plain.erase(fd);
  }
  void wait(Descriptor& descriptor, int fd, bool writable) {
    const auto kind =
        writable ? asio::posix::descriptor_base::wait_write : asio::posix::descriptor_base::wait_read;
    descriptor.async_wait(kind, [weak = weak_from_this(), fd, writable](boost::system::error_code error) {
      const auto self = weak.lock();
      if (!self || error == asio::error::operation_aborted) return;
      if (error) {
        self->plain.insert(fd);
        return self->look_often();
      }
      self->handle_events();
      if (const auto found = self->watched.find(fd); found != self->watched.end())
        self->wait(*found->second, fd, writable);
    });
  }
  void look_often() { often.arm(scheduler.now() + Millis(1)); }
  static void LIBUSB_CALL fd_added(int fd, short events, void* state) {
    static_cast<State*>(state)->add(fd, events);
  }
  static void LIBUSB_CALL fd_removed(int fd, void* state) { static_cast<State*>(state)->remove(fd); }
  // The call is posted, because libusb must not be called from its own callback.
  static int LIBUSB_CALL plugged(libusb_context*, libusb_device*, libusb_hotplug_event, void* state) {
    static_cast<State*>(state)->notify_soon();
    return 0;
  }
  void notify_soon() {
    asio::post(scheduler.executor(), [weak = weak_from_this()] {
      if (const auto alive = weak.lock(); alive && alive->changed) alive->changed();
    });
  }

  void handle_events() {
    timeval at_once{};
    libusb_handle_events_timeout_completed(context, &at_once, nullptr);
  }
};

Result<std::unique_ptr<UsbLoop>> UsbLoop::make(Scheduler& scheduler) {
  auto state = std::make_shared<State>(scheduler);
  if (const int error = libusb_init(&state->context); error != 0)
    return fail(FaultKind::port, fmt::format("USB cannot be used here: {}.", usb_error(error)),
                "Nothing was opened.");
  if (!libusb_pollfds_handle_timeouts(state->context))
    return fail(FaultKind::port, "USB cannot be used here: this libusb has no timers of its own.",
                "Nothing was opened.", "Install libusb 1.0 as Debian builds it.");
  if (const libusb_pollfd** all = libusb_get_pollfds(state->context)) {
    for (const libusb_pollfd** one = all; *one; ++one) state->add((*one)->fd, (*one)->events);
    libusb_free_pollfds(all);
  }
  libusb_set_pollfd_notifiers(state->context, State::fd_added, State::fd_removed, state.get());
  return std::unique_ptr<UsbLoop>(new UsbLoop(std::move(state)));
}

UsbLoop::UsbLoop(std::shared_ptr<State> state) : state_(std::move(state)) {}
UsbLoop::~UsbLoop() = default;

libusb_context* UsbLoop::context() const { return state_->context; }

Result<> UsbLoop::watch(int vendor, int product, std::function<void()> changed) {
  const int error = libusb_hotplug_register_callback(
      state_->context, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0, vendor,
      product, LIBUSB_HOTPLUG_MATCH_ANY, State::plugged, state_.get(), &state_->hotplug);
  if (error != 0)
    return fail(FaultKind::port, fmt::format("New USB devices cannot be noticed: {}.", usb_error(error)));
  state_->changed = std::move(changed);
  state_->notify_soon();
  return {};
}

void UsbLoop::run_until(const std::function<bool()>& done, Millis patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!done() && std::chrono::steady_clock::now() < end) {
    timeval a_while{0, 20'000};
    libusb_handle_events_timeout_completed(state_->context, &a_while, nullptr);
  }
}

std::string usb_error(int number) { return libusb_strerror(static_cast<libusb_error>(number)); }

}  // namespace hw
