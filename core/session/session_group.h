#pragma once
// What one address opens: one controller, or several that share a wire, each with a session of its own. The
// group's address is that of the wire with all its ids; each member's has its own id.
#include <memory>
#include <string_view>
#include <vector>

#include "core/session/session.h"

namespace hw {

class SessionGroup : public std::enable_shared_from_this<SessionGroup> {
 public:
  /// Io thread. `wake` as in Session::open().
  static Result<std::shared_ptr<SessionGroup>> open(Scheduler& scheduler, const Address& address,
                                                    WireOpener opener, std::function<void()> wake);

  // ---- any thread
  [[nodiscard]] const Address& address() const { return address_; }
  /// In the order of their ids; at least one.
  [[nodiscard]] const std::vector<std::shared_ptr<Session>>& members() const { return members_; }
  [[nodiscard]] bool is_bus() const { return members_.size() > 1; }
  /// The place of an id among the members; -1: none has it.
  [[nodiscard]] int find(std::string_view id) const;
  /// Stops all of them; where the maker has a message that all obey at once, it goes out first. The intents'
  /// ids, in the order of the members.
  std::vector<IntentId> stop(bool at_once = false, StoppedBy by = StoppedBy::button);

  // ---- io thread. On a bus, what went wrong with one of them begins with its id: "03: ...".
  /// The one that it went wrong with; null: with no single one.
  [[nodiscard]] std::shared_ptr<Session> origin_of(const Fault& fault) const;
  /// The same as stop(), for scripts, before anything else happens on this thread.
  std::vector<IntentId> post_stop(bool at_once);
  /// And resumes with the first thing that went wrong.
  Task<Result<>> perform_stop(bool at_once);
  /// A sequence whose axes are ids of theirs, from the place of one of its steps on. Resumes when all who
  /// take part have begun, or with the reason why one does not: then none does.
  Task<Result<>> run_together(sequence::Sequence sequence, int from_step);
  /// Those who are at it: a hold, its end, another speed.
  Task<Result<>> tell_together(IntentBody wish);
  /// Resumes when nothing moves or runs any more on any of them.
  Task<Result<>> wait_until_idle(Duration patience);
  /// Resumes when each answers, or with the reason why the first that does not.
  Task<Result<>> wait_until_connected();
  Task<> close();

 private:
  void stop_wire(bool at_once) const;
  [[nodiscard]] tl::unexpected<Fault> fault_of(std::size_t member, Fault fault) const;
  /// The first thing that went wrong with any of them, once all have come to their end.
  struct Asked {
    std::size_t member;
    IntentId id;
  };
  Task<Result<>> outcomes(std::vector<Asked> all);

  SessionGroup(Scheduler& scheduler, Address address) : scheduler_(scheduler), address_(std::move(address)) {}

  Scheduler& scheduler_;
  const Address address_;
  std::vector<std::shared_ptr<Session>> members_;
};

}  // namespace hw
