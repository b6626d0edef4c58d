// The task spc: does a characteristic of a series stay within its limits, is the process in control, where does it
// drift? The verb spc and the panel Series.
//
// The values are those of the archive, as they were when the parts were evaluated: nothing is computed anew.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/series/archived_state.h"
#include "engine/series/control_chart.h"
#include "engine/series/series_question.h"
#include "engine/series/small_picture.h"
#include "engine/task/task.h"

namespace lathelier::series {

inline constexpr std::size_t mostPictures = 30;

struct SeriesOutcome : task::Answered {
    SeriesQuestion question;
    std::string location;                                          ///< of the archive, without secrets
    std::vector<archive::ArchivedCharacteristic> characteristics;  ///< of the task, to choose from
    archive::ArchivedCharacteristic chosen;
    std::vector<archive::SeriesPoint> points;  ///< in the order of time; at least one
    ControlChart chart;
    std::size_t worst = 0;               ///< of the points: the one farthest out, or nearest to a limit
    std::vector<SmallPicture> pictures;  ///< of the latest parts that have one, in the order of time, on one scale
    std::optional<std::size_t> shown;    ///< of the points: the part in detail; none: it is not among them
    archive::Record part;                ///< the part in detail
    ArchivedState as_asked;              ///< its panel's state, and whether its files are what they were

    std::optional<Verdict> verdict() const;  ///< the worst of all; none: nothing was judged
};

/// Errors: those of opening and reading an archive, seriesEmpty, archiveEmpty, valueNotUnderstood without an archive.
/// Throws Cancelled.
SeriesOutcome answerSeries(const project::PanelState& state, Stores& stores, task::Sources& sources,
                           const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const SeriesOutcome>& outcome);

const task::Task& seriesTask();

}  // namespace lathelier::series
