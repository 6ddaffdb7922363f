// The manual's printed replies, as they stand in the transcripts, from the console's side: the codec must
// understand each of them as the answer to what was sent before it.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/explain.h"
#include "tests/talk/talk.h"

namespace hw::vxm {
namespace {

/// What is left of `received` after the answer to `question`, or nullopt when it is no such answer.
std::optional<std::string_view> after_answer(const TextCommand& question, std::string_view received) {
  const auto line_end = received.find('\r');
  const std::string_view line =
      received.substr(0, line_end == received.npos ? received.size() : line_end + 1);
  const std::string_view rest = received.substr(line.size());
  const char letter = question.verb == Verb::letter ? question.letter : '\0';
  const auto if_good = [&](bool good) { return good ? std::optional(rest) : std::nullopt; };
  if (letter == 'V')
    return decode_state(received.substr(0, 1)) ? std::optional(received.substr(1)) : std::nullopt;
  if (letter && std::string_view("?~$").find(letter) != std::string_view::npos) return received.substr(1);
  if (letter && std::string_view("XYZT*").find(letter) != std::string_view::npos)
    return if_good(decode_position(line).has_value());
  if (letter == 'x' || letter == 'y') {
    for (int i = 0; i < 4; ++i) {
      const auto end = received.find('\r');
      if (end == received.npos || !decode_position(received.substr(0, end + 1))) return std::nullopt;
      received.remove_prefix(end + 1);
    }
    return received;
  }
  if (letter == 'D') return decode_digitized(received, 4) ? std::optional(std::string_view{}) : std::nullopt;
  if (question.verb == Verb::word && question.name == "lst")
    return decode_listing(received) ? std::optional(std::string_view{}) : std::nullopt;
  if (question.verb == Verb::get && (question.name == "D0" || question.name == "D1"))
    return if_good(decode_text_line(line).has_value());
  const bool number = (letter && std::string_view("M#@").find(letter) != std::string_view::npos) ||
                      question.verb == Verb::get || question.verb == Verb::ask_selected ||
                      question.verb == Verb::ask_associate;
  return number ? if_good(decode_number(line).has_value()) : std::nullopt;
}

bool understood_as_messages(std::string_view bytes) {
  while (!bytes.empty()) {
    const Message m = next_message(bytes);
    if (m.kind == Message::Kind::unknown || m.kind == Message::Kind::unfinished) return false;
    bytes.remove_prefix(m.length);
  }
  return true;
}

/// Answers to the questions in order, messages anywhere between them.
bool understood(const std::vector<TextCommand>& asked, std::string_view received) {
  for (const TextCommand& question : asked) {
    while (!received.empty()) {
      if (const auto rest = after_answer(question, received)) {
        received = *rest;
        break;
      }
      const Message m = next_message(received);
      const bool message = m.kind != Message::Kind::unknown && m.kind != Message::Kind::unfinished;
      if (!message) break;
      received.remove_prefix(m.length);
    }
  }
  return understood_as_messages(received);
}

class VxmCodecTalk : public testing::TestWithParam<std::string> {};

TEST_P(VxmCodecTalk, EveryReplyIsUnderstood) {
  const auto transcript = talk::read(std::string(HW_TEST_DIR) + "/talk/vxm/" + GetParam() + ".talk");
  ASSERT_TRUE(transcript) << transcript.error().sentence();
  std::string text, received;
  int line = 0;
  const auto check = [&] {
    if (!received.empty()) {
      EXPECT_TRUE(understood(read_text(text), received))
          << "line " << line << ": " << talk::escape(received) << " after " << talk::escape(text);
    }
    received.clear();
  };
  for (const talk::Step& step : transcript->steps) {
    if (step.kind == talk::Step::Kind::expect) {
      received += step.bytes;
      line = step.line;
    } else if (step.kind == talk::Step::Kind::send) {
      check();
      text = step.bytes;
      EXPECT_FALSE(explain(text, Way::sent, TrafficKind::intent, "").empty()) << step.line;
    }
  }
  check();
}

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(std::string(HW_TEST_DIR) + "/talk/vxm"))
    if (file.path().extension() == ".talk" && file.path().stem() != "echo")
      names.push_back(file.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Manual, VxmCodecTalk, testing::ValuesIn(transcripts()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace hw::vxm
