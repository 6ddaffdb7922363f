#pragma once
// The link doctor: turns measurements of a link, and facts about its port, into sentences that say what is
// wrong or slow and what to do about it. Pure.
#include <optional>
#include <string>
#include <vector>

#include "core/link/talk_measure.h"

namespace hw {

struct LinkFacts {
  bool answers = true;  ///< the controller answers now
  bool is_line = true;  ///< a line of bytes; false: a board in a memory window
  TalkMeasure talk;
  int rate = 0;                ///< baud; 0: the wire has none, or it is not known
  std::vector<int> rates;      ///< rates that the controller can be set to; empty: no other
  std::string rate_is_set_by;  ///< mnemonic of its parameter; empty: the console cannot change it
  // ---- about a port of this computer
  bool port_looked_at = false;            ///< the next three were read
  std::string holder;                     ///< another program that has it open: "minicom (process 4182)"
  std::optional<Duration> adapter_waits;  ///< latency timer of a USB adapter
  std::string adapter_timer;              ///< the file that sets it
  bool adapter_timer_can_be_set = false;  ///< this user may write that file
};

/// How the time of one question is spent, now or at best.
struct LinkBudget {
  Duration question{}, answer{};  ///< the bytes on the wire
  Duration adapter{};             ///< delay of a USB adapter
  Duration rest{};                ///< the controller, the computer and the path between them
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
  int rate = 0;  ///< raise_rate: the new rate
};

LinkBudget link_budget(const LinkFacts& facts);
/// With all fixes that the findings offer.
LinkBudget best_link_budget(const LinkFacts& facts);
/// "One query takes 31.0 ms: 32 per second. 3.8 ms is possible: 263 per second." Empty: nothing was measured.
std::string link_summary(const LinkFacts& facts);
/// Faults first, then possible improvements, then what is good.
std::vector<LinkFinding> examine_link(const LinkFacts& facts);

/// "31.0 ms"; from 100 ms on without decimals.
std::string in_millis(Duration time);

}  // namespace hw
