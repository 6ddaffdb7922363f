#include "tests/simulation/trace.h"

#include <fmt/core.h>

namespace hw::simulation {

void Trace::bytes(Instant at, int device, char way, std::string_view bytes) {
  if (device != device_ || way != way_ || at - latest_ > apart) flush();
  if (gathered_.empty()) began_ = at;
  device_ = device, way_ = way, latest_ = at;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    gathered_ += byte >= 32 && byte < 127 ? std::string(1, c) : fmt::format("<{:02X}>", byte);
  }
}

void Trace::line(Instant at, std::string_view text) {
  flush();
  to_ << fmt::format("{:9.4f}   {}\n", seconds(at), text);
}

void Trace::flush() {
  if (gathered_.empty()) return;
  to_ << fmt::format("{:9.4f} {} {} {}\n", seconds(began_), device_, way_, gathered_);
  gathered_.clear();
}

}  // namespace hw::simulation
