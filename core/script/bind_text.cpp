// Methods of a controller for raw text: send, ask, and unsolicited messages.
#include <fmt/core.h>

#include "core/script/bind.h"

namespace hw::script {
namespace {

bool is_lost(const SessionPtr& session) {
  const LinkState state = session->known().link.state;
  return state == LinkState::lost || state == LinkState::closed;
}

// Any connected member can send to all.
const SessionPtr& connected_member(const SessionGroup& bus) {
  for (const SessionPtr& member : bus.members()) {
    const LinkState state = member->known().link.state;
    if (state == LinkState::good || state == LinkState::late) return member;
  }
  return bus.members().front();
}

// On a bus: sends to all devices at once, where the maker has a broadcast.
int send(Call& call) {
  const auto bus = bus_of(call);
  const SessionPtr& session = bus ? connected_member(*bus) : session_of(call);
  if (bus && !session->catalog().can.broadcast)
    return call.refuse(
        fmt::format("Send the text to each device: {} has no command for all devices on a wire.",
                    session->catalog().short_name));
  if (is_lost(session))
    return call.refuse(fmt::format("There is no connection. {}", session->known().link.sentence.view()));
  session->send_text(call.text(1, "text"), bus != nullptr);
  return call.yes();
}

Task<Answer> query_text(SessionPtr session, std::string text, Duration patience) {
  auto reply = co_await session->pump().query(std::move(text), patience);
  if (!reply) co_return answer_refused(reply.error());
  co_return answer_text(std::move(*reply));
}
int query(Call& call) {
  return call.wait(query_text(session_of(call), call.text(1, "text"), call.patience(2, 1)));
}

Task<Answer> read_text(Runner& runner, SessionPtr session, Duration patience) {
  const Instant deadline = runner.scheduler().now() + patience;
  std::string text;
  for (bool in_time = true; in_time && !runner.over();) {
    if (session->pump().take_unsolicited(text)) co_return answer_text(std::move(text));
    if (session->known().link.state == LinkState::closed) break;
    in_time = co_await session->pump().published().wait_until(deadline);
  }
  if (session->pump().take_unsolicited(text)) co_return answer_text(std::move(text));
  co_return answer_refused("Nothing came.");
}
int read(Call& call) { return call.wait(read_text(call.runner(), session_of(call), call.patience(1, 1))); }

constexpr Function text_table[] = {
    {"send", send},
    {"query", query},
    {"read", read},
};

}  // namespace

std::span<const Function> text_methods() { return text_table; }

}  // namespace hw::script
