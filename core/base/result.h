#pragma once
// Errors are values with a sentence for a human: what happened, what was done or not done, what to do.
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace hw {

enum class FaultKind {
  refused,     ///< not sent: out of range, not possible in this state, or needs a confirmation
  asks,        ///< not sent: the user has to choose first, see intent::Closing
  no_answer,   ///< sent, and the deadline passed
  garbled,     ///< a reply came that makes no sense
  controller,  ///< the controller itself reported an error
  stopped,     ///< given up because a stop came first
  lost,        ///< the wire is gone
  port,        ///< a port or file could not be opened, read or written
  text,        ///< a program, script, file or address that cannot be understood
  internal,    ///< a defect of this program
};

struct Fault {
  FaultKind kind = FaultKind::internal;
  std::string what;    ///< what happened, with numbers and names
  std::string done;    ///< what was done or not done ("Nothing was sent.")
  std::string advice;  ///< what to do

  Fault() = default;
  Fault(FaultKind k, std::string w, std::string d = {}, std::string a = {})
      : kind(k), what(std::move(w)), done(std::move(d)), advice(std::move(a)) {}

  /// All three parts as one paragraph.
  [[nodiscard]] std::string sentence() const {
    std::string all = what;
    for (const std::string* part : {&done, &advice})
      if (!part->empty()) all += (all.empty() ? "" : " ") + *part;
    return all;
  }
};

template <class T = void>
using Result = tl::expected<T, Fault>;

inline tl::unexpected<Fault> fail(FaultKind kind, std::string what, std::string done = {},
                                  std::string advice = {}) {
  return tl::unexpected<Fault>(Fault(kind, std::move(what), std::move(done), std::move(advice)));
}
inline tl::unexpected<Fault> fail(Fault fault) { return tl::unexpected<Fault>(std::move(fault)); }

}  // namespace hw
