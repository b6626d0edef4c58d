#include "engine/trajectory/task/motion_report.h"

#include "engine/form/verify/form_verification.h"
#include "engine/report/quantity_table.h"
#include "engine/trajectory/channel_map.h"
#include "engine/trajectory/task/record_evaluation.h"
#include "engine/trajectory/trajectory_plots.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "engine/trajectory/trajectory_report.h"

namespace lathelier::trajectory {

report::Document motionReport(const report::Answer& answer, const TrajectoryResult& result,
                              const TrajectorySection& section, const Notes& notes, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Motion of spindle and tool");
    document.verification = {&form::formVerification()};
    report::Section motion{LT_TEXT("Engine", "Error motion (ISO 230-7)"), {answer}};
    for (std::size_t probe = 0; probe < section.error_motion.size(); ++probe)
        motion.blocks.emplace_back(
            report::quantityTable(std::string(name(static_cast<Probe>(probe))), section.error_motion[probe],
                                  {"synchronous_um", "synchronous_expanded_uncertainty_um", "asynchronous_um",
                                   "total_um", "total_expanded_uncertainty_um"}));
    motion.blocks.emplace_back(errorMotionPlot(section, result.workpiece_diameter_mm, Probe::X3, language));
    motion.blocks.emplace_back(notes);
    document.sections.push_back(std::move(motion));
    document.sections.push_back(
        {LT_TEXT("Engine", "Trajectories"), {trajectoryPlot(section, language), envelopePlot(section)}});
    document.sections.push_back(trajectoryMethod(result, language));
    addSectionSentence(document, result, section);
    return document;
}

}  // namespace lathelier::trajectory
