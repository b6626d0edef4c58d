#include "widgets/roundness/roundness_shown.h"

#include "engine/form/roundness/roundness_plots.h"
#include "engine/form/roundness/superimpose_report.h"
#include "widgets/core/language.h"

namespace lathelier::roundness_panel {

RoundnessShown showRoundness(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress)
{
    RoundnessShown shown{trajectory::answerRoundness(state, stores, sources, progress), {}, {}};
    shown.polar = plot::polarPicture(roundnessPolarPlot(shown.judged(), screenLanguage()));
    if (shown.superimposed)
        shown.laid =
            plot::polarPicture(superimposedPolarPlot(*shown.superimposed, shown.judged().circles.LSCI.radius_mm));
    return shown;
}

}  // namespace lathelier::roundness_panel
