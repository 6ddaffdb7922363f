// What the driver is made of, and what can be asked of it.
#include "core/devices/vxm/driver.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vxm {
namespace {

constexpr int restart_attempts = 8;
constexpr Duration restart_pause = Millis(250);

}  // namespace

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<VxmDriver>(std::move(context));
}

VxmDriver::VxmDriver(DriverContext context)
    : console_(std::move(context)),
      scheduler_(console_.scheduler),
      draft_(console_.draft),
      news_(scheduler_),
      talk_(
          scheduler_, [this] { return listening(); }, [this](const Message& m) { heard(m); }),
      nameplate_(console_, talk_),
      signals_(console_, talk_, nameplate_),
      parameters_(console_, talk_, nameplate_, [this] { return may_change(); }),
      slots_(console_, talk_, parameters_, [this] { return may_change(); }),
      scratch_(talk_, slots_),
      sight_(scheduler_) {
  draft_.axis_count = static_cast<int>(console_.catalog.axes.size());
  draft_.identity.model = console_.catalog.name;
  draft_.slot_bytes_used.fill(-1);
}

void VxmDriver::attach(Station& station) {
  mode_ = Mode::unknown;
  echo_told_ = false;
  talk_.attach(station);
  signals_.begin();
  station.procedure_ended = [this] { news_.notify(); };
}

Task<Result<>> VxmDriver::connect() {
  talk_.be_patient(true);
  auto made = co_await find_out_all();
  talk_.be_patient(false);
  co_return made;
}

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
  if (const auto* i = std::get_if<SetParam>(&body)) {
    if (i->mnemonic == "DM") nameplate_.forget();  // it may become the Master
    co_return co_await parameters_.set(*i);
  }
  if (std::holds_alternative<ReadParams>(body)) co_return co_await parameters_.read_all();
  if (std::holds_alternative<Store>(body)) co_return co_await parameters_.store();
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
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return co_await slots_.load(*i);
  if (std::holds_alternative<Pause>(body)) co_return co_await pause();
  if (std::holds_alternative<Resume>(body)) co_return co_await resume();
  if (std::holds_alternative<SingleStep>(body)) co_return co_await single_step();
  if (slot >= 0) {
    if (std::holds_alternative<RunProgram>(body)) co_return co_await run(slot);
    if (std::holds_alternative<UploadProgram>(body)) co_return co_await slots_.upload(slot);
    if (std::holds_alternative<ClearProgram>(body)) co_return co_await slots_.clear(slot);
    if (std::holds_alternative<SelectProgram>(body)) co_return co_await slots_.select(slot);
  } else if (std::holds_alternative<RunProgram>(body) && slots_.selected() >= 0) {
    co_return co_await run(slots_.selected());
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

Task<Result<>> VxmDriver::read_again() {
  if (busy()) co_return co_await poll(Round::usual);
  nameplate_.forget();
  parameters_.doubt_essentials();
  slots_.doubt_all();
  auto read = co_await catch_up();
  if (!read) co_return read;
  co_return co_await poll(Round::usual);
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
  console_.tell(
      Notice::Kind::info,
      "The controller was reset: positions are zero where the motors stand, and what was not stored is "
      "gone. Find home before the next absolute move.");
  co_return co_await read_positions(Priority::intent, true);
}

}  // namespace hw::vxm
