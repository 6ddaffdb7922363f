#pragma once
// One call from Lua into C++: reads arguments, returns results or waits. C++ objects are destroyed before Lua
// jumps (errors and yields are longjmps), so function bodies may use them freely; they throw Misuse instead
// of calling luaL_error.
#include <cstdint>
#include <lua.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/script/runner.h"

namespace hw::script {

/// Why a call returns nil: the reason, and a table {kind=, axis=, device=, what_to_do=} without unknown
/// fields.
struct Refusal {
  std::string reason;  ///< a sentence
  FaultKind kind = FaultKind::refused;
  std::string axis = {}, device = {}, what_to_do = {};
  bool too_late = false;  ///< a wait timed out; its kind is then "timeout"
};
/// The same refusal, of a wait that timed out.
Refusal too_late(Refusal refusal);
Refusal refusal_of(const Fault& fault);
/// Pushes nil, reason, table. A method called on one controller adds the device itself.
int push_refusal(lua_State* L, Refusal refusal);
/// A call whose last attempt was refused has `results` on the stack. If this attempt succeeded, the advice
/// forgets the refusal.
void forget_mended_refusal(lua_State* L, int results);

/// A wrong call by the script: an error at its line.
class Misuse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Call {
 public:
  /// `self`: 1 for methods (a:b()), so that arguments are numbered as the script writes them.
  Call(lua_State* state, const char* function, int self) : L(state), function_(function), self_(self) {}

  lua_State* const L;
  [[nodiscard]] Runner& runner() const { return Runner::of(L); }
  [[nodiscard]] const char* function() const { return function_; }  ///< its name, for messages
  [[nodiscard]] const char* type_of(int argument) const;            ///< "nil" for an absent argument too
  [[nodiscard]] std::string given(int argument) const;              ///< a number as it is, else its type
  [[nodiscard]] int place(int argument) const { return argument + self_; }  ///< index on the stack
  [[nodiscard]] bool has(int argument) const { return !lua_isnoneornil(L, place(argument)); }
  [[nodiscard]] bool is_text(int argument) const { return lua_type(L, place(argument)) == LUA_TSTRING; }

  [[nodiscard]] std::string text(int argument, const char* what) const;
  [[nodiscard]] double number(int argument, const char* what) const;
  [[nodiscard]] std::int64_t whole(int argument, const char* what) const;
  [[nodiscard]] bool on(int argument, const char* what) const;  ///< absent: true
  /// Seconds, from 0 to 1e6.
  [[nodiscard]] Duration patience(int argument, double fallback_s) const;

  // Results.
  int nothing() { return 0; }
  int yes();
  int refuse(std::string_view reason);  ///< see Refusal
  int refuse(const Fault& fault) { return push_refusal(L, refusal_of(fault)); }
  /// Suspends the script until `work` is over. Must be the last action of a body.
  int wait(Task<Answer> work);

  /// The same for `act`, which runs between two turns of the run.
  int wait_for_act(std::function<Answer()> act);

  static constexpr int waits = -1, misused = -2;

 private:
  [[noreturn]] void wrong(int argument, const char* what, const char* wanted) const;
  const char* function_;
  int self_;
};

/// One row of a table of functions.
struct Function {
  const char* name;
  int (*body)(Call&);
  bool texts = false;  ///< arguments are converted to text first, with the script's __tostring
};
/// Adds the functions to the table on top of the stack; `self` as in Call.
void add_functions(lua_State* L, std::span<const Function> functions, int self);
/// Pushes a table of them.
void push_functions(lua_State* L, const Function* first, const Function* last, int self);

// Answers for calls that waited.
Answer answer_yes();
Answer answer_refused(std::string reason);
Answer answer_refused(Refusal refusal);
Answer answer_refused(const Fault& fault);
Answer answer_text(std::string text);
Answer answer_error(std::string sentence);  ///< an error at the script's line
/// true, or nil and the reason.
Answer answer_of(const Result<>& result);

}  // namespace hw::script
