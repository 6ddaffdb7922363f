#pragma once
// What is plugged in, as the connection page sees it. The page asks and draws; who looks (serial ports, USB
// names, a harmless question at each rate) stands behind this interface, on other threads.
#include <cstdint>
#include <string>
#include <vector>

#include "core/time/clock.h"

namespace hw::gui {

class EmulatorServer;
class PortExaminer;

/// One way that may lead to a controller.
struct FoundPort {
  enum class State : std::uint8_t {
    not_asked,  ///< listed, not opened
    asking,     ///< being asked now
    answers,    ///< `address` opens it
    busy,       ///< another program holds it, or it is open here
    forbidden,  ///< no permission
    silent,     ///< opened and asked, nothing came back
    failed,     ///< could not be opened for another reason
  };
  /// One link of the chain of a test: "Port opens", "nobody else holds it".
  struct Check {
    enum class Result : std::uint8_t { good, bad, not_reached };
    Result result = Result::not_reached;
    std::string what, found;
  };

  std::string path;      ///< "/dev/ttyUSB0": its id as long as it is plugged in
  std::string hardware;  ///< "FTDI FT232R, A10K2LQX"
  std::string usb_serial;
  State state = State::not_asked;
  std::string title;     ///< the catalog's name of what answers; empty while unknown
  std::string sentence;  ///< "answers at 9600 baud in 11 ms"; busy, forbidden, silent: why and what to do
  std::string address;   ///< answers: what Connect opens
  std::vector<Check> checks;        ///< of the last test
  std::vector<std::string> advice;  ///< silent: what to look at, in this order
};

class PortFinder {
 public:
  virtual ~PortFinder() = default;

  /// GUI thread. The list as it is now; changes are announced by the console's wake().
  virtual const std::vector<FoundPort>& ports() = 0;
  /// Looks again which ports exist, and asks each. One that is open here is locked, so it only says so.
  virtual void look() = 0;
  /// While on, new cables appear by themselves and are asked. On while the connection page is open.
  virtual void watch(bool on) = 0;
  /// Asks one port afresh: opens it, a lone harmless question at each rate, closes it.
  virtual void ask(const std::string& path) = 0;
  /// Something is being looked for or asked.
  [[nodiscard]] virtual bool busy() const = 0;
  /// For the link doctor; null: nobody looks.
  [[nodiscard]] virtual PortExaminer* examiner() { return nullptr; }
  /// Null: nobody serves emulators.
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
