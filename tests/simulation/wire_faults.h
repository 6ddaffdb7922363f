#pragma once
// What is wrong with a wire at present, both ways, and since when: the faulty stream and window do it, the
// judge asks about it. What the wire could not carry is nobody's fault.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/time/clock.h"

namespace hw::simulation {

/// One direction.
class WayFaults {
 public:
  /// So many bytes from now pass; then `count` are treated.
  struct Bytes {
    std::int64_t skip = 0, count = 0;
    bool hits() {
      if (count == 0) return false;
      if (skip > 0) return --skip, false;
      return --count, true;
    }
  };
  Bytes garble, drop, twice;
  /// A unit that now and then says a byte not at all, or twice.
  struct Habit {
    char byte = 0;
    std::int64_t every = 0;  ///< so many of them; 0: it has no such habit
    bool doubles = false;
    std::int64_t seen = 0;
    bool hits(char c) { return every > 0 && c == byte && ++seen % every == 0; }
  };
  Habit habit;
  Instant cut_until{}, slow_until{}, merge_until{}, gaps_until{};
  Duration gap{};    ///< between two bytes while there are gaps
  Duration delay{};  ///< of each byte while it is slow

  [[nodiscard]] bool cut(Instant now) const { return now < cut_until; }
  [[nodiscard]] Duration delay_at(Instant now) const { return now < slow_until ? delay : Duration{}; }

  /// x comes as no R: to a VXM that is a whole command, which runs a program that nobody has asked for.
  static char wrong_for(char c) {
    const char wrong = static_cast<char>(c ^ 0x2A);
    return wrong == 'R' ? '_' : wrong;
  }
  /// `bytes` as they go on; none while the way is cut.
  std::string treat(std::string_view bytes, Instant now) {
    std::string out;
    for (const char c : bytes) {
      const bool lost = drop.hits(), wrong = garble.hits(), doubled = twice.hits();
      if (lost || wrong || doubled || cut(now)) hurt_ = std::max(hurt_, now), spoilt_ = now;
      const bool mannered = habit.hits(c);
      if (lost || cut(now) || (mannered && !habit.doubles)) continue;
      const char sent = wrong ? wrong_for(c) : c;
      out += sent;
      if (doubled || mannered) out += sent;
    }
    if (const Duration late = delay_at(now); late > Duration{}) {
      held_until(now + late);
      late_by_ = now < late_until_ ? std::max(late_by_, late) : late;
      late_until_ = now + 3 * late_by_;
    }
    return out;
  }
  /// A byte has been held back until then.
  void held_until(Instant when) { hurt_ = std::max(hurt_, when); }
  /// Somebody else talks: what is said may be cut, and an answer more may come.
  void talked_into(Instant now) { hurt_ = std::max(hurt_, now), spoilt_ = now; }
  /// The latest instant at which something was lost, changed or late, or will be for all that is known now.
  [[nodiscard]] Instant hurt() const { return std::max({hurt_, cut_until, slow_until}); }
  /// What comes now may be as late as that: nothing overtakes what was said before it.
  [[nodiscard]] Duration late_by(Instant now) const { return now < late_until_ ? late_by_ : Duration{}; }
  /// A unit that does not say all that it should may count as lost.
  [[nodiscard]] bool swallows() const { return habit.every > 0 && !habit.doubles; }
  /// When the latest byte was lost, changed or doubled: a number may have come that is another and looks
  /// right.
  [[nodiscard]] Instant spoilt() const { return spoilt_; }
  /// Nothing that is there now will harm anything later.
  [[nodiscard]] bool spent(Instant now) const {
    return garble.count + drop.count + twice.count == 0 && now >= cut_until && now >= slow_until;
  }

 private:
  Instant hurt_{}, spoilt_{}, late_until_{};
  Duration late_by_{};
};

/// A firmware that has yet to learn a command: it sees as many letters that mean nothing, and where it tells
/// which command it did not know, it tells that one.
struct UnknownCommand {
  std::string name;
  [[nodiscard]] std::string to_controller(std::string_view bytes) const {
    return put(bytes, name, letters());
  }
  [[nodiscard]] std::string to_console(std::string_view bytes) const { return put(bytes, letters(), name); }

 private:
  [[nodiscard]] std::string letters() const { return std::string(name.size(), '_'); }
  static std::string put(std::string_view bytes, const std::string& one, const std::string& other) {
    std::string out(bytes);
    const auto at = one.empty() ? out.npos : out.find(one);
    return at == out.npos ? out : out.replace(at, one.size(), other);
  }
};

struct WireFaults {
  WayFaults out;  ///< to the controller
  WayFaults in;   ///< to the console
  Instant unplugged_until{};
  Instant babbles_until{};             ///< a device on the line talks without end
  std::function<void()> begin_babble;  ///< of the stream that is open
  UnknownCommand unknown;
  // Of a memory window.
  Instant silent_until{};  ///< nothing answers: reads give ones, writes are lost
  Instant slow_until{};
  Duration slow_by{};    ///< each visit to the window takes so much longer
  int cycle_faults = 0;  ///< so many visits fail with a bus error

  /// Since when what the console writes has come to the controller as it was written and in time, if it still
  /// does; else the future.
  [[nodiscard]] Instant carries_since(Instant now) const {
    return std::max(
        {out.hurt(), unplugged_until, silent_until, slow_until, cycle_faults > 0 ? now : Instant{}});
  }
};

}  // namespace hw::simulation
