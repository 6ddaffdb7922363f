#pragma once
// Writes every byte of every wire to a text file, with its time: `run --traffic`.
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "core/session/wire.h"

namespace hw::app {

class TrafficFile {
 public:
  static Result<std::shared_ptr<TrafficFile>> create(const std::string& path);
  /// Called (io thread) when writing fails.
  std::function<void(const Fault& why)> on_failure;
  ~TrafficFile();
  TrafficFile(const TrafficFile&) = delete;
  TrafficFile& operator=(const TrafficFile&) = delete;

  /// The same opener; each wire that it opens is recorded under its own number.
  static WireOpener tap(std::shared_ptr<TrafficFile> file, WireOpener inner);

  /// "    1.234567 2 > X\r": seconds, number of the wire, sent or received, bytes.
  void write(Instant at, int wire, char way, std::string_view bytes);
  void note(Instant at, int wire, std::string_view event);
  /// Closes it: whether everything written is in the file. The callback is not called from here on.
  Result<> finish();

 private:
  TrafficFile(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void put(std::string_view line);
  [[nodiscard]] Fault not_written() const;

  std::FILE* file_;  ///< null: finished

  std::string path_;
  int error_ = 0;  ///< errno of the first write that failed
  int wires_ = 0;
};

}  // namespace hw::app
