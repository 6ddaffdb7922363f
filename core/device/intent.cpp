#include "core/device/intent.h"

namespace hw {

IntentBody::IntentBody(const IntentBody& other) = default;
IntentBody::IntentBody(IntentBody&& other) noexcept = default;
IntentBody& IntentBody::operator=(const IntentBody& other) = default;
IntentBody& IntentBody::operator=(IntentBody&& other) noexcept = default;
IntentBody::~IntentBody() = default;

intent::Closing* closing_of(IntentBody& body) {
  if (auto* i = std::get_if<intent::SetPower>(&body)) return &i->closing;
  if (auto* i = std::get_if<intent::SetParam>(&body)) return &i->closing;
  if (auto* i = std::get_if<intent::Act>(&body)) return &i->closing;
  return nullptr;
}

void asked_by(IntentBody& body, StoppedBy by) {
  std::visit(
      [by](auto& request) {
        if constexpr (requires { request.by; }) request.by = by;
      },
      body);
}

Intent::Intent(IntentId i, IntentBody b, Instant at) : id(i), body(std::move(b)), asked_at(at) {}

}  // namespace hw
