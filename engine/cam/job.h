// JOB.json: stock, clamping, tools and cutting data of a turned part. Units: mm, mm/rev, m/min, rpm, degrees. Every z
// from the free end of the finished part toward the chuck.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/tool.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cam {

/// The bar.
struct JobStock {
    double diameter_mm = 0;
    std::optional<double> length_mm;  ///< of the bar from its raw end; none: up to the chuck's face and into it
    double face_allowance_mm = 0;     ///< distance of the raw end beyond the finished one
    friend bool operator==(const JobStock&, const JobStock&) = default;
};

/// A corner of a region that tools must not enter.
struct KeepOutCorner {
    double z_mm = 0;  ///< negative beyond the free end
    double x_mm = 0;  ///< radius
    friend bool operator==(const KeepOutCorner&, const KeepOutCorner&) = default;
};

/// The tailstock at the free end.
struct JobTailstock {
    double centre_hole_mm = 5;            ///< largest diameter of the centre hole
    std::vector<KeepOutCorner> keep_out;  ///< its outline; everything between outline and axis. Empty: a 60° centre
    friend bool operator==(const JobTailstock&, const JobTailstock&) = default;
};

/// How the work is held.
struct JobSetup {
    double chuck_face_z_mm = 0;             ///< of chuck or jaws
    std::optional<double> jaw_diameter_mm;  ///< none: the chuck is unbounded radially
    std::optional<double> grip_length_mm;   ///< smallest length to be clamped; none: not checked
    std::optional<JobTailstock> tailstock;  ///< none: free end
    std::optional<double> power_kW;         ///< of the motor; none: not checked
    double efficiency = 0.8;                ///< from the motor to the cut; 0.8 is assumed
    friend bool operator==(const JobSetup&, const JobSetup&) = default;
};

enum class ToolUse : std::uint8_t { Rough, Finish, FinishBack, Groove, PartOff, CentreDrill, Thread };

/// "rough", "finish", "finish_back", "groove", "part_off", "centre_drill", "thread".
const char* key(ToolUse use);
Text nameOf(ToolUse use);

inline constexpr double usualBackMargin_deg = 2;  ///< JobTool::back_margin_deg where it is not stated

/// A tool and what the job does with it. Values not stated are taken from the library entries of the named insert and
/// holder (job_library.h). Kind and tip follow from the rest and are not stated in a job: settle().
struct JobTool : Tool {
    ToolUse use = ToolUse::Rough;                  ///< operation it is used for
    double back_margin_deg = usualBackMargin_deg;  ///< safety margin subtracted from the back angle in plans
    std::optional<double> feed_mm_rev;             ///< none: that of the cutting data
    friend bool operator==(const JobTool&, const JobTool&) = default;

    /// Sets kind and tip by use, width and hand: a centre drill, a threading insert (tip 8), a blade where a width is
    /// stated, else an insert (tip 3, from the chuck 4). Reading a job and withLibrary() do it.
    void settle();
    bool isDrill() const { return kind == ToolKind::Drill; }
    bool isThreader() const { return kind == ToolKind::ThreadingInsert; }
    bool isBlade() const { return kind == ToolKind::Blade; }
    bool isProfile() const { return kind == ToolKind::Insert; }
    double radius_mm() const;      ///< of the corners of an insert or a blade
    double backAngle_deg() const;  ///< κ' = 180° - κ - ε of an insert; 90 of a blade
};

/// Cutting data of roughing.
struct RoughCutting {
    double depth_mm = 0;  ///< largest radial depth of a pass
    double feed_mm_rev = 0;
    double cutting_speed_m_min = 0;  ///< v_c
    double allowance_mm = 0.3;       ///< finishing allowance, normal to the surface
    friend bool operator==(const RoughCutting&, const RoughCutting&) = default;
};

/// Cutting data of finishing.
struct FinishCutting {
    double feed_mm_rev = 0;
    double cutting_speed_m_min = 0;  ///< v_c
    friend bool operator==(const FinishCutting&, const FinishCutting&) = default;
};

struct JobCutting {
    std::string material;  ///< of the workpiece; empty: not stated
    RoughCutting rough;    ///< for roughing, facing and grooving
    FinishCutting finish;  ///< for finishing the contour
    friend bool operator==(const JobCutting&, const JobCutting&) = default;
};

/// Spindle speed of finishing up to a position.
struct SpeedSection {
    double to_z_mm = 0;  ///< end of the section; it starts at the end of the section before, or at the free end
    double rpm = 0;
    friend bool operator==(const SpeedSection&, const SpeedSection&) = default;
};

struct Job {
    std::string title;           ///< of the program; may be empty
    std::optional<Shaft> shaft;  ///< the part; none: stated elsewhere
    JobStock stock;
    JobSetup setup;
    std::vector<JobTool> tools;  ///< tool numbers are unique
    JobCutting cutting;
    std::optional<double> max_rpm;       ///< none: no limit is stated
    std::vector<SpeedSection> sections;  ///< ascending; empty: speeds are not stated
    bool part_off = false;               ///< the part is cut off at its end toward the chuck
    double edge_break_mm = 0;            ///< leg of the chamfer on sharp edges; 0: not broken
    friend bool operator==(const Job&, const Job&) = default;

    const JobTool* tool(int number) const;      ///< null: not found
    const JobTool* toolFor(ToolUse use) const;  ///< the first of this use; null: none
    /// The parting blade, else a grooving blade; null: none.
    const JobTool* partingBlade() const;
};

const std::vector<Field<JobStock>>& fieldsOf(const JobStock*);
const std::vector<Field<KeepOutCorner>>& fieldsOf(const KeepOutCorner*);
const std::vector<Field<JobTailstock>>& fieldsOf(const JobTailstock*);
const std::vector<Field<JobSetup>>& fieldsOf(const JobSetup*);
/// The fields of Tool among them. Former keys of a centre drill: width_mm (diameter_mm), edge_length_mm (reach_mm).
const std::vector<Field<JobTool>>& fieldsOf(const JobTool*);
const std::vector<Field<RoughCutting>>& fieldsOf(const RoughCutting*);
const std::vector<Field<FinishCutting>>& fieldsOf(const FinishCutting*);
const std::vector<Field<JobCutting>>& fieldsOf(const JobCutting*);
const std::vector<Field<SpeedSection>>& fieldsOf(const SpeedSection*);
/// All of it but the shaft, which is an item of its own.
const std::vector<Field<Job>>& fieldsOf(const Job*);

}  // namespace lathelier::cam
