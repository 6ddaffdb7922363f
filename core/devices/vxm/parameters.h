#pragma once
// The set-up: values of set and get, B and O; the line rate; storing.
#include <functional>
#include <optional>
#include <string_view>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/identification.h"

namespace hw::vxm {

class Parameters {
 public:
  /// `may_change`: the controller takes such commands now.
  Parameters(const Console& console, Conversation& conversation, const Identification& identification,
             std::function<Result<>()> may_change)
      : console_(console),
        conversation_(conversation),
        identification_(identification),
        may_change_(std::move(may_change)) {}

  /// None: not known.
  [[nodiscard]] std::optional<std::int64_t> value(std::string_view mnemonic) const;
  /// The values that the driver needs before any motion.
  [[nodiscard]] bool knows_essentials() const { return essentials_read_; }
  Task<Result<>> read_essentials();
  /// Reads a few of the unknown values between two requests.
  Task<Result<>> read_some();
  Task<Result<>> read_all();

  Task<Result<>> set(const intent::SetParam& request);
  Task<Result<>> store();

  /// The user's text has set the value.
  void was_set(std::string_view mnemonic);
  /// The controller was just sent this rate number: the wire switches to that rate, or back.
  Task<Result<>> follow_rate(std::int64_t number);
  /// The controller was found at this rate; 0: the wire has no rate. The controller may have been switched
  /// off before its rate was stored.
  void found_at(int rate);
  void was_stored();
  void doubt_essentials() { essentials_read_ = false; }
  /// Values not stored are gone.
  void forget();

 private:
  [[nodiscard]] Result<> may_set(const ParamInfo& info) const;
  Task<Result<>> set_baud(std::int64_t number);
  Task<Result<>> read_one(int index, Priority priority);
  [[nodiscard]] bool reachable(const ParamInfo& info) const;

  const Console& console_;
  Conversation& conversation_;
  const Identification& identification_;
  std::function<Result<>()> may_change_;
  bool essentials_read_ = false;
  int next_ = 0;
  int failed_reads_ = 0;  ///< failed attempts to read that value
};

}  // namespace hw::vxm
