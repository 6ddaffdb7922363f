#pragma once
// Identifies the controller that answers, and its name; or reports why none does.
#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class Finding {
 public:
  Finding(const Console& console, Conversation& conversation)
      : console_(console), conversation_(conversation) {}

  Task<Result<>> identify();
  Task<Result<>> read_name();
  void wire_lost() { was_lost_ = true; }

  /// After this long, replies that make no sense are final.
  static constexpr Duration long_asked = std::chrono::seconds(3);

 private:
  Task<Result<Reply>> ask_identity(std::string question, std::function<bool(std::string_view)> is_it);
  void note_how_slow();
  tl::unexpected<Fault> silent() const;
  tl::unexpected<Fault> garbled(std::string_view bytes) const;
  tl::unexpected<Fault> echoed() const;
  tl::unexpected<Fault> line_feeds_come() const;
  [[nodiscard]] int factory_id() const;
  [[nodiscard]] std::string rate_advice(int rate) const;

  const Console& console_;
  Conversation& conversation_;
  bool was_lost_ = false;
  bool name_reported_ = false, slow_reported_ = false;
};

}  // namespace hw::arcus
