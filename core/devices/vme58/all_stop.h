#pragma once
// Stops of all axes: SA, SD and KL. They go through the mailbox, which they may only seem to: whether one was
// obeyed shows by the axes, and by what waits in the queues behind it.
#include "core/devices/vme58/mailbox.h"
#include "core/devices/vme58/queues.h"
#include "core/devices/vme58/stop_effect.h"

namespace hw::vme58 {

class AllStop {
 public:
  AllStop(Wire& wire, const Selection& selection, Conversation& conversation, Mailbox& mailbox,
          Queues& queues, Motions& motions, const StopEffect& effect, const Catalog& catalog, Snapshot& draft)
      : wire_(wire),
        selection_(selection),
        conversation_(conversation),
        mailbox_(mailbox),
        queues_(queues),
        motions_(motions),
        effect_(effect),
        catalog_(catalog),
        draft_(draft) {}

  /// Through the ring too where the mailbox does nothing, or where it would not show that it does nothing: no
  /// axis turns fast enough to be seen slowing down, and one may creep all the same.
  Task<Result<>> send(std::string_view word);
  /// A stop of all empties the queues, and one that was not obeyed leaves what waits there: between two of
  /// its motions an axis rests for a moment. Asked as soon as none turns.
  Task<Result<>> look_at_queues();
  enum class Behind : std::uint8_t { nothing, not_known, waits };
  /// It. Queues that do not answer are not waited for longer than an axis may rest between two motions.
  [[nodiscard]] Behind behind() const;
  /// It went out before the ring was known, or another stop hides what comes of it: nothing has shown that
  /// the mail was acted on.
  [[nodiscard]] bool owes_ring() const;
  /// ST of one axis: what slows down now may do so by that.
  void another_was_sent();
  void in_vain();
  /// The connection is gone, or the board was reset.
  void forget() { behind_ = Behind::nothing; }

 private:
  void doubt_positions();
  [[nodiscard]] bool any_moves() const;

  Wire& wire_;
  const Selection& selection_;
  Conversation& conversation_;
  Mailbox& mailbox_;
  Queues& queues_;
  Motions& motions_;
  const StopEffect& effect_;
  const Catalog& catalog_;
  Snapshot& draft_;
  bool mailbox_deaf_ = false;  ///< it was acknowledged and nothing was done
  bool by_mail_alone_ = false;
  Behind behind_ = Behind::nothing;
  Instant rests_since_{};  ///< no axis was seen turning since then, or since that stop
};

}  // namespace hw::vme58
