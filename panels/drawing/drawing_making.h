#pragma once
// Makes, on a worker, the results for a drawing: its conversion, program text, pieces, path and times.
#include "gui/shell/console.h"
#include "panels/drawing/drawing_job.h"

namespace hw::panels {

/// Calls with which a worker rehearses a drawing in pieces; null: it cannot.
struct RehearsalCalls {
  gui::Console::Together together;
  gui::Console::InPieces alone;
};

/// Makes all results of a drawing. Slow. `ordered` is the share of the chains that are in order, 0 to 1.
Result<DrawingJob::Made> make_all(const drawing::Drawing& drawing, const Catalog& catalog,
                                  const Language* language, const RehearsalCalls& rehearsing,
                                  const ConversionOptions& options, drawing::Point scale,
                                  std::atomic<float>& ordered);

}  // namespace hw::panels
