#pragma once
// The open controllers on one wire, each with a pump of its own. Finds the controller that a text names, and
// announces a broadcast to all. Io thread only.
#include <algorithm>
#include <cstdint>
#include <vector>

namespace hw {

class Pump;

class Line {
 public:
  void join(Pump& pump, int address) { members_.push_back({&pump, address}); }
  void leave(const Pump& pump) {
    std::erase_if(members_, [&](const Member& m) { return m.pump == &pump; });
  }
  /// Null: no controller with that address is open.
  [[nodiscard]] Pump* at(int address) const {
    const auto found =
        std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.address == address; });
    return found == members_.end() ? nullptr : found->pump;
  }
  template <class Each>
  void for_each_but(const Pump& pump, Each each) const {
    for (const Member& m : std::vector<Member>(members_))
      if (m.pump != &pump) each(*m.pump);
  }
  /// One of the controllers is being stopped: no broadcast that was queued before is sent.
  void begin_epoch() { ++epoch_; }
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }

 private:
  struct Member {
    Pump* pump;
    int address;
  };
  std::vector<Member> members_;
  std::uint64_t epoch_ = 0;
};

}  // namespace hw
