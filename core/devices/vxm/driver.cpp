// What the driver is made of, and what can be asked of it.
#include "core/devices/vxm/driver.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vxm {

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<VxmDriver>(std::move(context));
}

VxmDriver::VxmDriver(DriverContext context)
    : console_(std::move(context)),
      talk_(
          console_.scheduler, [this] { return listening(); }, [this](const Message& m) { heard(m); }),
      nameplate_(console_, talk_),
      signals_(console_, talk_, nameplate_),
      parameters_(console_, talk_, nameplate_, [this] { return admission_.may_change(); }),
      slots_(console_, talk_, parameters_, [this] { return admission_.may_change(); }),
      scratch_(talk_, slots_),
      sight_(console_.scheduler),
      knowledge_(nameplate_, parameters_, slots_),
      presence_(console_.scheduler, talk_),
      ramp_(console_, nameplate_, sight_, hold_),
      under_way_(console_, presence_, slots_, sight_, hold_, ramp_),
      positions_(console_, talk_, nameplate_, signals_, sight_, hold_, ramp_, under_way_),
      headline_(console_, presence_, nameplate_, parameters_),
      kills_(console_, talk_, presence_, nameplate_, sight_, under_way_, headline_),
      hold_switch_(talk_, hold_, kills_),
      admission_(console_, presence_, nameplate_, parameters_, under_way_),
      restarts_(console_, talk_, presence_, knowledge_, scratch_, speeds_, hold_, under_way_, positions_),
      status_(console_, talk_, presence_, hold_, under_way_, restarts_),
      echo_(console_, talk_) {
  console_.draft.axis_count = static_cast<int>(console_.catalog.axes.size());
  console_.draft.identity.model = console_.catalog.name;
  console_.draft.slot_bytes_used.fill(-1);
}

void VxmDriver::attach(Station& station) {
  presence_.forget_mode();
  echo_.begin();
  talk_.attach(station);
  signals_.begin();
  station.procedure_ended = [this] { under_way_.news().notify(); };
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
  if (presence_.stays_local() && !text) {  // Q was sent earlier; whatever is wanted now needs on-line mode
    auto on_line = co_await presence_.go_on_line();
    if (!on_line) co_return on_line;
    presence_.wants_on_line();
  }
  auto clean = co_await status_.see_to_dirt();
  if (!clean) co_return clean;
  auto heard = co_await echo_.hear_without();
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
  if (std::holds_alternative<Reset>(body)) co_return co_await restarts_.reset();
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
  if (under_way_.busy()) co_return co_await poll(Round::usual);
  knowledge_.doubt();
  auto read = co_await knowledge_.catch_up();
  if (!read) co_return read;
  co_return co_await poll(Round::usual);
}

}  // namespace hw::vxm
