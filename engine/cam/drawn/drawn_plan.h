// The outcome of a turning plan with what drawings of it need: path, drawing, stock and lobes of each section.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/cam/task/turn_task.h"
#include "engine/report/document.h"
#include "engine/stability/lobes.h"
#include "engine/stock/drawn_path.h"
#include "engine/task/stores.h"

namespace lathelier::cam {

/// One clamping, in the coordinates of its stock: z from the raw end of the bar, radius.
struct ClampingOutcome {
    stock::DrawnPath drawn;                  ///< drawn path of the program
    std::vector<double> travelled_mm;        ///< path length of the tool up to each corner
    double z_zero_mm = 0;                    ///< z = z_zero - Z of the program
    double part_zero_mm = 0;                 ///< z of the stock less z of the part in this clamping
    std::vector<double> drawing_z_mm;        ///< the part as drawn
    std::vector<double> drawing_x_mm;        ///< radius, one for each z
    std::optional<stock::StockResult> bare;  ///< the stock before anything is cut; none: the program has errors

    double length_mm() const { return travelled_mm.empty() ? 0 : travelled_mm.back(); }  ///< way of the tool
};

struct TurningOutcome : cam::TurnOutcome {
    std::vector<ClampingOutcome> clampings;  ///< one for each set-up of the plan
    /// Of the work when each section is cut, about its speed; null: no dynamics.
    std::vector<std::shared_ptr<const stability::LobeResult>> lobes;
};

/// cam::answerTurn() with what its views need. Thread-safe. Throws Cancelled.
TurningOutcome turningOutcome(const project::PanelState& state, Stores& stores, task::Sources& sources,
                              const Progress& progress);

/// Speed of the finish at a section by the cutting data of the job, 1/min.
double askedSpeed(const TurningPlan& plan, const SectionSpeed& section);

/// The number of a section of a clamping, or of what stays, by z of the part as drawn, in the stock of the clamping.
Interval inStock(const TurningOutcome& outcome, std::size_t setup, const Interval& z_mm);

}  // namespace lathelier::cam
