#pragma once
// The sessions of one address: one controller, or several on a shared wire, a session each. The group's
// address names the wire with all ids; each member's address has its own id.
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
  /// Index of the member with this id; -1: none.
  [[nodiscard]] int find(std::string_view id) const;
  /// Stops all members; a broadcast stop, where the maker has one, is sent first. Returns the intents' ids in
  /// the order of the members.
  std::vector<IntentId> stop(bool at_once = false, StoppedBy by = StoppedBy::button);

  // ---- io thread. On a bus, the fault of one member begins with its id: "03: ...".
  /// The member that the fault belongs to; null: no single one.
  [[nodiscard]] std::shared_ptr<Session> origin_of(const Fault& fault) const;
  /// As stop(), for scripts: posted before anything else happens on this thread.
  std::vector<IntentId> post_stop(bool at_once);
  /// As post_stop(), and resumes with the first fault.
  Task<Result<>> perform_stop(bool at_once);
  /// Runs a sequence whose axes are members' ids, from the step at `from_step`. Resumes when all that take
  /// part have begun; if one refuses, none begins, and the fault gives the reason.
  Task<Result<>> run_together(sequence::Sequence sequence, int from_step);
  /// Sends a hold, its end or another speed to the members that run the sequence.
  Task<Result<>> post_together(IntentBody request);
  /// Resumes when nothing moves or runs on any member.
  Task<Result<>> wait_until_idle(Duration patience);
  /// Resumes when every member answers, or with the reason for the first that does not.
  Task<Result<>> wait_until_connected();
  Task<> close();

 private:
  void stop_wire(bool at_once) const;
  [[nodiscard]] tl::unexpected<Fault> fault_of(std::size_t member, Fault fault) const;
  /// An intent of a member, see outcomes(): the first fault of any, once all have ended.
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
