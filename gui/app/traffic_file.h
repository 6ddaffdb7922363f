#pragma once
// Every byte of every wire in a text file, with its time: `run --traffic`.
#include <cstdio>
#include <memory>
#include <string>

#include "core/session/wire.h"

namespace hw::app {

class TrafficFile {
 public:
  static Result<std::shared_ptr<TrafficFile>> create(const std::string& path);
  ~TrafficFile();
  TrafficFile(const TrafficFile&) = delete;
  TrafficFile& operator=(const TrafficFile&) = delete;

  /// The same opener, with each wire that it opens written down under a number of its own.
  static WireOpener tap(std::shared_ptr<TrafficFile> file, WireOpener inner);

  /// "    1.234567 2 > X\r": seconds, number of the wire, sent or received, bytes.
  void write(Instant at, int wire, char way, std::string_view bytes);
  void note(Instant at, int wire, std::string_view event);

 private:
  explicit TrafficFile(std::FILE* file) : file_(file) {}
  std::FILE* file_;
  int wires_ = 0;
};

}  // namespace hw::app
