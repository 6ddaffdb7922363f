#include "transports/vme_device.h"

#include <cerrno>
#include <csetjmp>
#include <csignal>
#include <cstring>

#include <endian.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "transports/gone.h"
#include "transports/port_holder.h"

namespace hw {
namespace {

constexpr std::size_t window_bytes = 0x1000;
constexpr std::uint32_t short_space_bytes = 0x10000;

// ---- the kernel's user-space VME device: its request for a window onto the bus, as its driver defines it

struct [[gnu::packed]] MasterWindow {
  std::uint32_t enable;
  std::uint64_t bus_address, size;
  std::uint32_t address_space, cycle, data_width;
};
constexpr unsigned long set_master_window = _IOW(0xAE, 4, MasterWindow);
constexpr std::uint32_t space_a16 = 0x1, single_cycles = 0x1, supervisory = 0x1000, data = 0x8000,
                        width_16 = 0x2;

// Requests the whole short space, because bridges assign windows in units of 64 KiB.
int ask_for_short_space(int fd, DeviceRequest request) {
  MasterWindow window{1, 0, short_space_bytes, space_a16, single_cycles | supervisory | data, width_16};
  return request(fd, set_master_window, &window);
}
int ask_the_kernel(int fd, unsigned long request, void* argument) { return ::ioctl(fd, request, argument); }

// ---- access to memory that may disappear

// Mapped memory may disappear (a bridge is removed, a file truncated). An access then raises SIGBUS, which
// within a Guard ends only the accesses.
thread_local sigjmp_buf* volatile way_out = nullptr;  // volatile: the handler reads it between two accesses
struct sigaction before_us;

void on_bus_error(int number, siginfo_t*, void*) {
  if (way_out) siglongjmp(*way_out, 1);
  ::sigaction(SIGBUS, &before_us, nullptr);
  ::raise(number);
}

void catch_bus_errors() {
  static const bool installed = [] {
    struct sigaction action {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
    ::sigaction(SIGBUS, &action, &before_us);
    return true;
  }();
  (void)installed;
}

std::uint16_t read_word(volatile std::uint8_t* at) {
  return be16toh(*reinterpret_cast<volatile std::uint16_t*>(at));
}
void write_word(volatile std::uint8_t* at, std::uint32_t value) {
  *reinterpret_cast<volatile std::uint16_t*>(at) = htobe16(static_cast<std::uint16_t>(value));
}

void access(volatile std::uint8_t* window, BusCycle& cycle) {
  volatile std::uint8_t* at = window + cycle.offset;
  if (cycle.width == 1) {
    if (cycle.write)
      *at = static_cast<std::uint8_t>(cycle.value);
    else
      cycle.value = *at;
  } else if (cycle.width == 2) {
    if (cycle.write)
      write_word(at, cycle.value);
    else
      cycle.value = read_word(at);
  } else if (cycle.write) {
    write_word(at, cycle.value >> 16);
    write_word(at + 2, cycle.value & 0xFFFF);
  } else {
    const std::uint32_t high = read_word(at);
    cycle.value = high << 16 | read_word(at + 2);
  }
}

bool lies_inside(const BusCycle& cycle) {
  return cycle.offset + cycle.width <= window_bytes && (cycle.width == 1 || cycle.offset % 2 == 0);
}

// Returns false when the memory has disappeared. (No object with a destructor exists between sigsetjmp and
// the accesses.)
bool access_all(volatile std::uint8_t* window, std::span<BusCycle> cycles) {
  sigjmp_buf here;
  if (sigsetjmp(here, 0) != 0) {
    way_out = nullptr;
    return false;
  }
  way_out = &here;
  for (BusCycle& cycle : cycles) {
    if (lies_inside(cycle))
      access(window, cycle);
    else if (!cycle.write)
      cycle.value = 0xFFFFFFFFu >> (32 - 8 * cycle.width);
  }
  way_out = nullptr;
  return true;
}

class VmeDevice final : public Window {
 public:
  VmeDevice(Scheduler& scheduler, int fd, std::uint32_t base, void* memory, std::string place)
      : scheduler_(scheduler),
        fd_(fd),
        base_(base),
        memory_(memory),
        place_(std::move(place)),
        link_(std::make_shared<Link>()) {
    catch_bus_errors();
  }
  ~VmeDevice() override {
    link_->listener = nullptr;
    ::munmap(memory_, window_bytes);
    ::close(fd_);
  }
  void listen(Listener* listener) override { link_->listener = listener; }
  [[nodiscard]] WireShare share() const override { return {WireShare::How::memory, fd_, {}, base_}; }
  [[nodiscard]] std::string describe() const override { return place_; }

  Task<Result<>> run(std::span<BusCycle> cycles) override {
    if (!gone_ && access_all(static_cast<volatile std::uint8_t*>(memory_), cycles)) co_return Result<>();
    const Fault why =
        gone(fmt::format("The window {} is gone.", place_),
             "Check that the VME bridge and its driver are still there. The console then opens it again.");
    if (!std::exchange(gone_, true))
      asio::post(scheduler_.executor(), [link = link_, why] {
        if (link->listener) link->listener->window_closed(why);
      });
    co_return fail(why);
  }

 private:
  struct Link {
    Listener* listener = nullptr;
  };
  Scheduler& scheduler_;
  int fd_;
  std::uint32_t base_;
  void* memory_;
  std::string place_;
  std::shared_ptr<Link> link_;
  bool gone_ = false;
};

// ---- opening

tl::unexpected<Fault> cannot_open(const std::string& device, int error) {
  const auto no = [&](std::string what, std::string advice) {
    return fail(FaultKind::port, std::move(what), "Nothing was opened.", std::move(advice));
  };
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return no(fmt::format("There is no {}.", device),
                "A VME device is called /dev/bus/vme/m0, for example. Load the driver of the VME bridge and "
                "vme_user first.");
    case EACCES:
    case EPERM:
      return no(fmt::format("This user may not open {} for reading and writing.", device),
                "Add the user to the group that owns it, or add a udev rule.");
    case EISDIR: return no(fmt::format("{} is a folder, not a device.", device), "Choose a device in it.");
    default:
      return no(fmt::format("{} cannot be opened: {}.", device, std::strerror(error)),
                "Check that the VME bridge and its driver are there.");
  }
}

tl::unexpected<Fault> held_elsewhere(const std::string& device) {
  const std::string holder = port_holder(device);
  return fail(FaultKind::port, fmt::format("{} is in use{}.", device, holder.empty() ? "" : " by " + holder),
              "Nothing was opened.",
              "Close the other program: two programs on one board would take each other's replies.");
}

// The offset of the window in the file.
Result<std::uint32_t> place_in(int fd, const std::string& device, std::uint32_t base, DeviceRequest request) {
  struct stat info {};
  if (::fstat(fd, &info) != 0) return cannot_open(device, errno);
  if (S_ISDIR(info.st_mode)) return cannot_open(device, EISDIR);
  if (!S_ISREG(info.st_mode)) {
    if (ask_for_short_space(fd, request) == 0 || errno == ENOTTY || errno == EINVAL) return base;
    return fail(
        FaultKind::port,
        fmt::format("{} provides no window onto the short address space: {}.", device, std::strerror(errno)),
        "Nothing was opened.", "Another master window may be free: /dev/bus/vme/m1 and so on.");
  }
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size >= base + window_bytes) return base;
  if (size == window_bytes) return 0;
  return fail(
      FaultKind::port,
      fmt::format("{} has {} bytes, too few for a window of 4096 bytes at 0x{:04X}.", device, size, base),
      "Nothing was opened.",
      "A file that stands in for a board has 4096 bytes, or 65536 for the whole short space.");
}

Result<std::unique_ptr<Window>> map_window(Scheduler& scheduler, int fd, const std::string& device,
                                           std::uint32_t base, DeviceRequest request) {
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return held_elsewhere(device);
  const auto offset = place_in(fd, device, base, request);
  if (!offset) return fail(offset.error());
  void* memory = ::mmap(nullptr, window_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd, *offset);
  if (memory == MAP_FAILED)
    return fail(FaultKind::port,
                fmt::format("{} cannot be mapped at 0x{:04X}: {}.", device, base, std::strerror(errno)),
                "Nothing was opened.", "Choose the VME device of the bridge, as /dev/bus/vme/m0.");
  return std::make_unique<VmeDevice>(scheduler, fd, *offset, memory,
                                     fmt::format("{} at 0x{:04X}", device, base));
}

}  // namespace

Result<std::unique_ptr<Window>> open_vme_device(Scheduler& scheduler, const std::string& device,
                                                std::uint32_t base, DeviceRequest request) {
  if (base % window_bytes != 0 || base >= short_space_bytes)
    return fail(FaultKind::text, fmt::format("base=0x{:X} is not an address for a board.", base),
                "Nothing was opened.",
                "It is a multiple of 0x1000 from 0 to 0xF000, set by the board's jumpers.");
  const int fd = ::open(device.c_str(), O_RDWR | O_SYNC | O_CLOEXEC);
  if (fd < 0) return cannot_open(device, errno);
  auto window = map_window(scheduler, fd, device, base, request ? request : ask_the_kernel);
  if (!window) ::close(fd);
  return window;
}

}  // namespace hw
