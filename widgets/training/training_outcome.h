// Outcome of the panel Training.
#pragma once

#include <memory>

#include "engine/core/frf.h"
#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"
#include "engine/training/lesson_state.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/training/training_question.h"

namespace lathelier::training_panel {

using chatter_common::frfRole;

struct TrainingOutcome {
    TrainingQuestion question;                               ///< question of the request
    training::Scenario scenario;                             ///< scenario with the changes of the question
    std::shared_ptr<const training::Limits> limits;          ///< never null
    std::shared_ptr<const Frf> frf;                          ///< receptance of the modes
    std::shared_ptr<const stability::SimulationResult> cut;  ///< simulated cut of one second
    stability::OperatingPoint point;                         ///< operating point of the question, or its default
    training::LessonState state;                             ///< state evaluated by the tasks of a lesson
    std::vector<InputFile> inputs;                           ///< the response, if there is one
    Notes notes;                                             ///< of the response and the fit
    UsedValues used;                                         ///< assumed values
    bool synthetic = false;                                  ///< the response is marked as synthetic

    const stability::LobeResult& lobes() const
    {
        return question.relation == stability::SpeedRelation::Exact ? limits->exact : limits->published;
    }
};

/// Reads, fits modes, computes; thread-safe. Errors: those of readFrf(), fitModes(), findLobes(), simulate().
TrainingOutcome trainingOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The growth of the cut against 1; in teacher mode the point alone.
report::Answer answer(const TrainingOutcome& outcome, const Language& language = {});

/// Every view on paper, with the map of the growth. Throws Cancelled.
report::Document reportOf(const TrainingOutcome& outcome, const Language& language, const Progress& progress = {});

/// Where its spectrum ends.
double highestShown(const TrainingOutcome& outcome);

/// The growth over the chart's speeds and depths.
stability::RasterParameters rasterOf(const TrainingOutcome& outcome);

}  // namespace lathelier::training_panel
