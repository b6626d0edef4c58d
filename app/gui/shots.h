// lathelier --shots DIR PROJECT: screenshots of the window and every panel, for the README and for looking at.
#pragma once

#include <QString>

#include "app/gui/main_window.h"

namespace lathelier {

/// Shows every panel under its question at 1280 × 800 and 1920 × 1080, waits for the results, and writes
/// window_<panel>_<size>.png, <panel>_<size>.png (and one for each of its further pages), verify.png, manual.png and
/// presenter_<panel>_1920x1080.png into `folder`. Returns 0; 1 when a panel has no result or a picture cannot be
/// written.
int takeShots(MainWindow& window, const QString& folder);

}  // namespace lathelier
