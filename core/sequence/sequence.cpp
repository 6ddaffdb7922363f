#include "core/sequence/sequence.h"

namespace hw::sequence {

Step::Body::Body(const Body& other) = default;
Step::Body::Body(Body&& other) noexcept = default;
Step::Body& Step::Body::operator=(const Body& other) = default;
Step::Body& Step::Body::operator=(Body&& other) noexcept = default;
Step::Body::~Body() = default;

// Not defaulted: clang 14 fails on an operator that is defaulted after its class. All fields are named, so
// that a new one does not compile until it is compared.
bool Step::operator==(const Step& other) const {
  const auto& [its_body, is_skipped] = other;
  return body == its_body && skipped == is_skipped;
}

bool Repeat::operator==(const Repeat& other) const {
  const auto& [its_times, its_steps] = other;
  return times == its_times && steps == its_steps;
}

bool Contour::operator==(const Contour& other) const {
  const auto& [its_x, its_y, its_lead_in, its_end, its_own, its_steps, its_plane] = other;
  return x == its_x && y == its_y && lead_in == its_lead_in && ends_ramped == its_end && own == its_own &&
         plane == its_plane && steps == its_steps;
}

}  // namespace hw::sequence
