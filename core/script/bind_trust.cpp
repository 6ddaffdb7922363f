// Methods to read and set the trust in an axis' position.
#include <fmt/core.h>

#include "core/device/refusals.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

struct Reported {
  const char* word;
  std::string why;
};

Reported describe_trust(const AxisState& axis) {
  if (!axis.position_known) return {"untrusted", "its position is not known"};
  if (axis.trust.restored && !axis.trust.doubtful())
    return {"restored", axis.trust.kind == Trust::homed
                            ? "an earlier session homed it and left it at this count"
                            : "the position was set in an earlier session, which left it at this count"};
  switch (axis.trust.kind) {
    case Trust::counted: return {"counted", "the controller counts from an unknown zero"};
    case Trust::homed: return {"homed", "homing has set it"};
    case Trust::set: return {"set", "its position was set"};
    case Trust::untrusted: break;
  }
  return {"untrusted", std::string(words_of(axis.trust.cause))};
}

/// From a status round that begins after the call, like all readings.
Task<Answer> ask_trust(SessionPtr session, int axis) {
  co_await session->pump().refresh();
  const Reported reported = describe_trust(session->known().axes[axis]);
  co_return [reported](lua_State* L) {
    lua_pushstring(L, reported.word);
    lua_pushlstring(L, reported.why.data(), reported.why.size());
    return 2;
  };
}

int trust(Call& call) {
  const OneAxis one = one_axis(call, 1, "trust");
  if (one.index < 0) return call.refuse(one.refusal);
  if (!call.has(2)) return call.wait(ask_trust(one.session, one.index));
  if (call.text(2, "trust") != "set") throw Misuse("trust: a position can only be \"set\" by a script");
  return perform(call, one.session, intent::TrustPosition(AxisId{static_cast<std::uint8_t>(one.index)}));
}

constexpr Function trust_table[] = {{"trust", trust}};

}  // namespace

std::span<const Function> trust_methods() { return trust_table; }

}  // namespace hw::script
