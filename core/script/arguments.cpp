#include "core/script/arguments.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "core/base/near_name.h"

namespace hw::script {
namespace {

using Kind = Argument::Kind;

tl::unexpected<Fault> wrong_words(std::string what) {
  return fail(FaultKind::text, std::move(what), {}, "--help lists the options.");
}

const Argument* named(const std::vector<Argument>& known, const std::string& name) {
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const Argument& one) { return one.name == name; });
  return found == known.end() ? nullptr : &*found;
}

const char* words_of(Kind kind) {
  switch (kind) {
    case Kind::number: return "a number";
    case Kind::whole: return "a whole number";
    default: return "a text";
  }
}

bool is_number(const std::string& text, bool whole) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && std::isfinite(value) &&
         (!whole || (std::floor(value) == value && std::abs(value) < 1e15));
}

Result<> may_be(const Argument& argument, const std::string& value) {
  const bool number = argument.kind == Kind::number || argument.kind == Kind::whole;
  if (number && !is_number(value, argument.kind == Kind::whole))
    return wrong_words(
        fmt::format("\"{}\" must be {}, not \"{}\".", argument.name, words_of(argument.kind), value));
  const auto& choices = argument.choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end())
    return wrong_words(fmt::format("\"{}\" must be one of {}, not \"{}\".{}", argument.name,
                                   fmt::join(choices, ", "), value, did_you_mean(value, choices)));
  return {};
}

/// Reads the words in order.
class ArgumentReader {
 public:
  ArgumentReader(const std::vector<Argument>& known, const std::vector<std::string>& words)
      : known_(known), words_(words) {}

  Result<GivenArguments> read() {
    for (at_ = 0; at_ < words_.size() && !given_.wants_help; ++at_)
      if (auto taken = take(words_[at_]); !taken) return fail(taken.error());
    if (given_.wants_help) return given_;
    for (const Argument& one : known_)
      if (one.required && !given_.values.contains(one.name))
        return wrong_words(fmt::format("\"{}\" is missing.", one.name));
    return given_;
  }

 private:
  Result<> take(const std::string& word) {
    given_.wants_help = word == "--help" || word == "-h";
    if (given_.wants_help) return {};
    const std::size_t equals = word.find('=');
    const bool dashes = word.starts_with("--");
    const std::size_t from = dashes ? 2 : 0;
    const std::string name = word.substr(from, equals == word.npos ? equals : equals - from);
    if (dashes) return take_named(word, name, equals);
    if (equals != word.npos && named(known_, name)) return take_named(word, name, equals);
    return take_place(word);
  }

  Result<> take_named(const std::string& word, const std::string& name, std::size_t equals) {
    const Argument* argument = named(known_, name);
    if (!argument) {
      std::vector<std::string> names;
      for (const Argument& one : known_) names.push_back(one.name);
      return wrong_words(fmt::format("There is no \"--{}\".{}", name, did_you_mean(name, names)));
    }
    if (argument->kind == Kind::flag)
      return equals == word.npos ? put(*argument, "")
                                 : wrong_words(fmt::format("\"--{}\" takes no value.", name));
    if (equals != word.npos) return put(*argument, word.substr(equals + 1));
    if (at_ + 1 == words_.size()) return wrong_words(fmt::format("A value is missing after \"--{}\".", name));
    return put(*argument, words_[++at_]);
  }

  Result<> take_place(const std::string& word) {
    for (const Argument& one : known_)
      if (one.required && !given_.values.contains(one.name)) return put(one, word);
    std::vector<std::string> names;
    for (const Argument& one : known_) names.push_back(one.name);
    const std::size_t equals = word.find('=');
    return wrong_words(
        fmt::format("\"{}\" is one word too many.{}", word,
                    equals == word.npos ? std::string() : did_you_mean(word.substr(0, equals), names)));
  }

  Result<> put(const Argument& argument, const std::string& value) {
    if (auto may = may_be(argument, value); !may) return may;
    if (!given_.values.emplace(argument.name, value).second)
      return wrong_words(fmt::format("\"{}\" is given twice.", argument.name));
    return {};
  }

  const std::vector<Argument>& known_;
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
  GivenArguments given_;
};

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string argument_form(const Argument& one) {
  if (one.required) return upper(one.name);
  if (one.kind == Kind::flag) return "--" + one.name;
  if (!one.choices.empty()) return fmt::format("--{} {}", one.name, fmt::join(one.choices, "|"));
  return fmt::format("--{} {}", one.name,
                     one.kind == Kind::text    ? "TEXT"
                     : one.kind == Kind::whole ? "N"
                                               : "X");
}

}  // namespace

Result<Kind> argument_kind(const std::string& word) {
  static constexpr std::pair<std::string_view, Kind> kinds[] = {
      {"text", Kind::text}, {"number", Kind::number}, {"whole", Kind::whole}, {"flag", Kind::flag}};
  for (const auto& [name, kind] : kinds)
    if (name == word) return kind;
  return fail(FaultKind::text,
              fmt::format("There is no kind \"{}\": it is text, number, whole or flag.", word));
}

Result<GivenArguments> read_arguments(const std::vector<Argument>& known,
                                      const std::vector<std::string>& words) {
  return ArgumentReader(known, words).read();
}

std::string arguments_help(const std::vector<Argument>& known, const std::string& script,
                           const std::string& about) {
  const bool options =
      std::any_of(known.begin(), known.end(), [](const Argument& one) { return !one.required; });
  std::string all = fmt::format("handwheel run {}", script);
  std::size_t widest = 0;
  for (const Argument& one : known) {
    if (one.required) all += " " + argument_form(one);
    widest = std::max(widest, argument_form(one).size());
  }
  if (options) all += " [-- OPTIONS]";
  all += "\n";
  if (!about.empty()) all += about + "\n";
  for (const Argument& one : known) {
    all += fmt::format("  {:<{}}  {}", argument_form(one), widest, one.help);
    if (!one.fallback.empty())
      all += fmt::format("{}(default {})", one.help.empty() ? "" : " ", one.fallback);
    all += "\n";
  }
  return all;
}

}  // namespace hw::script
