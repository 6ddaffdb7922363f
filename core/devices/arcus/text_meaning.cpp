#include "core/devices/arcus/text_meaning.h"

namespace hw::arcus {

int axis_named_in(const Forms& forms, std::string_view text) {
  if (forms.model->axes() == 1) return 0;
  const std::string_view name = text.substr(0, text.find_first_of("=0123456789-"));
  const auto axis = name.empty() ? std::string_view::npos : forms.model->axis_letters.find(name.back());
  return axis == std::string_view::npos ? -1 : static_cast<int>(axis);
}

TextMeaning meaning_of(const Forms& forms, const intent::SendText& wish, Addressing addressing) {
  TextMeaning meaning;
  const Model& model = *forms.model;
  const std::string word = command_in(wish.text);
  const std::string_view text = text_of(wish.text);
  const int to = address_of(wish.text);
  const bool to_all = (to < 0 && wish.broadcast) || (to >= 0 && to == model.broadcast);
  if (to_all) {
    meaning.whom = TextMeaning::For::everybody;
  } else if (to >= 0 && to != addressing.own) {
    meaning.whom = TextMeaning::For::another;
    meaning.address = to;
  }
  if (ends_motion(text) || ends_program(text)) {
    const bool all = word == "STOP" || word == "ABORT";
    meaning.stops = all ? TextMeaning::Stops::all : TextMeaning::Stops::some;
    if (!all && ends_motion(text) && model.axes() > 1) meaning.axis = axis_named_in(forms, word);
  }
  meaning.answered =
      to_all && model.broadcast >= 0 ? TextMeaning::Answered::never : TextMeaning::Answered::at_once;
  meaning.end_is_told = addressing.tells_end;
  // A line of the program memory: SA[line]=[code].
  meaning.changes_programs = word.starts_with("SA") && word.find('=') != word.npos;
  meaning.runs_program = runs_program(text);
  return meaning;
}

}  // namespace hw::arcus
