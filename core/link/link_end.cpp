// The end of a link for one of its stations and for all.
#include "core/link/link.h"
#include "core/link/link_log.h"
#include "core/link/pending.h"
#include "core/link/station.h"

namespace hw {

void Link::leave(Station& station, const Fault& why, Leaving leaving) {
  std::erase(stations_, &station);
  if (leaving == Leaving::given_up && stations_.empty() && stream_) stream_->discard_unsent();
  if (last_sender_ == &station) last_sender_ = nullptr;
  const Fault lost(FaultKind::lost, why.what, why.done, why.advice);
  drop_waiting(station, lost);
  left_outstanding_.add(station.outstanding_);
  if (!in_flight_ || &in_flight_->station != &station) return start_next();
  deadline_.disarm();
  if (window_) window_->abandon();
  link_log().debug("{}\"{}\" was on the wire and is given up: {}", OfDevice{station.address},
                   log::Bytes{in_flight_->transaction.bytes}, why.what);
  left_outstanding_.add(in_flight_->transaction.reply_kind, scheduler_.now());  // its reply may still come
  end(*std::exchange(in_flight_, nullptr), fail(lost));
  settle_until_ = scheduler_.now() + settle_time;
  start_next();
}

void Link::stream_closed(const Fault& why) {
  const auto keep = shared_from_this();
  stream_->listen(nullptr);
  // A closed port must be free for the next attempt; the stream is not destroyed inside its own call.
  asio::post(scheduler_.executor(), [gone = std::shared_ptr<Stream>(std::move(stream_))] {});
  settled_.disarm();
  unfinished_.disarm();
  close_all(why);
}

void Link::window_closed(const Fault& why) {
  const auto keep = shared_from_this();
  window_->listen(nullptr);
  asio::post(scheduler_.executor(), [gone = std::exchange(window_, nullptr)] {});
  close_all(why);
}

void Link::interrupted(std::uint8_t vector) {
  for (std::size_t i = 0; i < stations_.size(); ++i)
    if (stations_[i]->interrupted) stations_[i]->interrupted(vector);
}

WireShare Link::share() const {
  return stream_ ? stream_->share() : window_ ? window_->share() : WireShare();
}

// As if the peer had closed it: the next user opens the wire again.
void Link::give_up_soon(Fault why) {
  asio::post(scheduler_.executor(), [self = shared_from_this(), why = std::move(why)] {
    if (self->stream_) self->stream_closed(why);
    if (self->window_) self->window_closed(why);
  });
}

void Link::close_all(const Fault& why) {
  link_log().debug("the wire is closed, devices on it: {}: {}", station_count(), why.sentence());
  while (!stations_.empty()) {
    Station* station = stations_.back();
    station->give_up(why);
    if (station->closed) station->closed(why);
  }
}

}  // namespace hw
