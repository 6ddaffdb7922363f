#include "panels/blocks/block_work.h"

#include <utility>

#include "core/device/language.h"
#include "gui/model/tab.h"
#include "gui/surface/ui.h"

namespace hw::panels {

using namespace gui;
void BlockWork::follow(Frame& f, const sequence::Editor& editor) {
  wanted_ = editor.version();
  if (up_to_date() || *under_way_ > 0) return;
  Desk& desk = f.tab.desk();
  const Language* language = desk.programs.language();
  if (!language) {
    WrittenBlocks none;
    none.version = wanted_;
    none.problem = "Blocks cannot be written in the language of this controller.";
    written_ = std::make_shared<const WrittenBlocks>(std::move(none));
    return;
  }
  if (!catalog_) catalog_ = std::make_shared<const Catalog>(f.catalog);
  ++*under_way_;
  desk.work.worker().run(
      [language, catalog = catalog_, sequence = editor.shared(), version = wanted_] {
        WrittenBlocks made = write_blocks(*language, *sequence, *catalog);
        made.version = version;
        return made;
      },
      [this, under_way = under_way_.get()](WrittenBlocks made) {
        --*under_way;
        written_ = std::make_shared<const WrittenBlocks>(std::move(made));
      },
      under_way_);
  f.ui.wake_in(0);
}

std::string_view BlockWork::why_none(const sequence::Editor& editor) const {
  if (editor.sequence().steps.empty()) return "There are no blocks yet.";
  if (!up_to_date()) return "Their text is being written.";
  return written_->problem;
}

}  // namespace hw::panels
