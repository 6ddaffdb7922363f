#pragma once
// What a hand has to be able to do, or the test ends with the sentence that says why not.
#include <gtest/gtest.h>

#define MUST(action)                                          \
  do {                                                        \
    const auto done = (action);                               \
    ASSERT_TRUE(done.has_value()) << done.error().sentence(); \
  } while (false)
