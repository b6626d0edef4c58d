// What the worker of the panel "Training" computes.
#pragma once

#include <memory>

#include "engine/core/frf.h"
#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"
#include "engine/training/lesson_state.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/training/training_question.h"

namespace lathelier::training_panel {

using chatter_common::frfRole;

struct TrainingPicture {
    TrainingQuestion question;                               ///< as asked
    training::Scenario scenario;                             ///< with what the question changes of it
    std::shared_ptr<const training::Limits> limits;          ///< never null
    std::shared_ptr<const Frf> frf;                          ///< of the modes
    std::shared_ptr<const stability::SimulationResult> cut;  ///< a second of it
    stability::OperatingPoint point;                         ///< as asked, or its default
    training::LessonState state;                             ///< what the tasks of a lesson may ask for
    std::vector<InputFile> inputs;                           ///< the response, if there is one
    Notes notes;                                             ///< of the response and the fit
    UsedValues used;                                         ///< what was assumed
    bool synthetic = false;                                  ///< the response is marked as synthetic

    const stability::LobeResult& lobes() const
    {
        return question.relation == stability::SpeedRelation::Exact ? limits->exact : limits->published;
    }
};

/// Reads, fits modes, computes; safe from any thread. Errors: those of readFrf(), fitModes(), findLobes(), simulate().
TrainingPicture trainingPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The growth of the cut against 1; in teacher mode the point alone.
report::Answer answer(const TrainingPicture& picture, const Language& language = {});

/// Every view on paper, with the map of the growth. Throws Cancelled.
report::Document reportOf(const TrainingPicture& picture, const Language& language, const Progress& progress = {});

/// Where its spectrum ends.
double highestShown(const TrainingPicture& picture);

/// The growth over the chart's speeds and depths.
stability::RasterParameters rasterOf(const TrainingPicture& picture);

}  // namespace lathelier::training_panel
