#include "core/devices/arcus/text_meaning.h"

#include <algorithm>

#include "core/devices/arcus/catalog_params.h"

namespace hw::arcus {
namespace {

/// The bare name of a setting is a question.
bool is_setting(const Model& model, std::string_view command) {
  return std::any_of(model.settings.begin(), model.settings.end(), [&](const SettingFact& fact) {
    for (int place = 0; place < fact.count; ++place)
      if (mnemonic_of(model, fact, place) == command) return true;
    return false;
  });
}

/// Whether the text asks for a state: of all axes, of one axis, or of a numbered item.
bool is_reading(const Model& model, std::string_view command) {
  constexpr std::string_view heads[] = {"MST", "PP", "PE", "PS", "P",   "E",  "DX",  "AI",  "DI",
                                        "DO",  "EO", "V",  "ID", "VER", "TR", "SPC", "SLS", "SASTAT"};
  const auto place = [&model](char c) {
    return (c >= '0' && c <= '9') || model.axis_letters.find(c) != std::string_view::npos;
  };
  return std::any_of(std::begin(heads), std::end(heads), [&](std::string_view head) {
    return command.starts_with(head) &&
           std::all_of(command.begin() + static_cast<std::ptrdiff_t>(head.size()), command.end(), place);
  });
}

/// Any other text without '=' has an effect: STORE, CLR, SYNXF.
bool only_asks(const Model& model, std::string_view command) {
  return command.find('=') == command.npos && (is_reading(model, command) || is_setting(model, command));
}

}  // namespace

int axis_named_in(const Forms& forms, std::string_view text) {
  if (forms.model->axes() == 1) return 0;
  const std::string_view name = text.substr(0, text.find_first_of("=0123456789-"));
  const auto axis = name.empty() ? std::string_view::npos : forms.model->axis_letters.find(name.back());
  return axis == std::string_view::npos ? -1 : static_cast<int>(axis);
}

TextMeaning meaning_of(const Forms& forms, const intent::SendText& request, Addressing addressing) {
  TextMeaning meaning;
  const Model& model = *forms.model;
  const std::string word = command_in(request.text);
  const std::string_view text = text_of(request.text);
  const int to = address_of(request.text);
  const bool to_all = (to < 0 && request.broadcast) || (to >= 0 && to == model.broadcast);
  if (to_all) {
    meaning.addressee = TextMeaning::For::all;
  } else if (to >= 0 && to != addressing.own) {
    meaning.addressee = TextMeaning::For::another;
    meaning.address = to;
  }
  if (ends_motion(text) || ends_program(text)) {
    const bool all = word == "STOP" || word == "ABORT";
    meaning.stops = all ? TextMeaning::Stops::all : TextMeaning::Stops::some;
    if (!all && ends_motion(text) && model.axes() > 1) meaning.axis = axis_named_in(forms, word);
  }
  meaning.answered =
      to_all && model.broadcast >= 0 ? TextMeaning::Answered::never : TextMeaning::Answered::at_once;
  meaning.end_is_reported = addressing.reports_end;
  // A line of the program memory: SA[line]=[code].
  meaning.changes_programs = word.starts_with("SA") && word.find('=') != word.npos;
  meaning.runs_program = runs_program(text);
  meaning.only_asks = only_asks(model, word);
  return meaning;
}

}  // namespace hw::arcus
