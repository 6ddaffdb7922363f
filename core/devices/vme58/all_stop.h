#pragma once
// Stops of all axes: SA, SD and KL, sent through the mailbox. An acknowledged stop may still have no effect:
// only the axes, and then the queues, show whether the board obeyed.
#include "core/devices/vme58/mailbox.h"
#include "core/devices/vme58/queues.h"
#include "core/devices/vme58/stop_effect.h"

namespace hw::vme58 {

class AllStop {
 public:
  AllStop(Wire& wire, const Selection& selection, Conversation& conversation, Mailbox& mailbox,
          Queues& queues, Motions& motions, const StopEffect& effect, const Catalog& catalog,
          Snapshot& snapshot)
      : wire_(wire),
        selection_(selection),
        conversation_(conversation),
        mailbox_(mailbox),
        queues_(queues),
        motions_(motions),
        effect_(effect),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Also sends the stop through the ring if the mailbox has no effect, or if its effect could not be seen:
  /// no axis is seen turning, yet one may creep.
  Task<Result<>> send(std::string_view word);
  /// Reads the queues as soon as no axis turns. A stop of all axes empties them; commands still waiting show
  /// that it was not obeyed, though an axis may rest for a moment between two motions.
  Task<Result<>> look_at_queues();
  enum class Behind : std::uint8_t { nothing, not_known, waits };
  /// Whether commands wait in the queues behind the stop. Queues that do not answer count as empty after the
  /// longest rest between two motions.
  [[nodiscard]] Behind behind() const;
  /// The stop must still be sent through the ring: it was mailed before the ring was known, or another stop
  /// hides its effect, so it is unknown whether the board acted on the mail.
  [[nodiscard]] bool owes_ring() const;
  /// ST of one axis was sent: an axis that slows down now may do so because of it.
  void another_was_sent();
  void without_effect();
  /// The connection was lost, or the board was reset.
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
  Snapshot& snapshot_;
  bool mailbox_ignores_mail_ = false;  ///< mail was acknowledged without effect
  bool by_mail_alone_ = false;
  Behind behind_ = Behind::nothing;
  Instant rests_since_{};  ///< since then, or since the stop, no axis was seen turning
};

}  // namespace hw::vme58
