// Set-up: values of set and get, B and O; baud rate; storing; reset. And the list of what can be asked of the
// driver.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/driver.h"
#include "core/devices/vxm/looks.h"

namespace hw::vxm {
namespace {

constexpr Duration rate_change_pause = Millis(50);
constexpr int restart_attempts = 8;
constexpr Duration restart_pause = Millis(250);

int baud_rate(std::int64_t number) {
  for (const Baud& b : bauds)
    if (b.number == number) return b.rate;
  return 0;
}

// What the controller makes of a value (App. C p.38, F p.45, O p.68).
std::int64_t as_kept(std::string_view mnemonic, std::int64_t value) {
  if (mnemonic == "DM") return value | mode_always;
  if (mnemonic == "Bx" && value == 1) return backlash_of_one;
  if (mnemonic == "I" && value & inputs_capture) value &= ~std::int64_t{inputs_stop};
  if (mnemonic == "I" && value & inputs_select) value &= ~std::int64_t{inputs_branch_3};
  return value;
}

std::string range_words(const ParamInfo& p) {
  if (p.choices.empty()) return fmt::format("{} to {}{}", p.minimum, p.maximum, p.also_zero ? ", or 0" : "");
  std::string all;
  for (const ParamChoice& c : p.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
  return "one of " + all;
}

}  // namespace

Task<Result<>> VxmDriver::perform(const IntentBody& body) {
  using namespace intent;
  const auto* text = std::get_if<SendText>(&body);
  if (stay_local_ && !text) {  // Q was sent earlier; whatever is wanted now needs on-line mode
    auto on_line = co_await go_on_line();
    if (!on_line) co_return on_line;
    stay_local_ = false;
  }
  auto clean = co_await see_to_dirt();
  if (!clean) co_return clean;
  auto heard = co_await hear_without_echo();
  if (!heard) co_return heard;
  auto settled = co_await settle();
  if (!settled) co_return settled;
  if (text) co_return co_await send_text(text->text);
  if (const auto* i = std::get_if<MoveTo>(&body)) co_return co_await move(i->targets, i->speed, false);
  if (const auto* i = std::get_if<MoveBy>(&body)) co_return co_await move(i->distances, i->speed, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await set_position(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await set_param(*i);
  if (std::holds_alternative<ReadParams>(body)) co_return co_await read_params();
  if (std::holds_alternative<Store>(body)) co_return co_await store();
  if (std::holds_alternative<Reset>(body)) co_return co_await reset();
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_again();
  co_return co_await perform_program(body);
}

Task<Result<>> VxmDriver::perform_program(const IntentBody& body) {
  using namespace intent;
  const int slot = slot_of(body);
  if (slot >= program_count || slot < -1)
    co_return fail(FaultKind::refused, fmt::format("There is no program {}: a VXM has 0 to 4.", slot),
                   "Nothing was sent.");
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return co_await load(*i);
  if (std::holds_alternative<Pause>(body)) co_return co_await pause();
  if (std::holds_alternative<Resume>(body)) co_return co_await resume();
  if (std::holds_alternative<SingleStep>(body)) co_return co_await single_step();
  if (slot >= 0) {
    if (std::holds_alternative<RunProgram>(body)) co_return co_await run(slot);
    if (std::holds_alternative<UploadProgram>(body)) co_return co_await upload(slot);
    if (std::holds_alternative<ClearProgram>(body)) co_return co_await clear(slot);
    if (std::holds_alternative<SelectProgram>(body)) co_return co_await select(slot);
  } else if (std::holds_alternative<RunProgram>(body) && selected_ >= 0) {
    co_return co_await run(selected_);
  }
  co_return fail(FaultKind::refused, "A VXM cannot do that.", "Nothing was sent.");
}

int VxmDriver::slot_of(const IntentBody& body) {
  using namespace intent;
  if (const auto* i = std::get_if<LoadProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<RunProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<UploadProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<ClearProgram>(&body)) return i->slot;
  if (const auto* i = std::get_if<SelectProgram>(&body)) return i->slot;
  return -1;
}

// ---- values

std::optional<std::int64_t> VxmDriver::param(std::string_view mnemonic) const {
  const int index = catalog_.find_param(mnemonic);
  if (index < 0 || !draft_.params[ix(index)].known) return std::nullopt;
  return draft_.params[ix(index)].value;
}

// A set or get for motor 3 or 4 without a Slave would make the controller restart (EB).
bool VxmDriver::reachable(const ParamInfo& info) const {
  return slave_present_ || (info.axis < motors_per_controller && info.mnemonic != "PMA");
}

Task<Result<>> VxmDriver::read_param(int index, Priority priority) {
  const ParamInfo& info = catalog_.params[ix(index)];
  if (!info.readable || !reachable(info)) co_return Result<>();
  auto value = co_await talk_.number(get_param(info.mnemonic), priority);
  if (!value) co_return fail(value.error());
  draft_.params[ix(index)].value = *value;
  draft_.params[ix(index)].known = true;
  co_return Result<>();
}

Task<Result<>> VxmDriver::read_params() {
  if (auto may = may_touch_programs(); !may) co_return may;
  for (int i = 0; i < static_cast<int>(catalog_.params.size()); ++i) {
    auto read = co_await read_param(i, Priority::transfer);
    if (!read) co_return read;
  }
  co_return Result<>();
}

Task<Result<>> VxmDriver::read_again() {
  if (busy()) co_return co_await poll(Round::usual);
  identity_read_ = essentials_read_ = sizes_read_ = false;
  draft_.slot_bytes_used.fill(-1);
  confirmed_scratch_ = -1;
  for (auto& listing : listings_) listing.reset();
  auto read = co_await catch_up();
  if (!read) co_return read;
  co_return co_await poll(Round::usual);
}

Task<Result<>> VxmDriver::set_param(const intent::SetParam& wish) {
  const int index = catalog_.find_param(wish.mnemonic);
  if (index < 0)
    co_return fail(FaultKind::refused, fmt::format("A VXM has no parameter {}.", wish.mnemonic),
                   "Nothing was sent.");
  const ParamInfo& info = catalog_.params[ix(index)];
  if (!info.accepts(wish.value))
    co_return fail(FaultKind::refused,
                   fmt::format("{} is not possible for {} ({}): it takes {}.", wish.value, info.mnemonic,
                               info.label, range_words(info)),
                   "Nothing was sent.");
  if (!reachable(info))
    co_return fail(
        FaultKind::refused,
        fmt::format("{} needs a second controller, and none answers on the VXM bus.", info.mnemonic),
        "Nothing was sent.", "Check the Slave's power and cable, then reconnect.");
  if (auto may = may_touch_programs(); !may) co_return may;
  if (!info.warning.empty() && !wish.confirmed)
    co_return fail(FaultKind::refused, info.warning, "Nothing was sent.", "Confirm it to go on.");
  if (info.mnemonic == "B") co_return co_await set_baud(wish.value);
  auto sent = co_await talk_.say(vxm::set_param(info.mnemonic, wish.value), Priority::intent);
  if (!sent) co_return sent;
  ParamState& state = draft_.params[ix(index)];
  state.stored = !info.stored;
  draft_.unsaved_setup = draft_.unsaved_setup || info.stored;
  if (info.mnemonic == "DM") identity_read_ = false;  // it may have become the Master
  if (info.mnemonic.starts_with("MA") && info.axis >= 0) {
    auto read =
        co_await read_param(catalog_.find_param(fmt::format("M{}M", info.axis + 1)), Priority::intent);
    co_return read;
  }
  auto read = co_await read_param(index, Priority::intent);
  if (!read) co_return read;
  const auto expected = as_kept(info.mnemonic, wish.value);
  if (!info.readable || state.value == expected) co_return Result<>();
  co_return fail(
      FaultKind::controller,
      fmt::format("{} was set to {}, but the controller says {}.", info.mnemonic, wish.value, state.value),
      "It was sent once.",
      "Read the set-up again; the number that the controller says is the one that holds.");
}

// The controller changes its rate after the command's end; then both sides must agree, or go back. A stop in
// between would go out at a rate that nobody listens at.
Task<Result<>> VxmDriver::set_baud(std::int64_t number) {
  const int before = talk_.station()->rate(), wanted = baud_rate(number);
  const Station::Uncut uncut(*talk_.station());
  auto sent = co_await talk_.say(vxm::set_param("B", number), Priority::intent);
  if (!sent) co_return sent;
  auto waited = co_await talk_.station()->pause(talk_.station()->wire_time(10) + rate_change_pause);
  if (!waited || !talk_.station())
    co_return fail(FaultKind::lost, "The connection was lost while the baud rate changed.");
  auto changed = talk_.station()->set_rate(wanted);
  if (changed) {
    auto state = co_await talk_.state(Priority::intent);
    if (state) {
      const int index = catalog_.find_param("B");
      draft_.params[ix(index)].stored = false;
      draft_.unsaved_setup = true;
      co_return Result<>();
    }
  }
  if (!talk_.station()) co_return fail(FaultKind::lost, "The connection was lost while the baud rate changed.");
  if (before > 0) (void)talk_.station()->set_rate(before);
  auto state = co_await talk_.state(Priority::intent);
  co_return fail(
      FaultKind::controller,
      fmt::format("The controller was asked to change to {} baud but does not answer there.", wanted),
      state ? fmt::format("It still answers at {} baud, and that is used again.", before)
            : "It does not answer at the old rate either.",
      state ? "" : "Open it again at each rate, or switch it off and on: the stored rate then holds.");
}

void VxmDriver::all_stored() {
  for (ParamState& p : draft_.params) p.stored = true;
  draft_.unsaved_setup = draft_.unsaved_programs = false;
}

Task<Result<>> VxmDriver::store() {
  if (auto may = may_touch_programs(); !may) co_return may;
  const AnswerShape prompt{ReplyShape::bytes(1), before_prompt, store_patience, look::prompt};
  auto reply = co_await talk_.ask("rsm", prompt, Priority::intent);
  if (!reply && reply.error().kind == FaultKind::no_answer)
    co_return fail(
        FaultKind::no_answer,
        fmt::format("The controller did not confirm in {:.0f} s that it has stored.",
                    seconds(store_patience)),
        "rsm was sent once and is not repeated: the memory bears a limited number of writes.",
        "Do not switch the controller off now. Ask for its state, and compare before you store again.");
  if (!reply) co_return fail(reply.error());
  all_stored();
  if (draft_.store_count >= 0) {
    tell(Notice::Kind::info, fmt::format("Set-up and programs are stored. {} of about {} writes are used.",
                                         draft_.store_count, store_life));
  } else {
    tell(Notice::Kind::info, fmt::format("Set-up and programs are stored. The memory bears about {} writes; "
                                         "how many were used is not known.",
                                         store_life));
  }
  co_return Result<>();
}

Task<Result<>> VxmDriver::reset() {
  auto said = co_await talk_.say("res", Priority::intent);
  if (!said) co_return said;
  if (job_.active()) job_ = Job();
  run_ended(EndedBy::abort);
  forget_ram();
  reset_said_ = true;  // if this is cut short, the next V finds it
  Result<> on_line = fail(FaultKind::no_answer, "The controller does not answer after its reset.");
  for (int attempt = 0; attempt < restart_attempts && !on_line && talk_.station(); ++attempt) {
    auto waited = co_await talk_.station()->pause(restart_pause);
    if (!waited) co_return waited;
    on_line = co_await go_on_line();
  }
  if (!on_line) co_return on_line;
  reset_said_ = false;
  stands_after_restart(Doubt::reset);
  tell(Notice::Kind::info,
       "The controller was reset: positions are zero where the motors stand, and what was not stored is "
       "gone. Find home before the next absolute move.");
  co_return co_await read_positions(Priority::intent, true);
}

}  // namespace hw::vxm
