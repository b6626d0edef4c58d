// Outcome of the panel Lobes.
#pragma once

#include <memory>
#include <optional>

#include "engine/report/document.h"
#include "engine/stability/marks_item.h"
#include "engine/stability/stability_plots.h"
#include "engine/task/stores.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/lobes/lobes_question.h"

namespace lathelier::lobes_panel {

using chatter_common::FrfStore;

using chatter_common::frfRole;

inline constexpr const char* marksRole = "marks";

struct LobesOutcome {
    std::shared_ptr<const Frf> frf;                      ///< receptance of the cutting point
    std::shared_ptr<const stability::LobeResult> lobes;  ///< never null
    std::optional<stability::SpeedResult> speed;         ///< recommended speed; none: see `no_speed`
    std::optional<Error> no_speed;                       ///< reason for no recommendation
    stability::OperatingPoint point;                     ///< operating point of the question, or its default
    stability::PointStability work;                      ///< stability of the operating point
    std::optional<stability::SurfaceMarks> marks;        ///< chatter marks of a cut surface; none: not sent
    LobesQuestion question;                              ///< question of the request
    std::vector<InputFile> inputs;                       ///< the file, if there is one
    Notes notes;                                         ///< of the file and of the results
    bool synthetic = false;                              ///< the source is marked as synthetic
};

/// Reads and computes; thread-safe. Errors: those of readFrf(), findLobes().
LobesOutcome lobesOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The operating point against its limit, the recommended speed and the depth that is stable at every speed.
report::Answer answer(const LobesOutcome& outcome, const Language& language = {});

}  // namespace lathelier::lobes_panel
