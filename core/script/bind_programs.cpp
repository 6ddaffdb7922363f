// Methods of a controller for its stored programs.
#include <algorithm>

#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/rehearse_here.h"
#include "core/sequence/sequence_file.h"

namespace hw::script {
namespace {

int selected(const SessionPtr& session) { return std::max<int>(0, session->known().program.slot); }

// If programs run concurrently, the number is the thread's.
int programs_of(const Catalog& catalog) { return std::max(catalog.program.slots, catalog.program.threads); }

int slot_of(const Call& call, int argument) {
  const SessionPtr& session = session_of(call);
  if (programs_of(session->catalog()) == 0) return -1;
  if (!call.has(argument)) return selected(session);
  const std::int64_t n = call.whole(argument, "program");
  return n >= 0 && n < programs_of(session->catalog()) ? static_cast<int>(n) : -1;
}
std::string no_slot(const Catalog& catalog) {
  const int programs = programs_of(catalog);
  if (programs == 0) return fmt::format("{} has no programs.", catalog.short_name);
  if (programs == 1)
    return fmt::format("There is no such program. {} has one: number 0.", catalog.short_name);
  return fmt::format("There is no such program. {} has 0 to {}.", catalog.short_name, programs - 1);
}

/// Converts a sequence to the controller's language; any other text is unchanged.
Result<std::string> program_of(std::string text, const Session& session) {
  if (!session.type().language || !sequence::looks_like_sequence(text)) return text;
  const auto sequence = sequence::read_sequence(text, "The sequence");
  if (!sequence) return fail(sequence.error());
  return session.type().language().write(*sequence, session.catalog()).map([](SequenceText&& written) {
    return std::move(written.text);
  });
}

int load(Call& call) {
  const SessionPtr& session = session_of(call);
  const int slot = slot_of(call, 2);
  if (slot < 0) return call.refuse(no_slot(session->catalog()));
  auto text = program_of(call.text(1, "text"), *session);
  if (!text) return call.refuse(text.error());
  return perform(call, intent::LoadProgram(slot, std::move(*text)));
}
int run(Call& call) {
  const int slot = slot_of(call, 1);
  if (slot < 0) return call.refuse(no_slot(session_of(call)->catalog()));
  intent::RunProgram request(slot);
  if (call.has(2)) {
    if (call.text(2, "how") != "as it is") throw Misuse("run: argument 2 can only be \"as it is\"");
    request.as_it_is = true;
  }
  return perform(call, std::move(request));
}

Task<Answer> run_together(std::shared_ptr<SessionGroup> bus, sequence::Sequence sequence, int from) {
  const auto begun = co_await bus->run_together(std::move(sequence), from);
  co_return answer_of_bus(begun, *bus);
}

/// Runs a sequence of any length. Returns when the first piece is to begin; wait() waits for the end.
int run_in_pieces(Call& call) {
  auto sequence = sequence::read_sequence(call.text(1, "sequence"), "The sequence");
  if (!sequence) return call.refuse(sequence.error());
  const std::int64_t step = call.has(2) ? call.whole(2, "step") : 1;
  const int from = static_cast<int>(std::clamp<std::int64_t>(step - 1, -1, 1'000'000'000));
  if (const auto bus = bus_of(call)) return call.wait(run_together(bus, std::move(*sequence), from));
  const SessionPtr& session = session_of(call);
  if (!session->type().language) return call.refuse("This controller has no language for programs.");
  auto pieces = session->type().language().in_pieces(*sequence, session->catalog(), from);
  if (!pieces) return call.refuse(pieces.error());
  return perform(call, intent::RunInPieces(std::make_shared<const Pieces>(std::move(*pieces))));
}

Task<Answer> post_together(std::shared_ptr<SessionGroup> bus, IntentBody request) {
  const auto reported = co_await bus->post_together(std::move(request));
  co_return answer_of_bus(reported, *bus);
}

int override_speed(Call& call) {
  const std::int64_t percent = call.whole(1, "percent");
  intent::OverrideSpeed request(static_cast<int>(std::clamp<std::int64_t>(percent, 0, 1000)));
  if (const auto bus = bus_of(call)) return call.wait(post_together(bus, request));
  return perform(call, request);
}

// With a number: only that thread, on controllers with several.
template <class Verb>
int of_thread(Call& call) {
  if constexpr (!std::is_same_v<Verb, intent::HaltProgram>)
    if (const auto bus = bus_of(call); bus && !call.has(1)) return call.wait(post_together(bus, Verb()));
  const int threads = session_of(call)->catalog().program.threads;
  if (!call.has(1)) return perform(call, Verb());
  const std::int64_t thread = call.whole(1, "thread");
  if (thread < 0 || thread >= threads)
    return call.refuse(
        threads == 0 ? fmt::format("{} runs one program at a time.", session_of(call)->catalog().short_name)
                     : fmt::format("There is no thread {}. {} has 0 to {}.", thread,
                                   session_of(call)->catalog().short_name, threads - 1));
  return perform(call, Verb(static_cast<int>(thread)));
}

Task<Answer> upload(SessionPtr session, int slot) {
  auto listing = co_await session->listing(slot);
  if (!listing) co_return answer_refused(listing.error());
  co_return answer_text(std::move(*listing));
}
int program(Call& call) {
  const int slot = slot_of(call, 1);
  if (slot < 0) return call.refuse(no_slot(session_of(call)->catalog()));
  return call.wait(upload(session_of(call), slot));
}

/// Without a number: as c:load would place it.
int rehearse(Call& call) {
  const SessionPtr& session = session_of(call);
  const int slot = slot_of(call, 2);
  if (slot < 0) return call.refuse(no_slot(session->catalog()));
  auto text = program_of(call.text(1, "text"), *session);
  if (!text) return call.refuse(text.error());
  return call.wait(rehearse_here(session, std::move(*text), slot));
}

constexpr Function program_table[] = {
    {"load", load},
    {"rehearse", rehearse},
    {"run", run},
    {"override_speed", override_speed},
    {"run_in_pieces", run_in_pieces},
    {"pause", of_thread<intent::Pause>},
    {"resume", of_thread<intent::Resume>},
    {"halt", of_thread<intent::HaltProgram>},
    {"program", program},
};

}  // namespace

std::span<const Function> program_methods() { return program_table; }

}  // namespace hw::script
