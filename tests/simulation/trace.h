#pragma once
// What happened, line by line, for a person who wants to understand a finding: --trace.
#include <ostream>
#include <string>
#include <string_view>

#include "core/time/clock.h"

namespace hw::simulation {

class Trace {
 public:
  explicit Trace(std::ostream& to) : to_(to) {}
  ~Trace() { flush(); }
  /// Bytes on the wire of a device; those that follow each other closely make one line.
  void bytes(Instant at, int device, char way, std::string_view bytes);
  void line(Instant at, std::string_view text);

 private:
  void flush();

  static constexpr Duration apart = Millis(5);
  std::ostream& to_;
  std::string gathered_;
  Instant began_{}, latest_{};
  int device_ = -1;
  char way_ = 0;
};

}  // namespace hw::simulation
