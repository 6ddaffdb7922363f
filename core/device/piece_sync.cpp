#include "core/device/piece_sync.h"

#include <algorithm>

namespace hw {

std::vector<std::shared_ptr<PieceSeat>> PieceSync::seats(std::size_t members) {
  const auto sync = std::make_shared<PieceSync>();
  sync->members_.resize(members);
  std::vector<std::shared_ptr<PieceSeat>> all;
  for (std::size_t i = 0; i < members; ++i) all.push_back(std::make_shared<PieceSeat>(sync, i));
  return all;
}

void PieceSync::wake_all() const {
  for (const Member& member : members_)
    if (member.wake) member.wake->notify();
}

bool PieceSync::all_have_done(std::size_t acts) const {
  return std::all_of(members_.begin(), members_.end(),
                     [acts](const Member& m) { return m.done && *m.done >= acts; });
}

void PieceSync::none_is_ready() {
  for (Member& member : members_) member.ready = false;
}

PieceSeat::~PieceSeat() {
  if (!finished_) sync_->ended_ = true;
}

void PieceSeat::leave() {
  me().wake = nullptr;
  if (!finished_ && !sync_->ended_.exchange(true)) sync_->wake_all();
}

void PieceSeat::has_done(std::size_t acts) {
  if (me().done == acts) return;  // already reported: wake no other controller twice
  me().done = acts;
  if (sync_->all_have_done(acts)) sync_->wake_all();
}

bool PieceSeat::may_begin(std::size_t act) {
  if (sync_->ended_) return false;
  if (act < sync_->begun_) return true;
  if (is_held() || !sync_->all_have_done(act)) return false;
  me().ready = true;
  const auto& all = sync_->members_;
  if (!std::all_of(all.begin(), all.end(), [](const PieceSync::Member& m) { return m.ready; })) return false;
  sync_->begun_ = act + 1;
  sync_->none_is_ready();
  sync_->wake_all();
  return true;
}

bool PieceSeat::waits_ready() const { return sync_->members_[place_].ready && !sync_->ended_; }

void PieceSeat::hold() {
  sync_->none_is_ready();
  for (PieceSync::Member& member : sync_->members_) member.held = true;
}

void PieceSeat::go_on() {
  me().held = false;
  if (!is_held()) sync_->wake_all();
}

bool PieceSeat::is_held() const {
  return std::any_of(sync_->members_.begin(), sync_->members_.end(),
                     [](const PieceSync::Member& m) { return m.held; });
}

bool PieceSeat::rests() const { return is_held() && sync_->all_have_done(sync_->begun_); }

}  // namespace hw
