// What a raw text does, read without a board.
#include "core/devices/vme58/text_meaning.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

using Answered = TextMeaning::Answered;
using Stops = TextMeaning::Stops;

TextMeaning read(std::string_view text, const Context& context = {}, int axes = most_axes) {
  return meaning_of(text, context, axes);
}

Context group_of_all() {
  Context context;
  context.mode = where::all;
  return context;
}

TEST(Vme58TextMeaning, OfAllCommandsFourStop) {
  constexpr std::array<std::string_view, 4> stops{"ST", "SA", "SD", "KL"};
  for (const Form& form : form_table()) {
    const bool stop = std::find(stops.begin(), stops.end(), form.example) != stops.end();
    EXPECT_EQ(read("AX " + form.example).is_stop(), stop) << form.id << ": " << form.example;
  }
}

TEST(Vme58TextMeaning, QueriesAndNothingElseAreAnsweredAtOnce) {
  for (const Form& form : form_table()) {
    if (form.is("dpram") || form.is("register")) continue;
    const bool answered = read("AX " + form.example).answered == Answered::at_once;
    EXPECT_EQ(answered, form.is("query")) << form.id << ": " << form.example;
  }
  EXPECT_EQ(read("AX MR100 GO RP").answered, Answered::at_once);
  EXPECT_EQ(read("").answered, Answered::never);
  EXPECT_EQ(read("SA").answered, Answered::never);
}

TEST(Vme58TextMeaning, KnowsWhatOnlyAsks) {
  for (const char* text : {"AX RP", "AX;RP;", "WY", "AA RE", "AX QA"})
    EXPECT_TRUE(read(text).only_asks) << text;
  for (const char* text : {"", "AX MR100 GO RP", "AX LP0", "AX ST", "AX RA", "AX VL100"})
    EXPECT_FALSE(read(text).only_asks) << text;
}

TEST(Vme58TextMeaning, SomeStopAllAxes) {
  for (const char* text : {"SA", "KL", "SD", "AA SA", "AX;KL;\n", "AX ST SA", " SA SA AY"}) {
    EXPECT_EQ(read(text).stops, Stops::all) << text;
    EXPECT_EQ(read(text).axis, -1) << text;
  }
}

TEST(Vme58TextMeaning, STStopsWhatStandsBeforeIt) {
  EXPECT_EQ(read("AX ST").stops, Stops::some);
  EXPECT_EQ(read("AX ST").axis, 0);
  EXPECT_EQ(read("AX AY ST ST").axis, 1);
  EXPECT_EQ(read("AX ST AY ST").axes, 0b11u);
  EXPECT_EQ(read("AZ ST").axes, 0b100u);
  EXPECT_EQ(read("AA ST", {}, 4).axes, 0b1111u);
  for (const char* several : {"AAST", "AM ST", "AX ST AY ST"}) {
    EXPECT_EQ(read(several).stops, Stops::some) << several;
    EXPECT_EQ(read(several).axis, -1) << several;
  }
}

TEST(Vme58TextMeaning, ABareSTTakesItsTurnBehindWhatMaySelect) {
  EXPECT_FALSE(read("ST").is_stop());
  EXPECT_FALSE(read("ST AX").is_stop());
  EXPECT_FALSE(read("ST", group_of_all()).is_stop());
}

TEST(Vme58TextMeaning, ATextThatDoesMoreIsNoStop) {
  for (const char* text :
       {"", "AX", "SA MR100 GO", "AX ST RP", "KL 5", "sa", "S A", "RS", "SAX", "FL", "SA XX"})
    EXPECT_FALSE(read(text).is_stop()) << text;
}

TEST(Vme58TextMeaning, AnAxisThatTheBoardLacksMakesItNone) {
  EXPECT_TRUE(read("AT ST", {}, 4).is_stop());
  EXPECT_FALSE(read("AU ST", {}, 4).is_stop());
  EXPECT_FALSE(read("AS SA", {}, 4).is_stop());
}

TEST(Vme58TextMeaning, TheBoardKeepsNoPrograms) {
  for (const Form& form : form_table()) EXPECT_FALSE(read(form.example).changes_programs) << form.example;
}

}  // namespace
}  // namespace hw::vme58::proof
