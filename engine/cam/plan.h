// A turning program from a part and a job: planned, written, read again and checked.
//
// What each tool leaves is known from the curves of its nose before any path exists (reach.h); operations are laid on
// these curves (setup_plan.h), tried on the stock as it is, written by a post (post/program_writer.h). The written text
// is then read as any program is and checked (check/turning_check.h); a program that gouges more than gougeLimit_mm or
// meets anything is not given out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/check/turning_check.h"
#include "engine/cam/post/post.h"
#include "engine/cam/section_speeds.h"
#include "engine/cam/setup_plan.h"

namespace lathelier::cam {

inline constexpr double mostPowerShare = 0.8;  ///< of the machine's power, before it is remarked

enum class SetupChoice : std::uint8_t {
    Auto,  ///< two where one leaves more than rounded corners and two leave less
    One,   ///< as the job states it
    Two    ///< the part is turned round
};

/// How roughing and finish are written.
enum class CycleChoice : std::uint8_t {
    AsPost,  ///< as the post states it
    Moves,   ///< every pass as moves
    Cycles   ///< cycles of the control (G71, G70)
};

struct TurningParameters {
    SetupChoice setups = SetupChoice::Auto;                                   ///< how many clampings
    stability::SpeedRelation relation = stability::SpeedRelation::Published;  ///< of lobes and speeds
    PartModel part_model = PartModel::Finished;                               ///< body for the speeds of finishing
    CycleChoice cycles = CycleChoice::AsPost;                                 ///< of roughing and finish
    double tool_change_s = 3;                                                 ///< for the time
    std::vector<SkippedOperation> skipped;                                    ///< switched off
    std::vector<OperationStep> order;                                         ///< as operation_order.h takes it
    friend bool operator==(const TurningParameters&, const TurningParameters&) = default;
};

const std::vector<Field<TurningParameters>>& fieldsOf(const TurningParameters*);

/// What goes with part and job.
struct TurningInputs {
    Post post;                                             ///< of the control
    std::optional<receptance::SpindleReceptance> spindle;  ///< none: no speeds from dynamics
    std::vector<std::string> origin;                       ///< lines for the program's head: files and their hashes
    bool keeps_outlines = false;                           ///< CheckParameters::keeps_outlines
};

/// Of a program.
struct PlannedOperation {
    OperationKind kind = OperationKind::Rough;  ///< what for
    int tool = 0;                               ///< number
    std::int64_t blocks = 0;                    ///< of moves
    std::int64_t first_line = 0;                ///< in the text, from 1
    /// Of a finish in a cycle: lines of the contour, which stands with roughing; 0: none.
    std::int64_t contour_first_line = 0, contour_last_line = 0;
    double feed_length_mm = 0;           ///< of feed moves
    double time_s = 0;                   ///< feed and rapid moves
    double volume_cm3 = 0;               ///< taken off
    std::optional<double> power_max_kW;  ///< at the cut, ± 25 %; none: the material is not known

    /// Is the line one of its own, the next operation beginning at `next_line`?
    bool holds(std::int64_t line, std::int64_t next_line) const
    {
        return (line >= first_line && line < next_line) ||
               (contour_first_line > 0 && line >= contour_first_line && line <= contour_last_line);
    }
};

struct SetupPlan {
    std::string program;                       ///< path that it was written to; empty: nowhere
    std::string text;                          ///< of the program
    Clamping clamping;                         ///< how the work is held
    double z_zero_mm = 0;                      ///< of the program's Z0, from the clamping's free end
    std::vector<PlannedOperation> operations;  ///< in order
    std::vector<Operation> moves;              ///< the same, exact
    std::vector<Unreached> predicted;          ///< rest from the curves alone
    std::vector<RefusedOperation> refused;     ///< rest operations that were tried
    double time_s = 0;                         ///< with tool changes
    CheckResult check;                         ///< of the text
};

struct TurningPlan {
    TurningParameters parameters;        ///< as asked
    Shaft part;                          ///< as drawn
    Job job;                             ///< with what its tools take from the library
    Job stated;                          ///< as it was asked
    std::string post;                    ///< name
    std::vector<SetupPlan> setups;       ///< one or two
    std::vector<RestInterval> rest;      ///< measured from the texts, z from the drawn free end
    std::vector<SectionSpeed> sections;  ///< of the finish, z from the drawn free end
    double left_max_mm = 0;              ///< largest of `rest`, or what is left anywhere
    bool is_refused = false;             ///< a check found a gouge or a collision
    std::optional<Verdict> verdict;      ///< fail: something is left, found, or without a stable speed
    Notes planning;                      ///< remarks of the planning alone
    Notes notes;                         ///< those, and those of the checks

    /// The worst check of both.
    const CheckResult& worstCheck() const;
};

/// Errors: those of job_rules.h; feedBeyondNose, noSetupPossible, orderImpossible, postCannot; those of receptanceOf().
/// Throws Cancelled.
TurningPlan planTurning(const Shaft& part, const Job& job, const TurningInputs& inputs,
                        const TurningParameters& parameters = {}, const Progress& progress = {});

/// Error programRefused with the findings of all clampings as rows, where the plan is refused.
void throwIfRefused(const TurningPlan& plan);

}  // namespace lathelier::cam
