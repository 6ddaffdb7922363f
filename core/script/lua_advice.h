#pragma once
// Completes Lua's own messages about nil: names the function that was probably meant, and says why a call
// returned nil.
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace hw::script {

class LuaAdvice {
 public:
  /// Learns the names of everything bound so far.
  void learn(lua_State* L);
  /// Remembers the newest refusal. `where`: "scan.lua:4: ".
  void refused(std::string where, std::string reason);
  [[nodiscard]] bool knows_refusal() const { return !refused_.empty(); }
  /// A call from this place has succeeded: an earlier refusal there is forgotten.
  void went_well(std::string_view where);
  /// An addition to an error's message; empty: no advice is known.
  [[nodiscard]] std::string on(std::string_view message) const;

 private:
  [[nodiscard]] std::string on_call(std::string_view message) const;
  [[nodiscard]] std::string on_value(std::string_view message) const;

  std::vector<std::string> methods_, functions_;  ///< of controllers, benches and tasks; of `hw` and `ui`
  std::string refused_at_, refused_;
};

}  // namespace hw::script
