// Outcome of the panel FRF.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/modal/response_study.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/frf/frf_question.h"

namespace lathelier::frf_panel {

using chatter_common::frfRole;
using chatter_common::FrfStore;
using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct FrfOutcome {
    receptance::ResponseStudy study;  ///< responses and model
    FrfQuestion question;             ///< question of the request
    io::MeasuredFrf places;           ///< nodes and directions of the measured response, without its lines
    std::string name;                 ///< name of the response, for its item
    std::vector<InputFile> inputs;    ///< files and items
    Notes notes;                      ///< of the files, the checks and the fit
    bool synthetic = false;           ///< a source is marked as synthetic

    /// Receptance of "Use this response"; null: the model is requested and there is none.
    FrfPtr handedOn() const;
};

/// Reads and computes; thread-safe. Errors: those of readFrf(), chosenResponse(), takeShaft(), fitModes(),
/// shaftReceptance().
FrfOutcome frfOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const FrfOutcome& outcome, const Language& language);

}  // namespace lathelier::frf_panel
