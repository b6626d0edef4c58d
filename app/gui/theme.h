// The look of the program: one style and two palettes, light and dark, following the system.
#pragma once

class QApplication;

namespace lathelier {

/// Takes Fusion with our palette; dark when the system's palette or the desktop's colour scheme is dark.
void applyTheme(QApplication& application);

}  // namespace lathelier
