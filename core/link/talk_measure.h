#pragma once
// What the record of a wire tells about the wire itself: how long a question takes, how many bytes it costs,
// and what came that nobody had asked for. Fed with the entries of the record in their order; any thread.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/link/traffic.h"

namespace hw {

struct TalkMeasure {
  int questions = 0;  ///< of the console's own, that were answered: of these are the times
  Duration least{}, median{}, slowest_of_hundred{};  ///< from the first byte out to the last one back
  int bytes_out = 0, bytes_in = 0;                   ///< of the median question, and of its answer
  int unanswered = 0;
  std::uint64_t received = 0;  ///< bytes
  std::uint64_t wrong = 0;     ///< of them: nothing on this wire says such a thing
  int echoes = 0;              ///< answers that begin with the question itself
  int second_answers = 0;      ///< whole answers behind the one that was waited for
};

class TalkRecorder {
 public:
  void hear(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  [[nodiscard]] TalkMeasure measure() const;

  static constexpr std::size_t most_questions = 512;  ///< the latest

 private:
  struct Question {
    Duration round_trip{};
    int out = 0, in = 0;
  };
  void answered(Instant at, TrafficKind kind, std::string_view bytes);

  TalkMeasure counts_;
  std::vector<Question> questions_;
  std::size_t next_ = 0;  ///< where the next one goes, once there are most_questions
  std::string asked_, answer_;
  Instant asked_at_{};
  bool poll_waits_ = false;  ///< the latest that went out was a question, and nothing has come yet
};

}  // namespace hw
