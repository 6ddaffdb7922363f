#pragma once
// What will be done to a controller and to its wire, and when: drawn in advance, so that a plan that finds
// something is made smaller by leaving steps out. A plan is a text that a person can read, write and change:
//
//   model vxm
//   options motors=2
//   seconds 60
//   2.500 move_by 0 0 1234 0        at 2.5 s, device 0: axis 0 by 1234 steps, at its own speed
//   2.700 stop 0 -1                 all axes
//   3.000 type 0 "V"
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/time/clock.h"

namespace hw::simulation {

/// One thing that is done. What its numbers mean stands in the table of verbs: steps.h.
struct Step {
  Millis at{};
  std::string verb;
  int device = 0;  ///< its place on the wire
  std::vector<std::int64_t> numbers;
  std::string text;

  [[nodiscard]] std::int64_t number(std::size_t place) const { return numbers.at(place); }
  [[nodiscard]] std::string written() const;
  static Result<Step> read(const std::string& line);
};

/// The calls of a script, one a line: steps without their times.
std::string script_of(const std::vector<Step>& calls);
Result<std::vector<Step>> calls_of(std::string_view script);

struct Plan {
  std::string model;
  std::string options;      ///< of the address: "motors=4"
  Millis length{60'000};    ///< then everything is stopped and closed
  std::string finding;      ///< the law that it breaks, where one is known
  std::vector<Step> steps;  ///< in the order of time

  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::string written() const;
  static Result<Plan> read(std::string_view text);
};

}  // namespace hw::simulation
