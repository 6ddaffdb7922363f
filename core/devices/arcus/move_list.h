#pragma once
// A list of moves, fed into the controller's buffer as its places become free.
#include <array>
#include <deque>
#include <functional>
#include <vector>

#include "core/device/intent.h"
#include "core/devices/arcus/conversation.h"

namespace hw::arcus {

class MoveList {
 public:
  MoveList(const Console& console, Conversation& conversation)
      : console_(console), conversation_(conversation) {}

  // ---- from the status
  void buffer_is(bool on) { buffer_on_ = on; }
  void places_are(int free) { buffer_free_ = free; }

  [[nodiscard]] Result<> accepts(const intent::FeedMoves& request) const;
  [[nodiscard]] bool buffer_is_on() const { return buffer_on_; }
  Task<Result<>> switch_buffer_on();
  /// The list begins where the axes stand.
  void begin(std::vector<std::vector<std::int64_t>> rows);
  /// Sends as many moves as the buffer has places for; calls `moves` after each.
  Task<Result<>> feed(std::function<void()> moves);
  void end();

 private:
  void broken_off(Fault why);
  /// The speed of a row. In pieces, it is no higher than the wire allows for sending the next moves.
  [[nodiscard]] std::int64_t speed_of(const std::vector<std::int64_t>& row);
  void row_took(Duration time);

  const Console& console_;
  Conversation& conversation_;
  std::deque<std::vector<std::int64_t>> to_feed_;
  int buffer_free_ = 0;
  bool buffer_on_ = false;
  std::array<std::int64_t, 3> behind_{};  ///< end of the latest row
  Duration row_takes_{};                  ///< its reply included, on this wire
  bool slow_reported_ = false;
};

}  // namespace hw::arcus
