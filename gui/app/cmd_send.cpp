#include <algorithm>
#include <csignal>
#include <span>

#include <fmt/core.h>

#include "core/session/address.h"
#include "gui/app/cli.h"
#include "gui/app/kept_limits.h"
#include "gui/app/output.h"
#include "gui/app/wiring.h"

namespace hw::app {
namespace {

constexpr Duration for_an_answer = Millis(1000);  // in addition to the time on the wire
constexpr Duration for_a_prompt = Millis(150);    // for a text that may cause a prompt
constexpr double longest_run_s = 60;

// Prints a reply in a line. Raw status bytes, which no terminal can show, are written as \xFF.
void print_reply(std::string_view reply) {
  std::string shown;
  for (const char c : reply) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= ' ' && byte < 0x7F) || c == '\n';
    shown += c == '\r' ? "\n" : plain ? std::string(1, c) : fmt::format("\\x{:02X}", byte);
  }
  print_result("{}\n", shown);
}

// Prints remarks on text and reply: an unknown command, a limit that the text leads past, an error report in
// words.
void print_warnings(Session& session, const KeptLimits& limits) {
  session.notices().drain([&limits](Notice& notice) {
    if (notice.kind != Notice::Kind::info && notice.kind != Notice::Kind::program)
      write_aside(limits.words_of(notice));
  });
}

/// A stop by the user with Ctrl-C, or because the replies are no longer read.
struct Stopped {
  static constexpr IntentId id = 1;  ///< no other intent is posted here
  bool asked = false;
  bool unseen = false;  ///< true: a text was sent, and no status round shows its effect yet
};

bool busy(const Snapshot& s) {
  return s.any_axis_moving() || s.working || s.program.run == RunState::running ||
         s.program.run == RunState::waiting;
}

/// Prints the replies. A refusal by the controller fails the job.
class Replies {
 public:
  explicit Replies(const Session& session) : session_(session) {}

  void print(std::string_view reply, std::string_view asked) {
    print_reply(reply);
    const DeviceType& type = session_.type();
    if (!type.refuses || !type.refuses(reply)) return;
    std::string words =
        type.explain ? type.explain(reply, Way::received, TrafficKind::unsolicited, asked) : std::string();
    if (words.ends_with('.')) words.pop_back();
    complain(fmt::format("{}: The controller answered {}{}.", asked, reply,
                         words.empty() ? "" : fmt::format(" ({})", words)));
    status_ = failed;
  }
  void print_unsolicited(Session& session, std::string_view asked) {
    std::string text;
    while (session.pump().take_unsolicited(text)) print(text, asked);
  }
  [[nodiscard]] int status() const { return status_; }

 private:
  const Session& session_;
  int status_ = done;
};

// Prints unsolicited text until the controller is idle: it belongs to the text that made the controller busy.
Task<bool> print_until_idle(std::shared_ptr<Session> session, Replies& replies, std::string text,
                            Instant give_up) {
  co_await session->pump().refresh();
  for (bool in_time = true; in_time;) {
    replies.print_unsolicited(*session, text);
    if (session->known().link.state == LinkState::lost || !busy(session->known())) co_return true;
    in_time = co_await session->pump().published().wait_until(give_up);
  }
  co_return false;
}

Task<int> send_one(std::shared_ptr<Session> session, Replies& replies, std::string text, double wait_s) {
  const bool answers = session->pump().meaning_of(text).answered == TextMeaning::Answered::at_once;
  Duration patience = answers ? for_an_answer : for_a_prompt;
  if (wait_s > 0 && answers) patience = from_seconds(wait_s);
  const auto reply = co_await session->pump().query(text, patience);
  if (reply && (answers || !reply->empty())) replies.print(*reply, text);
  if (!reply && (answers || reply.error().kind != FaultKind::no_answer))
    co_return complain(fmt::format("{}: {}", text.empty() ? "\"\"" : text, reply.error().sentence()));
  replies.print_unsolicited(*session, text);
  co_return replies.status();
}

// Whether the next text waits. A prompt belongs to the text that causes it, so the next text waits for it; a
// stop never waits.
bool waits_before(const Pump& pump, const std::string& text, const std::string& next) {
  const TextMeaning meaning = pump.meaning_of(text);
  return meaning.answered != TextMeaning::Answered::at_once && meaning.end_is_reported &&
         !pump.meaning_of(next).is_stop();
}

Task<int> wait_for_rest(Scheduler& scheduler, std::shared_ptr<Session> session, Replies& replies,
                        std::string text, double wait_s) {
  const Instant give_up = scheduler.now() + from_seconds(wait_s > 0 ? wait_s : longest_run_s);
  const bool rests = co_await print_until_idle(session, replies, text, give_up);
  if (!rests)
    co_return complain(fmt::format("{}: the controller is still busy. It goes on by itself.", text));
  if (session->known().link.state == LinkState::lost)
    co_return complain(fmt::format("{}: {}", text, session->known().link.sentence.view()));
  co_return replies.status();
}

