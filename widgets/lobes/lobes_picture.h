// What the worker of the panel "Lobes" computes.
#pragma once

#include <memory>
#include <optional>

#include "engine/report/document.h"
#include "engine/stability/marks_item.h"
#include "engine/stability/stability_plots.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/core/files/stores.h"
#include "widgets/lobes/lobes_question.h"

namespace lathelier::lobes_panel {

using chatter_common::FrfStore;

using chatter_common::frfRole;

inline constexpr const char* marksRole = "marks";

struct LobesPicture {
    std::shared_ptr<const Frf> frf;                      ///< receptance of the point that is cut
    std::shared_ptr<const stability::LobeResult> lobes;  ///< never null
    std::optional<stability::SpeedResult> speed;         ///< none where nothing can be recommended
    std::optional<Error> no_speed;                       ///< why not
    stability::OperatingPoint point;                     ///< as asked, or its default
    stability::PointOfWork work;                         ///< what is known of it
    std::optional<stability::SurfaceMarks> marks;        ///< of a surface that was cut; none: none were sent
    LobesQuestion question;                              ///< as asked
    std::vector<InputFile> inputs;                       ///< the file, if there is one
    Notes notes;                                         ///< of the file and of the results
    bool synthetic = false;                              ///< the source is marked as synthetic
};

/// Reads and computes; safe from any thread. Errors: those of readFrf(), findLobes().
LobesPicture lobesPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The operating point against its limit, the recommended speed and the depth that is stable at every speed.
report::Answer answer(const LobesPicture& picture, const Language& language = {});

}  // namespace lathelier::lobes_panel
