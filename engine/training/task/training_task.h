// The task training: a cut of a scenario, or of the shop's own machine, with its limits, simulated for a class that
// sees and hears it. The panel Training; no verb (simulate computes a cut on the command line).
#pragma once

#include <memory>

#include "engine/core/frf.h"
#include "engine/core/used_value.h"
#include "engine/report/document.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"
#include "engine/task/task.h"
#include "engine/training/lesson_state.h"
#include "engine/training/task/training_question.h"

namespace lathelier::training {

inline constexpr const char* responseRole = "frf";

struct TrainingOutcome : task::Answered {
    TrainingQuestion question;                               ///< question of the request
    Scenario scenario;                                       ///< scenario with the changes of the question
    std::shared_ptr<const Limits> limits;                    ///< never null
    std::shared_ptr<const Frf> frf;                          ///< receptance of the modes
    std::shared_ptr<const stability::SimulationResult> cut;  ///< simulated cut of one second
    stability::OperatingPoint point;                         ///< operating point of the question, or its default
    LessonState state;                                       ///< state evaluated by the tasks of a lesson
    UsedValues used;                                         ///< assumed values

    const stability::LobeResult& lobes() const
    {
        return question.relation == stability::SpeedRelation::Exact ? limits->exact : limits->published;
    }
};

/// Errors: those of the readers, modesOfPoint(), findLobes(), simulate(). Throws Cancelled.
TrainingOutcome answerTraining(const project::PanelState& state, Stores& stores, task::Sources& sources,
                               const Progress& progress);

/// The growth of the cut against 1; in teacher mode the point alone.
report::Answer answer(const TrainingOutcome& outcome, const Language& language = {});

task::Outcome outcomeOf(const std::shared_ptr<const TrainingOutcome>& outcome);

inline constexpr const char* soundExport = "wav";
inline constexpr const char* waveformExport = "csv";

const task::Task& trainingTask();

/// Where its spectrum ends.
double highestShown(const TrainingOutcome& outcome);

/// The growth over the chart's speeds and depths.
stability::RasterParameters rasterOf(const TrainingOutcome& outcome);

}  // namespace lathelier::training
