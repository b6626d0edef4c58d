#include "app/gui/panels.h"

#include "widgets/chain/chain_panel.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/correction/correction_panel.h"
#include "widgets/cylindricity/cylindricity_panel.h"
#include "widgets/deflection/deflection_panel.h"
#include "widgets/drawing/drawing_panel.h"
#include "widgets/frf/frf_panel.h"
#include "widgets/lobes/lobes_panel.h"
#include "widgets/longitudinal/longitudinal_panel.h"
#include "widgets/pass/pass_panel.h"
#include "widgets/program/program_panel.h"
#include "widgets/recognise/recognise_panel.h"
#include "widgets/roundness/roundness_panel.h"
#include "widgets/series/series_panel.h"
#include "widgets/shaft/shaft_panel.h"
#include "widgets/speed/speed_panel.h"
#include "widgets/spindle_machine/machine_panel.h"
#include "widgets/surface/surface_panel.h"
#include "widgets/tap/tap_panel.h"
#include "widgets/training/training_panel.h"
#include "widgets/trajectory/trajectory_panel.h"
#include "widgets/turning/turning_panel.h"

namespace lathelier {

/// In the order of the questions, and within one of its tabs.
const std::vector<PanelFacts>& panelTable()
{
    // In the order of the work: what is free in a question comes from earlier ones.
    static const std::vector<PanelFacts> table{recognise_panel::recognisePanelFacts(),
                                               drawing_panel::drawingPanelFacts(),
                                               shaft_panel::shaftPanelFacts(),
                                               machine_panel::machinePanelFacts(),
                                               tap_panel::tapPanelFacts(),
                                               frf_panel::frfPanelFacts(),
                                               lobes_panel::lobesPanelFacts(),
                                               pass_panel::passPanelFacts(),
                                               speed_panel::speedPanelFacts(),
                                               turning_panel::turningPanelFacts(),
                                               program_panel::programPanelFacts(),
                                               deflection_panel::deflectionPanelFacts(),
                                               correction_panel::correctionPanelFacts(),
                                               compare_panel::comparePanelFacts(),
                                               chain_panel::chainPanelFacts(),
                                               roundness_panel::roundnessPanelFacts(),
                                               trajectory_panel::trajectoryPanelFacts(),
                                               longitudinal_panel::longitudinalPanelFacts(),
                                               cylindricity_panel::cylindricityPanelFacts(),
                                               surface_panel::surfacePanelFacts(),
                                               training_panel::trainingPanelFacts(),
                                               series_panel::seriesPanelFacts()};
    return table;
}

}  // namespace lathelier
