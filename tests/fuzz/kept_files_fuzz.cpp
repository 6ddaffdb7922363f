// Any bytes where the console keeps profiles, last connections, unsaved texts and options of drawings, or as
// a text that somebody opens: read, or put aside with a sentence; the start goes on.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "core/session/autosave.h"
#include "core/session/kept_options.h"
#include "core/session/profile.h"
#include "core/session/recent.h"
#include "core/session/text_file.h"

namespace {

namespace fs = std::filesystem;

void require(bool held) {
  if (!held) std::abort();
}

/// A folder of this process, in memory where there is /dev/shm. The same name may be taken by each kind.
struct Place {
  fs::path folder = (fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                    ("hw-fuzz-" + std::to_string(::getpid()));
  hw::UserFolders folders = hw::UserFolders::below(folder);
  fs::path profile, recent, unsaved, drawing;

  Place() {
    profile = written([&] { require(hw::ProfileStore(folders).save("k", {}).has_value()); });
    recent =
        written([&] { require(hw::RecentConnections(folders).opened("vxm@emulator", "a").has_value()); });
    drawing = written([&] { require(hw::KeptOptionsOfDrawings(folders).save("k", {}).has_value()); });
    unsaved = written([&] { require(hw::Autosave(folders).keep("k", {{0, "I1M1", ""}}).has_value()); });
  }
  ~Place() { fs::remove_all(folder); }

  template <class Save>
  fs::path written(Save save) {
    fs::remove_all(folder);
    save();
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) return entry.path();
    std::abort();
  }
  void fill(const fs::path& file, const std::uint8_t* data, std::size_t size) const {
    fs::remove_all(folder);
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Place place;
  if (size == 0) return 0;
  const auto kind = data[0] % 5;
  ++data, --size;
  if (kind == 0) {
    place.fill(place.profile, data, size);
    const hw::ProfileStore store(place.folders);
    const auto profile = store.load("k");
    // A damaged file is put aside: the next start finds none. Names in other encodings may not be writable.
    if (!profile) require(store.load("k").has_value());
  } else if (kind == 1) {
    place.fill(place.recent, data, size);
    hw::RecentConnections recent(place.folders);
    if (!recent.load()) require(recent.list().empty() && recent.load().has_value());
    require(recent.list().size() <= hw::RecentConnections::capacity);
  } else if (kind == 2) {
    place.fill(place.unsaved, data, size);
    const hw::Autosave autosave(place.folders);
    if (!autosave.restore("k")) require(autosave.restore("k").has_value());
  } else if (kind == 4) {
    place.fill(place.drawing, data, size);
    const hw::KeptOptionsOfDrawings options(place.folders);
    const auto kept = options.load("k");
    if (!kept) require(options.load("k").has_value());
    // What was read is kept again as it is; names in other encodings may not be writable.
    if (!kept || !options.save("k", *kept)) return 0;
    const auto again = options.load("k");
    require(again.has_value() && *again == *kept);
  } else {
    const auto text = hw::decode_text({reinterpret_cast<const char*>(data), size}, "f");
    if (!text) require(!text.error().sentence().empty());
  }
  return 0;
}
