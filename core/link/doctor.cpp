#include "core/link/doctor.h"

#include <algorithm>

#include <fmt/core.h>

namespace hw {
namespace {

using Finding = LinkFinding;
using Kind = LinkFinding::Kind;
using State = LinkFinding::State;
using Fix = LinkFinding::Fix;

constexpr Duration shortest_timer = Millis(1);
constexpr int enough_questions = 16;  ///< needed before times are judged

Duration on_wire(int bytes, int baud) {
  return baud > 0 ? Duration(static_cast<Duration::rep>(bytes) * 10'000'000'000LL / baud) : Duration::zero();
}

int best_rate(const LinkFacts& f) {
  if (f.rate == 0 || f.rates.empty()) return f.rate;
  return std::max(f.rate, *std::max_element(f.rates.begin(), f.rates.end()));
}

bool timer_is_long(const LinkFacts& f) { return f.adapter_waits && *f.adapter_waits > shortest_timer; }

std::string in_baud(int rate) {
  std::string digits = std::to_string(rate);
  if (digits.size() > 4) digits.insert(digits.size() - 3, "\u2009");
  return digits + " baud";
}

std::string per_second(Duration time) {
  return fmt::format("{:.0f}", time > Duration::zero() ? 1 / seconds(time) : 0.0);
}

// ---- wrong replies, or none

// One echo may be chance; a wire that echoes does so each time.
bool echoes(const LinkFacts& f) { return f.talk.echoes > 2; }
bool two_devices_answer(const LinkFacts& f) { return f.talk.second_answers > 2; }

Finding silence(const LinkFacts& f) {
  if (f.talk.received == 0)
    return {Kind::silence, State::wrong, "Nothing comes back",
            fmt::format(
                "Check these in turn: the controller's supply; the cable, also with RX and TX swapped; "
                "{}the address: its port and id must be those of the controller.",
                f.rate > 0 ? fmt::format("the rate, {} here, which must match its setting; ", in_baud(f.rate))
                           : std::string()),
            Fix::change_address};
  return {Kind::silence, State::wrong, "The replies are not understood",
          f.rate > 0
              ? fmt::format("Enter the rate that the controller is set to: most likely it is not {}. If the "
                            "rate is right, two controllers may answer at once: connect one alone.",
                            in_baud(f.rate))
              : std::string("Check the model of the controller, and the rate of the converter at its end: "
                            "most likely one of them differs."),
          Fix::change_address};
}

std::vector<Finding> strange_bytes(const LinkFacts& f) {
  std::vector<Finding> found;
  const TalkMeasure& t = f.talk;
  if (echoes(f))
    found.push_back({Kind::bytes, State::wrong, "The console receives its own bytes",
                     fmt::format("Switch the converter's echo off, or check RX and TX for a short: {} "
                                 "replies began with the query.",
                                 t.echoes)});
  if (t.second_answers > 0)
    found.push_back(
        {Kind::bytes, State::wrong, "Two replies came to one query",
         fmt::format("Give each controller its own address: it happened {}. If each has its own, another "
                     "program uses the same wire.",
                     t.second_answers == 1 ? "once" : fmt::format("{} times", t.second_answers))});
  if (t.wrong > 0 && f.answers)
    found.push_back({Kind::bytes, State::wrong,
                     fmt::format("{} of {} bytes were not understood", t.wrong, t.received),
                     "Check the ground and the shield of the cable, and the termination of a long cable: its "
                     "signals are disturbed."});
  if (found.empty() && f.answers && t.received > 0)
    found.push_back({Kind::bytes, State::good, "No echo, no second reply, no wrong bytes",
                     fmt::format("{} bytes were checked.", t.received)});
  return found;
}

// ---- time

Finding adapter(const LinkFacts& f) {
  const Duration now = *f.adapter_waits;
  const auto ms = [](Duration d) { return std::chrono::duration_cast<Millis>(d).count(); };
  if (!timer_is_long(f))
    return {Kind::adapter, State::good, "The USB adapter passes bytes on at once",
            fmt::format("Its latency timer is {} ms.", ms(now))};
  const Duration saved = link_budget(f).adapter - std::min(link_budget(f).adapter, shortest_timer);
  std::string why = fmt::format("Its latency timer is {} ms.", ms(now));
  if (saved > Duration::zero()) why += fmt::format(" A timer of 1 ms saves {} per query.", in_millis(saved));
  why += f.adapter_timer_can_be_set ? " No controller is affected."
                                    : fmt::format(" Type: echo 1 | sudo tee {}", f.adapter_timer);
  return {Kind::adapter, State::could_be_better,
          fmt::format("The USB adapter waits up to {} ms before it passes bytes on", ms(now)), std::move(why),
          f.adapter_timer_can_be_set ? Fix::set_adapter_timer : Fix::none};
}

Finding rate(const LinkFacts& f) {
  const int best = best_rate(f);
  if (best == f.rate)
    return {Kind::rate, State::good, fmt::format("The wire runs at {}", in_baud(f.rate)),
            "This controller has no higher rate."};
  const int bytes = f.talk.bytes_out + f.talk.bytes_in;
  const Duration saved = on_wire(bytes, f.rate) - on_wire(bytes, best);
  std::string why =
      saved > Duration::zero() ? fmt::format("The higher rate saves {} per query. ", in_millis(saved)) : "";
  why += f.rate_is_set_by.empty() ? "Set the switches on the controller: it has no parameter for this."
                                  : "Each step is read back. If one fails, the old rate is restored.";
  return {Kind::rate,
          State::could_be_better,
          fmt::format("The wire runs at {}, the controller can do {}", in_baud(f.rate), in_baud(best)),
          std::move(why),
          f.rate_is_set_by.empty() ? Fix::none : Fix::raise_rate,
          best};
}

std::vector<Finding> answers_in_time(const LinkFacts& f) {
  std::vector<Finding> found;
  const TalkMeasure& t = f.talk;
  if (f.answers && t.unanswered > 0 && t.unanswered * 100 > t.questions)
    found.push_back({Kind::losses, State::wrong,
                     fmt::format("{} of {} queries got no reply", t.unanswered, t.questions + t.unanswered),
                     "Check the plug and the cable. Where several controllers share a wire, check whether "
                     "one is switched off."});
  constexpr Duration worth_reporting = Millis(20);
  if (t.questions >= enough_questions && t.slowest_of_hundred > 3 * t.median &&
      t.slowest_of_hundred > t.median + worth_reporting)
    found.push_back(
        {Kind::scatter, State::could_be_better,
         fmt::format("One reply in a hundred takes {} or longer", in_millis(t.slowest_of_hundred)),
         "Check whether the computer or the network is busy: replies usually come sooner."});
  return found;
}

Finding holder(const LinkFacts& f) {
  if (f.holder.empty())
    return {Kind::holder, State::good, "No other program has the port open",
            "Every program that this user may see was checked."};
  return {Kind::holder, State::wrong, fmt::format("{} has the port open too", f.holder),
          "Close the port in that program: two programs on one port take each other's replies."};
}

}  // namespace

std::string in_millis(Duration time) {
  const double ms = seconds(time) * 1e3;
  return fmt::format("{:.{}f} ms", ms, ms < 100 ? 1 : 0);
}

LinkBudget link_budget(const LinkFacts& f) {
  LinkBudget b;
  b.question = std::min(on_wire(f.talk.bytes_out, f.rate), f.talk.median);
  b.answer = std::min(on_wire(f.talk.bytes_in, f.rate), f.talk.median - b.question);
  b.rest = f.talk.median - b.question - b.answer;
  if (f.adapter_waits) b.adapter = std::min(*f.adapter_waits, b.rest);
  b.rest -= b.adapter;
  return b;
}

LinkBudget best_link_budget(const LinkFacts& f) {
  LinkBudget b = link_budget(f);
  const int best = f.rate_is_set_by.empty() ? f.rate : best_rate(f);
  if (best > f.rate && f.rate > 0) {
    b.question = on_wire(f.talk.bytes_out, best);
    b.answer = on_wire(f.talk.bytes_in, best);
  }
  b.adapter = std::min(b.adapter, shortest_timer);
  return b;
}

std::string link_summary(const LinkFacts& f) {
  if (f.talk.questions == 0) return {};
  const Duration now = link_budget(f).whole(), then = best_link_budget(f).whole();
  std::string words = fmt::format("One query takes {}: {} per second.", in_millis(now), per_second(now));
  if (then < now) words += fmt::format(" {} is possible: {} per second.", in_millis(then), per_second(then));
  return words;
}

std::vector<LinkFinding> examine_link(const LinkFacts& f) {
  std::vector<Finding> found;
  if (!f.answers && !echoes(f) && !two_devices_answer(f))
    found.push_back(silence(f));  // those are reason enough
  for (Finding& finding : strange_bytes(f)) found.push_back(std::move(finding));
  for (Finding& finding : answers_in_time(f)) found.push_back(std::move(finding));
  if (f.port_looked_at) found.push_back(holder(f));
  if (f.adapter_waits) found.push_back(adapter(f));
  if (f.is_line && f.rate > 0 && f.answers && f.rates.size() > 1) found.push_back(rate(f));
  std::stable_sort(found.begin(), found.end(),
                   [](const Finding& a, const Finding& b) { return a.state > b.state; });
  return found;
}

}  // namespace hw
