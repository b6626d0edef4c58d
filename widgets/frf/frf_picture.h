// What the worker of the panel "FRF" computes.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/modal/response_study.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/frf/frf_question.h"

namespace lathelier::frf_panel {

using chatter_common::frfRole;
using chatter_common::FrfStore;
using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct FrfPicture {
    receptance::ResponseStudy study;  ///< responses and model
    FrfQuestion question;             ///< as asked
    io::MeasuredFrf places;           ///< nodes and directions of the measured response, without its lines
    std::string name;                 ///< of the response, for the item it becomes
    std::vector<InputFile> inputs;    ///< files and items
    Notes notes;                      ///< of the files, the checks and the fit
    bool synthetic = false;           ///< a source is marked as synthetic

    /// What "Use this response" hands on: a receptance; null: the model is asked for and there is none.
    FrfPtr handedOn() const;
};

/// Reads and computes; safe from any thread. Errors: those of readFrf(), chosenResponse(), takeShaft(), fitModes(),
/// shaftReceptance().
FrfPicture frfPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const FrfPicture& picture, const Language& language);

}  // namespace lathelier::frf_panel
