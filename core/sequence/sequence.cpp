#include "core/sequence/sequence.h"

namespace hw::sequence {

Step::Body::Body(const Body& other) = default;
Step::Body::Body(Body&& other) noexcept = default;
Step::Body& Step::Body::operator=(const Body& other) = default;
Step::Body& Step::Body::operator=(Body&& other) noexcept = default;
Step::Body::~Body() = default;

// Not defaulted: clang 14 fails on an operator that is defaulted after its class.
bool Step::operator==(const Step& other) const { return body == other.body && skipped == other.skipped; }

bool Repeat::operator==(const Repeat& other) const { return times == other.times && steps == other.steps; }

bool Contour::operator==(const Contour& other) const {
  return x == other.x && y == other.y && lead_in == other.lead_in && ends_ramped == other.ends_ramped &&
         own == other.own && plane == other.plane && steps == other.steps;
}

}  // namespace hw::sequence
