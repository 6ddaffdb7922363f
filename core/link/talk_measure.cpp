#include "core/link/talk_measure.h"

#include <algorithm>
#include <utility>

namespace hw {
namespace {

// A question of one letter may be answered by the same letter.
constexpr std::size_t shortest_echo = 3;

bool begins_with_question(std::string_view answer, std::string_view question, std::size_t shortest) {
  while (!question.empty() && (question.back() == '\r' || question.back() == '\n')) question.remove_suffix(1);
  return question.size() >= shortest && answer.starts_with(question);
}

bool is_plain(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte >= 0x20 && byte < 0x7F) || c == '\r' || c == '\n' || c == 0;  // some end with a zero
  });
}

}  // namespace

void TalkRecorder::record(Instant at, Way way, TrafficKind kind, std::string_view bytes) {
  if (way == Way::sent) {
    if (poll_waits_) ++counts_.unanswered;
    poll_waits_ = kind == TrafficKind::poll;
    asked_ = bytes;
    asked_at_ = at;
    answer_.clear();
    echoed_ = false;
    return;
  }
  counts_.received += bytes.size();
  if (kind == TrafficKind::unsolicited) return;
  const std::size_t shortest = kind == TrafficKind::unparsed ? 1 : shortest_echo;
  const bool echo = !echoed_ && answer_.empty() && begins_with_question(bytes, asked_, shortest);
  if (echo) echoed_ = true, ++counts_.echoes;
  // The driver's interpretation of an echo, and of the answer behind it, says nothing new about the wire.
  if (kind == TrafficKind::unparsed && echoed_ && is_plain(bytes)) return;
  if (kind != TrafficKind::unparsed) return answered(at, kind, bytes);
  // The same end and no wrong bytes: a second device has answered.
  const bool same = !answer_.empty() && bytes == answer_;
  if (same || (answer_.size() > 1 && bytes.ends_with(answer_.back()) && is_plain(bytes)))
    ++counts_.second_answers;
  else
    counts_.wrong += bytes.size();
}

void TalkRecorder::answered(Instant at, TrafficKind kind, std::string_view bytes) {
  if (!answer_.empty()) return;  // a long reply comes in pieces
  answer_ = bytes;
  if (kind != TrafficKind::poll || !std::exchange(poll_waits_, false)) return;
  const Question question{at - asked_at_, static_cast<int>(asked_.size()), static_cast<int>(bytes.size())};
  if (questions_.size() < most_questions)
    questions_.push_back(question);
  else
    questions_[next_++ % most_questions] = question;
}

TalkMeasure TalkRecorder::measure() const {
  TalkMeasure m = counts_;
  m.questions = static_cast<int>(questions_.size());
  if (questions_.empty()) return m;
  std::vector<Question> sorted = questions_;
  std::sort(sorted.begin(), sorted.end(),
            [](const Question& a, const Question& b) { return a.round_trip < b.round_trip; });
  const std::size_t n = sorted.size();
  const Question& middle = sorted[n / 2];
  m.least = sorted.front().round_trip;
  m.median = middle.round_trip;
  m.bytes_out = middle.out;
  m.bytes_in = middle.in;
  m.slowest_of_hundred = sorted[std::min(n - 1, n * 99 / 100)].round_trip;
  return m;
}

}  // namespace hw
