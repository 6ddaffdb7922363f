#include "tests/talk/talk.h"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace hw::talk {
namespace {

constexpr Duration click_time = Millis(50);
constexpr std::size_t enough_failures = 5;

auto wrong(int line, const std::string& why) {
  return fail(FaultKind::text, "Line " + std::to_string(line) + ": " + why + ".");
}

Result<std::string> unescape(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      bytes += text[i];
      continue;
    }
    const char kind = ++i < text.size() ? text[i] : ' ';
    if (kind == 'r') {
      bytes += '\r';
    } else if (kind == 'n') {
      bytes += '\n';
    } else if (kind == '0') {
      bytes += '\0';
    } else if (kind == '\\') {
      bytes += '\\';
    } else if (kind == 'x' && i + 2 < text.size()) {
      unsigned value = 0;
      const auto end = text.data() + i + 3;
      if (std::from_chars(text.data() + i + 1, end, value, 16).ptr != end)
        return fail(FaultKind::text, "two hex digits have to follow \\x");
      bytes += static_cast<char>(value);
      i += 2;
    } else {
      return fail(FaultKind::text, "a backslash is followed by r, n, 0, xNN or a backslash");
    }
  }
  return bytes;
}

Result<Duration> duration(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const std::string unit = end;
  if (unit == "s") return from_seconds(value);
  if (unit == "ms") return from_seconds(value / 1e3);
  if (unit == "us") return from_seconds(value / 1e6);
  return fail(FaultKind::text, "a time is a number with s, ms or us");
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string w; in >> w;) words.push_back(w);
  return words;
}

/// By number, or by one of the letters X, Y, Z, U.
AxisId axis(const std::string& word) {
  const auto letter = std::string_view("XYZU").find(word);
  if (word.size() == 1 && letter != std::string_view::npos) return AxisId{static_cast<std::uint8_t>(letter)};
  return AxisId{static_cast<std::uint8_t>(std::atoi(word.c_str()) - 1)};
}

Result<AxisPlace> place(const std::vector<std::string>& words) {
  AxisPlace p;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto equals = words[i].find('=');
    if (equals == std::string::npos) return fail(FaultKind::text, "place wants key=value");
    const std::string key = words[i].substr(0, equals), value = words[i].substr(equals + 1);
    const Steps steps(std::atoll(value.c_str()));
    if (key == "minus") {
      p.minus = steps;
    } else if (key == "plus") {
      p.plus = steps;
    } else if (key == "index_every") {
      p.index_every = steps;
    } else if (const auto dots = value.find(".."); key == "home" && dots != std::string::npos) {
      p.home_from = steps;
      p.home_to = Steps(std::atoll(value.c_str() + dots + 2));
    } else {
      return fail(FaultKind::text, "place knows minus=N, plus=N, home=FROM..TO and index_every=N");
    }
  }
  return p;
}

// The last word says which way; what stands between the first two is a name with spaces ("Slave Run").
std::string name_between(const std::vector<std::string>& words) {
  std::string name;
  for (std::size_t i = 1; i + 1 < words.size(); ++i) name += (name.empty() ? "" : " ") + words[i];
  return name;
}

Result<std::vector<BenchCommand>> hands(std::string_view text) {
  const auto words = words_of(text);
  const std::string what = words.empty() ? "" : words[0];
  const std::string last = words.empty() ? "" : words.back();
  std::vector<BenchCommand> all;
  if (what == "input" && words.size() == 3) {
    all.push_back(bench::Input(std::atoi(words[1].c_str()), last == "low"));
  } else if (what == "button" && words.size() >= 3) {
    if (last != "up") all.push_back(bench::Button(name_between(words), true));
    if (last != "down") all.push_back(bench::Button(name_between(words), false));
  } else if (what == "limit" && words.size() == 4) {
    all.push_back(bench::Limit(axis(words[1]), words[2] == "+" ? Sign::plus : Sign::minus, last == "on"));
  } else if (what == "home" && words.size() == 3) {
    all.push_back(bench::HomeSwitch(axis(words[1]), last == "on"));
  } else if (what == "analog" && words.size() == 3) {
    all.push_back(bench::Analog(std::atoi(words[1].c_str()), std::atoi(last.c_str())));
  } else if (what == "alarm" && words.size() == 3) {
    all.push_back(bench::Alarm(axis(words[1]), last == "on"));
  } else if (what == "jam" && words.size() == 3) {
    all.push_back(bench::Jam(axis(words[1]), last == "on"));
  } else if (what == "slip" && words.size() == 3) {
    all.push_back(bench::Slip(axis(words[1]), Steps(std::atoll(last.c_str()))));
  } else if (what == "power" && last == "cycle") {
    all.push_back(bench::PowerCycle{});
  } else if (what == "place" && words.size() >= 2) {
    auto p = place(words);
    if (!p) return fail(p.error());
    all.push_back(bench::Place(axis(words[1]), *p));
  } else {
    return fail(FaultKind::text, "the bench knows no \"" + std::string(text) + "\"");
  }
  return all;
}

