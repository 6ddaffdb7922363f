#pragma once
// The link doctor: from what was measured on a link, and what this computer tells of its port, to sentences
// that say what is wrong or slow, and what to do about it. Pure.
#include <optional>
#include <string>
#include <vector>

#include "core/link/talk_measure.h"

namespace hw {

struct LinkFacts {
  bool answers = true;  ///< the controller answers now
  bool is_line = true;  ///< spoken to in bytes; false: a board in a memory window
  TalkMeasure talk;
  int rate = 0;                ///< baud; 0: the wire has none, or nobody knows
  std::vector<int> rates;      ///< that the controller can be set to; empty: to no other
  std::string rate_is_set_by;  ///< mnemonic of its parameter; empty: the console cannot change it
  // ---- of a port of this computer
  bool port_looked_at = false;            ///< the next three are known
  std::string holder;                     ///< another program that has it open: "minicom (process 4182)"
  std::optional<Duration> adapter_waits;  ///< latency timer of a USB adapter
  std::string adapter_timer;              ///< the file that sets it
  bool adapter_timer_can_be_set = false;  ///< by this user
};

/// Where the time of one question goes, as it is or as it could be.
struct LinkBudget {
  Duration question{}, answer{};  ///< the bytes on the wire
  Duration adapter{};             ///< a USB adapter holds bytes back
  Duration rest{};                ///< the controller, the computer and what is between them
  [[nodiscard]] Duration whole() const { return question + answer + adapter + rest; }
};

struct LinkFinding {
  enum class Kind : std::uint8_t { adapter, rate, bytes, holder, silence, losses, scatter };
  enum class State : std::uint8_t { good, could_be_better, wrong };
  enum class Fix : std::uint8_t { none, set_adapter_timer, raise_rate, change_address };
  Kind kind;
  State state;
  std::string what, why;  ///< `why`: the reason, what is saved, and what to do where there is no button
  Fix fix = Fix::none;
  int rate = 0;  ///< raise_rate: to this one
};

LinkBudget link_budget(const LinkFacts& facts);
/// With every fix that the findings offer.
LinkBudget best_link_budget(const LinkFacts& facts);
/// "One question takes 31.0 ms: 32 a second. 3.8 ms are possible: 263 a second." Empty: nothing was measured.
std::string link_summary(const LinkFacts& facts);
/// What is wrong comes first, then what could be better, then what is good.
std::vector<LinkFinding> examine_link(const LinkFacts& facts);

/// "31.0 ms"; from 100 ms on without decimals.
std::string in_millis(Duration time);

}  // namespace hw
