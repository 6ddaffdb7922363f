#pragma once
// Measures a wire from its traffic record: time and bytes of a question, and unsolicited bytes. Takes the
// entries of the record in order; any thread.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/link/traffic.h"

namespace hw {

struct TalkMeasure {
  int questions = 0;  ///< the console's own questions that were answered, and timed
  Duration least{}, median{}, slowest_of_hundred{};  ///< from the first byte sent to the last received
  int bytes_out = 0, bytes_in = 0;                   ///< of the median question and its reply
  int unanswered = 0;
  std::uint64_t received = 0;  ///< bytes
  std::uint64_t wrong = 0;     ///< bytes that no device on this wire sends
  int echoes = 0;              ///< replies that begin with the question itself
  int second_answers = 0;      ///< complete replies after the awaited one
};

class TalkRecorder {
 public:
  void record(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  [[nodiscard]] TalkMeasure measure() const;

  static constexpr std::size_t most_questions = 512;  ///< only the latest are kept

 private:
  struct Question {
    Duration round_trip{};
    int out = 0, in = 0;
  };
  void answered(Instant at, TrafficKind kind, std::string_view bytes);

  TalkMeasure counts_;
  std::vector<Question> questions_;
  std::size_t next_ = 0;  ///< place of the next, once there are most_questions
  std::string asked_, answer_;
  bool echoed_ = false;  ///< the latest text sent has come back
  Instant asked_at_{};
  bool poll_waits_ = false;  ///< the latest text sent was a question, not answered yet
};

}  // namespace hw
