#pragma once
// Texts that a language has written, read back; and what texts become, in words.
#include <string>

#include <gtest/gtest.h>

#include "core/device/language.h"
#include "core/sequence/steps_in.h"
#include "core/sequence/words.h"

namespace hw {

/// As steps they are the same text again.
inline void expect_reads_back(const Language& language, std::string_view text,
                              const sequence::Sequence& frame, const Catalog& catalog) {
  const auto read = language.read(text, frame, catalog);
  ASSERT_TRUE(read) << read.error().sentence() << "\n" << text;
  const auto again = language.write(read->sequence, catalog);
  ASSERT_TRUE(again) << again.error().sentence() << "\n" << text;
  EXPECT_EQ(again->text, text);
}

/// "Loop 3 times\n  Move to X 5\n"; of a controller's own text that itself.
inline std::string in_words(const sequence::StepList& steps, const sequence::Sequence& of, int indent = 0) {
  std::string all;
  for (const sequence::Step& step : steps) {
    all += std::string(static_cast<std::size_t>(indent), ' ');
    if (const auto* own = std::get_if<sequence::Custom>(&step.body))
      all += "own: " + own->text + "\n";
    else
      all += std::string(sequence::title_of(step.body)) + " " + sequence::summary_of(step.body, of) + "\n";
    if (const sequence::StepList* inner = steps_in(step)) all += in_words(*inner, of, indent + 2);
  }
  return all;
}
/// Or the refusal.
inline std::string blocks_of(const Language& language, std::string_view text, const sequence::Sequence& frame,
                             const Catalog& catalog) {
  const auto read = language.read(text, frame, catalog);
  return read ? in_words(read->sequence.steps, read->sequence) : read.error().what;
}

}  // namespace hw
