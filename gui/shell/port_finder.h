#pragma once
// The connection page's interface to the search for controllers that are plugged in. Other threads look
// (serial ports, USB names, a harmless question at each rate).
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
    asking,     ///< being asked now
    answers,    ///< `address` opens it
    busy,       ///< another program holds it, or it is open here
    forbidden,  ///< permission denied
    silent,     ///< opened and asked; no reply
    failed,     ///< could not be opened for another reason
  };
  /// One step of a test: "Port opens", "nobody else holds it".
  struct Check {
    enum class Result : std::uint8_t { good, bad, not_reached };
    Result result = Result::not_reached;
    std::string what, found;
  };

  std::string path;      ///< "/dev/ttyUSB0": the port's id while it is plugged in
  std::string hardware;  ///< "FTDI FT232R, A10K2LQX"
  std::string usb_serial;
  State state = State::not_asked;
  std::string title;     ///< catalog name of the controller that answers; empty while unknown
  std::string sentence;  ///< "answers at 9600 baud in 11 ms"; busy, forbidden, silent: why and what to do
  std::string address;   ///< if it answers: address for Connect
  std::vector<Check> checks;        ///< of the last test
  std::vector<std::string> advice;  ///< if silent: what to check, in this order
};

class PortFinder {
 public:
  virtual ~PortFinder() = default;

  /// GUI thread. The present list; the console's wake() announces changes.
  virtual const std::vector<FoundPort>& ports() = 0;
  /// Lists the ports anew, and asks each. A port that is open here is locked, and reported as busy.
  virtual void look() = 0;
  /// While on, newly plugged cables are found and asked. On while the connection page is open.
  virtual void watch(bool on) = 0;
  /// Asks one port again: opens it, sends one harmless question at each rate, closes it.
  virtual void ask(const std::string& path) = 0;
  /// Returns whether a search or a question is under way.
  [[nodiscard]] virtual bool busy() const = 0;
  /// For the link doctor; null: not available.
  [[nodiscard]] virtual PortExaminer* examiner() { return nullptr; }
  /// Null: emulators cannot be served.
  [[nodiscard]] virtual EmulatorServer* server() { return nullptr; }
};

/// Finds nothing: headless runs.
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