Result<> read_step(char kind, std::string_view rest, Step& step) {
  if (kind == '>' || kind == '<') {
    step.kind = kind == '>' ? Step::Kind::send : Step::Kind::expect;
    auto bytes = unescape(rest);
    if (!bytes) return fail(bytes.error());
    step.bytes = std::move(*bytes);
  } else if (kind == '~') {
    step.kind = Step::Kind::pass;
    auto time = duration(std::string(rest));
    if (!time) return fail(time.error());
    step.time = *time;
  } else if (kind == '!') {
    step.kind = Step::Kind::bench;
    auto all = hands(rest);
    if (!all) return fail(all.error());
    step.hands = std::move(*all);
  } else {
    return fail(FaultKind::text, "a line begins with @ # > < ~ or !");
  }
  return {};
}

Result<> add_line(std::string_view line, int number, Transcript& transcript) {
  const char kind = line[0];
  const std::string_view rest = line.size() > 2 ? line.substr(2) : std::string_view{};
  if (kind == '#') return {};
  if (line.size() > 1 && line[1] != ' ') return wrong(number, "a blank stands behind the first character");
  if (kind == '@') {
    for (const std::string& word : words_of(rest)) {
      const auto equals = word.find('=');
      if (equals == std::string::npos || !transcript.steps.empty())
        return wrong(number, "options are key=value and come first");
      transcript.options.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return {};
  }
  Step step;
  step.line = number;
  if (auto done = read_step(kind, rest, step); !done) return wrong(number, done.error().what);
  transcript.steps.push_back(std::move(step));
  return {};
}

std::string sentence(int line, const std::string& what) {
  return "line " + std::to_string(line) + ": " + what;
}

void expect_nothing(const Step& step, Partner& partner, std::vector<std::string>& failures) {
  if (const std::string more = partner.leftover(); !more.empty())
    failures.push_back(sentence(step.line, "unexpected before it: \"" + escape(more) + "\""));
}

void expect(const Step& step, Partner& partner, std::vector<std::string>& failures) {
  if (step.bytes.empty()) return expect_nothing(step, partner, failures);
  std::string got = partner.receive(step.bytes.size());
  if (got == step.bytes) return;
  got += partner.leftover();
  failures.push_back(
      sentence(step.line, "expected \"" + escape(step.bytes) + "\", got \"" + escape(got) + "\""));
}

void use_hands(const Step& step, Partner& partner, std::vector<std::string>& failures) {
  for (const BenchCommand& command : step.hands) {
    if (auto done = partner.operate(command); !done)
      failures.push_back(sentence(step.line, done.error().sentence()));
    if (step.hands.size() > 1) partner.pass(click_time);
  }
}

}  // namespace

Result<Transcript> parse(std::string_view text) {
  Transcript transcript;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.empty()) continue;
    if (auto done = add_line(line, number, transcript); !done) return fail(done.error());
  }
  return transcript;
}

Result<Transcript> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(FaultKind::port, "The transcript " + path + " cannot be opened.");
  std::ostringstream text;
  text << file.rdbuf();
  return parse(text.str());
}

std::vector<std::string> run(const Transcript& transcript, Partner& partner) {
  std::vector<std::string> failures;
  for (const Step& step : transcript.steps) {
    switch (step.kind) {
      case Step::Kind::send:
        expect_nothing(step, partner, failures);
        partner.send(step.bytes);
        break;
      case Step::Kind::expect: expect(step, partner, failures); break;
      case Step::Kind::pass: partner.pass(step.time); break;
      case Step::Kind::bench: use_hands(step, partner, failures); break;
    }
    if (failures.size() >= enough_failures) return failures;
  }
  if (const std::string more = partner.leftover(); !more.empty())
    failures.push_back("at the end: unexpected \"" + escape(more) + "\"");
  return failures;
}

std::string escape(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto u = static_cast<unsigned char>(c);
    if (c == '\r') {
      text += "\\r";
    } else if (c == '\n') {
      text += "\\n";
    } else if (c == '\\') {
      text += "\\\\";
    } else if (u >= 0x20 && u < 0x7F) {
      text += c;
    } else {
      constexpr char digits[] = "0123456789ABCDEF";
      text += "\\x";
      text += digits[u >> 4];
      text += digits[u & 15];
    }
  }
  return text;
}

}  // namespace hw::talk
