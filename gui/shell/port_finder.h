#pragma once
// Through this interface the connection page finds controllers that are plugged in. Other threads do the
// work: they list serial ports and USB names, and ask a harmless question at each rate.
#include <cstdint>
#include <string>
#include <vector>

#include "core/time/clock.h"

namespace hw::gui {

class EmulatorServer;
class PortExaminer;

/// A possible way to a controller.
struct FoundPort {
  enum class State : std::uint8_t {
    not_asked,  ///< listed, but not opened
    asking,     ///< is being asked now
    answers,    ///< `address` opens it
    busy,       ///< another program has it open, or it is open here
    forbidden,  ///< permission denied
    silent,     ///< opened and asked; no reply
    failed,     ///< it could not be opened for another reason
  };
  /// A step of a test, such as "Port opens".
  struct Check {
    enum class Result : std::uint8_t { good, bad, not_reached };
    Result result = Result::not_reached;
    std::string what, found;
  };

  std::string path;      ///< "/dev/ttyUSB0": the port's id while it is plugged in
  std::string hardware;  ///< "FTDI FT232R, A10K2LQX"
  std::string usb_serial;
  State state = State::not_asked;
  std::string title;  ///< catalog name of the controller that answers; empty while unknown
  std::string
      sentence;  ///< "answers at 9600 baud in 11 ms"; if busy, forbidden or silent: why, and what to do
  std::string address;              ///< if it answers: address for Connect
  std::vector<Check> checks;        ///< steps of the last test
  std::vector<std::string> advice;  ///< if silent: what to check, in this order
};

class PortFinder {
 public:
  virtual ~PortFinder() = default;

  /// The present list. The console's wake() announces changes. GUI thread.
  virtual const std::vector<FoundPort>& ports() = 0;
  /// Lists the ports anew and asks each of them. A port that is open here cannot be asked and is reported as
  /// busy.
  virtual void look() = 0;
  /// While on, ports that are plugged in are found and asked. The connection page turns it on while it is
  /// open.
  virtual void watch(bool on) = 0;
  /// Asks a port again: opens it, sends a harmless question at each rate, and closes it.
  virtual void ask(const std::string& path) = 0;
  /// Whether a search or a question is under way.
  [[nodiscard]] virtual bool busy() const = 0;
  /// For the link doctor; null: not available.
  [[nodiscard]] virtual PortExaminer* examiner() { return nullptr; }
  /// Null: emulators cannot be served.
  [[nodiscard]] virtual EmulatorServer* server() { return nullptr; }
};

/// A finder without ports, for headless runs.
class NoPorts final : public PortFinder {
 public:
  const std::vector<FoundPort>& ports() override { return none_; }
  void look() override {}
  void watch(bool) override {}
  void ask(const std::string&) override {}
  [[nodiscard]] bool busy() const override { return false; }

 private:
  std::vector<FoundPort> none_;
};

}  // namespace hw::gui
