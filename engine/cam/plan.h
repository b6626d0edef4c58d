// A turning program from a part and a job: planned, written, read again and checked.
//
// The residual material of each tool follows from its nose curves before path planning (reach.h). Operations follow
// these curves (setup_plan.h), are tested on the current stock and written by a post (post/program_writer.h). The
// written text is then parsed and checked like any other program (check/turning_check.h); a program that gouges more
// than gougeLimit_mm or collides is refused.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/check/turning_check.h"
#include "engine/cam/drawn_features.h"
#include "engine/cam/post/post.h"
#include "engine/cam/section_speeds.h"
#include "engine/cam/setup_plan.h"

namespace lathelier::cam {

inline constexpr double mostPowerShare = 0.8;  ///< share of the power of the machine above which a note is given

enum class SetupChoice : std::uint8_t {
    Auto,  ///< two where one leaves more than rounded corners and two leave less
    One,   ///< as the job states it
    Two    ///< one from each end
};

/// How roughing and finish are written.
enum class CycleChoice : std::uint8_t {
    AsPost,  ///< as the post states it
    Moves,   ///< every pass as moves
    Cycles   ///< cycles of the control (G71, G70)
};

struct TurningParameters {
    SetupChoice setups = SetupChoice::Auto;
    stability::SpeedRelation relation = stability::SpeedRelation::Published;  ///< of lobes and speeds
    PartModel part_model = PartModel::Finished;                               ///< body for the speeds of finishing
    CycleChoice cycles = CycleChoice::AsPost;                                 ///< of roughing and finish
    bool optional_stops = false;                                              ///< a stop (M1) between tools
    bool work_offset = false;                                                 ///< the work offset (G54) is stated
    double tool_change_s = 3;
    std::vector<SkippedOperation> skipped;  ///< switched off
    std::vector<OperationStep> order;       ///< wanted order, see operation_order.h
    friend bool operator==(const TurningParameters&, const TurningParameters&) = default;
};

const std::vector<Field<TurningParameters>>& fieldsOf(const TurningParameters*);

/// Further inputs besides part and job.
struct TurningInputs {
    Post post;
    std::optional<receptance::SpindleReceptance> spindle;  ///< none: no speeds from dynamics
    std::vector<std::string> origin;                       ///< lines for the program's head: files and their hashes
    bool keeps_outlines = false;                           ///< CheckParameters::keeps_outlines
};

/// One operation of a written program.
struct PlannedOperation {
    OperationKind kind = OperationKind::Rough;
    int tool = 0;
    std::int64_t blocks = 0;      ///< of moves
    std::int64_t first_line = 0;  ///< in the text, from 1
    /// Of a finish in a cycle: lines of the contour, written with the roughing cycle; 0: none.
    std::int64_t contour_first_line = 0, contour_last_line = 0;
    double feed_length_mm = 0;           ///< of feed moves
    double time_s = 0;                   ///< feed and rapid moves
    double volume_cm3 = 0;               ///< volume removed
    double depth_mm = 0;                 ///< largest depth of cut, on radius
    std::optional<double> power_max_kW;  ///< at the cut, ± 25 %; none: the material is not known

    /// True if the line belongs to it; `next_line`: first line of the next operation.
    bool holds(std::int64_t line, std::int64_t next_line) const
    {
        return (line >= first_line && line < next_line) ||
               (contour_first_line > 0 && line >= contour_first_line && line <= contour_last_line);
    }
};

struct SetupPlan {
    std::string program;  ///< path of the written file; empty: not written
    std::string text;
    Clamping clamping;     ///< how the work is held
    double z_zero_mm = 0;  ///< of the program's Z0, from the clamping's free end
    std::vector<PlannedOperation> operations;
    std::vector<Operation> moves;           ///< the same, exact
    std::vector<Unreached> predicted;       ///< residual material predicted from the nose curves
    std::vector<RefusedOperation> refused;  ///< rest operations that would collide
    double time_s = 0;
    CheckResult check;
};

struct TurningPlan {
    TurningParameters parameters;
    Shaft part;  ///< as drawn
    Job job;     ///< tools completed from the library
    Job stated;  ///< as given, before completion from the library
    std::string post;
    std::vector<SetupPlan> setups;
    std::vector<RestInterval> rest;      ///< measured from the texts, z from the drawn free end
    std::vector<SectionSpeed> sections;  ///< of the finish, z from the drawn free end
    double left_max_mm = 0;              ///< largest residual
    std::vector<DrawnFeature> not_made;  ///< drawn, but made by no operation
    bool is_refused = false;             ///< a check found a gouge or a collision
    std::optional<Verdict> verdict;  ///< fail: residual material, a finding, a feature that is not made, or a section
                                     ///< without a stable speed
    Notes planning;                  ///< of planning alone
    Notes notes;                     ///< of planning and of the checks

    /// The check with the worst result among the clampings.
    const CheckResult& worstCheck() const;
};

/// Rest operations in which the check of the written program finds a fault are left out, and the rest is planned again.
/// Errors: those of job_rules.h; feedBeyondNose, noSetupPossible, orderImpossible, postCannot; those of receptanceOf().
/// Throws Cancelled.
TurningPlan planTurning(const Shaft& part, const Job& job, const TurningInputs& inputs,
                        const TurningParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::cam