/// Sends texts one after another. A text that fails ends the series; a text that does not end in time does
/// not. No text is sent after a stop by the user, or when the replies are no longer read.
Task<int> send_texts(Scheduler& scheduler, std::shared_ptr<Session> session, const KeptLimits& limits,
                     std::span<const std::string> texts, double wait_s, Stopped& stopped) {
  const Pump& pump = session->pump();
  Replies replies(*session);
  int status = done;
  bool end_is_reported = false;
  for (std::size_t i = 0; i < texts.size() && !stopped.asked && !output_is_lost(); ++i) {
    stopped.unseen = true;
    const int sent = co_await send_one(session, replies, texts[i], wait_s);
    if (sent != done) co_return sent;
    end_is_reported = end_is_reported || pump.meaning_of(texts[i]).end_is_reported;
    const bool last = i + 1 == texts.size();
    if (last ? end_is_reported : waits_before(pump, texts[i], texts[i + 1])) {
      const int rested = co_await wait_for_rest(scheduler, session, replies, texts[i], wait_s);
      status = std::max(status, rested);
    }
    print_warnings(*session, limits);
  }
  co_await session->pump().refresh();  // the effects of the last text
  stopped.unseen = false;
  replies.print_unsolicited(*session, texts.empty() ? "" : texts.back());
  co_return std::max(status, replies.status());
}

/// A controller in an error state may accept only texts that stop or reset it. Such a first text is sent
/// while connecting, if the controller answers nothing else.
Task<int> send_stop_first(std::shared_ptr<Session> session, std::string text) {
  const auto reply = co_await session->pump().query(text, for_an_answer);
  // Some stops are never answered; the connection shows whether the controller is there.
  if (!reply && reply.error().kind == FaultKind::refused)  // the refusal says why it is not there
    if (const auto connected = co_await session->wait_until_connected(); !connected)
      co_return complain(connected.error(), status_of(connected.error()));
  if (!reply && reply.error().kind != FaultKind::no_answer)
    co_return complain(reply.error(), status_of(reply.error()));
  Replies replies(*session);
  if (reply && !reply->empty()) replies.print(*reply, text);
  co_return replies.status();
}

bool may_move(Session& session, const Stopped& stopped) { return busy(session.known()) || stopped.unseen; }

void stop(Session& session, Stopped& stopped) {
  if (!std::exchange(stopped.asked, true)) session.pump().post(Intent(Stopped::id, intent::Stop()));
}

/// An interrupt while an axis moves, or may have begun to, sends a stop; otherwise the program just ends.
void when_interrupted(Session& session, Stopped& stopped) {
  if (!may_move(session, stopped)) std::raise(SIGINT);
  stop(session, stopped);
}

Task<int> report_stop(std::shared_ptr<Session> session) {
  const IntentOutcome* outcome = session->known().outcome_of(Stopped::id);
  for (; outcome && outcome->state == IntentState::pending;
       outcome = session->known().outcome_of(Stopped::id))
    co_await session->pump().published().wait();
  const std::string why = output_is_lost() ? output_loss().sentence() : "Interrupted.";
  if (outcome && outcome->state != IntentState::done)
    co_return complain(fmt::format("{} {}", why, outcome->sentence.view()));
  co_return complain(why + " The controller was told to stop.");
}

Task<int> send_all(Scheduler& scheduler, const Address& address, const Given& given, double wait_s) {
  auto opened = Session::open(scheduler, address, wire_opener(), nullptr);
  if (!opened) co_return complain(opened.error(), status_of(opened.error()));
  const std::shared_ptr<Session> session = *opened;
  const KeptLimits limits(*session);
  std::span<const std::string> texts = std::span(given.words).subspan(1);
  Stopped stopped;
  const OutputWatch unread([&] {
    if (may_move(*session, stopped)) stop(*session, stopped);
  });
  int status = done;
  if (session->pump().meaning_of(texts[0]).is_stop()) {
    status = co_await send_stop_first(session, texts[0]);
    texts = texts.subspan(1);
  }
  if (status == done && !output_is_lost()) {
    const auto connected = co_await session->wait_until_connected();
    const Interruption interruption(scheduler, [&](int) { when_interrupted(*session, stopped); });
    status = connected ? co_await send_texts(scheduler, session, limits, texts, wait_s, stopped)
                       : complain(connected.error(), status_of(connected.error()));
  }
  if (stopped.asked) status = co_await report_stop(session);
  co_await session->close();
  print_warnings(*session, limits);
  co_return status;
}

}  // namespace

static int send(const Given& given) {
  const auto address = Address::parse(given.words[0]);
  if (!address) return complain(address.error(), usage);
  const auto wait_s = given.number("wait", 0, 0.001, 1e6);
  if (!wait_s) return complain(wait_s.error(), usage);
  return run_here([&](Scheduler& scheduler) { return send_all(scheduler, *address, given, *wait_s); });
}

const Subcommand send_subcommand{
    "send",
    "send each TEXT as one command, print each reply on a line",
    {{"ADDRESS", "the controller", 1, 1}, {"TEXT", "a command of the controller", 1, -1}},
    {{"wait", "SECONDS", "how long a reply may take (default: what the command and the wire need)"}},
    send,
};

}  // namespace hw::app
