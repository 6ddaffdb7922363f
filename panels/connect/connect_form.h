#pragma once
// Builds an address from its parts (model, transport, port, rate, id), and searches for devices when parts
// are unknown. Ids: `connect/form/...`, `connect/search/...`.
#include <map>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/session/transport_list.h"
#include "gui/shell/device_finder.h"
#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "panels/connect/usual_catalogs.h"

namespace hw::panels {

class ConnectForm {
 public:
  explicit ConnectForm(const UsualCatalogs& catalogs) : catalogs_(catalogs) {}
  /// Draws at ImGui's cursor. Returns the address to open when Open was pressed or a found device was chosen;
  /// else empty.
  std::string draw(gui::PageFrame& frame, float width);
  /// The address from the present parts: "MODEL@serial:/dev/ttyUSB0,baud=9600,id=01".
  [[nodiscard]] const std::string& address();
  /// The height of the form, logical.
  float height(gui::PageFrame& frame, float width);

 private:
  void make();
  void choose(int picked);
  using Transports = std::vector<const TransportInfo*>;
  [[nodiscard]] const Transports& transports() const;
  [[nodiscard]] const TransportInfo& transport() const;
  [[nodiscard]] const Catalog& catalog() const { return catalogs_.all()[static_cast<std::size_t>(model_)]; }
  [[nodiscard]] bool has_ids() const;
  bool draw_parts(gui::PageFrame& frame, float width);
  void draw_rate_or_base(gui::Ui& ui);
  void draw_id(gui::Ui& ui);
  [[nodiscard]] bool has_options() const { return catalog().can.window && !catalog().options.empty(); }
  void draw_options(gui::Ui& ui);
  [[nodiscard]] const std::string& guide();
  void draw_guide(gui::PageFrame& frame, float width);
  std::string draw_search(gui::PageFrame& frame, float width);
  void draw_search_fields(gui::Ui& ui, bool in_one_line);
  [[nodiscard]] std::string words_of(const gui::DeviceSearchState& state) const;

  bool made_ = false;
  const UsualCatalogs& catalogs_;
  int model_ = 0, baud_ = 0;
  std::map<std::string, int> chosen_;  ///< chosen values of Catalog::options, by key
  int transport_ = 0;                  ///< index among the transports of the controller
  std::string port_ = "/dev/ttyUSB0", id_ = "01", base_ = "0xF000", first_ = "00", last_ = "99";
  std::vector<Transports> transports_;  ///< by catalog
  std::vector<int> rates_;              ///< rates of the controllers that can share a line
  std::vector<std::string> rate_words_;
  std::vector<std::vector<std::string>> baud_words_;  ///< by catalog
  std::string made_address_, guide_;                  ///< members to keep their memory
  int guide_of_ = -1;
  int rate_ = 0;  ///< 0: all
  bool one_port_ = false, searched_ = false;
};

}  // namespace hw::panels
