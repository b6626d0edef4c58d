// One clamping or two: which stretch of the part each turns, and where the second one is gripped.
//
// The second program turns the part seen from its other end: the same functions on the mirrored shaft. The part is
// split in the middle of the row with the largest radius; both sides turn a little beyond. The first clamping is the
// one that the job states, at the drawn free end. The second grips a cylinder that is finished by then.
#pragma once

#include <optional>

#include "engine/cam/job.h"
#include "engine/cam/threads.h"

namespace lathelier::cam {

inline constexpr double splitOverlap_mm = 0.5;    ///< turned by both sides
inline constexpr double jawsFromShoulder_mm = 5;  ///< between the chuck's face and what stands before it
inline constexpr double leastGripLength_mm = 15;  ///< of the second clamping, where the job states none

/// One clamping of a plan.
struct Clamping {
    bool is_mirrored = false;          ///< seen from the other end
    Shaft part;                        ///< what is turned, from this clamping's free end; may end within the part
    Job job;                           ///< with this clamping's chuck; parting off left to the plan
    double finished_to_mm = 0;         ///< z up to which this clamping finishes the drawing, from its free end
    bool parts_off = false;            ///< the work is cut off at its end
    double part_off_z_mm = 0;          ///< z of the end where it is cut off
    std::vector<DrawnThread> threads;  ///< to be cut in this clamping, from its free end
};

/// The grip of the second clamping, z of the whole part from its drawn free end.
struct Grip {
    double from_mm = 0, to_mm = 0;  ///< gripped; the chuck's face stands at `to`
    bool has_tolerance = false;     ///< on its diameter: soft jaws
};

/// All of the part in the clamping of the job.
Clamping wholeClamping(const Shaft& part, const Job& job);

/// Does the drawing state limits of its diameter?
bool isToleranced(const ShaftSegment& row);

/// z of the split; none: the part has one row only.
std::optional<double> splitOf(const Shaft& part);

/// Rows up to z; a row that z divides keeps its shape.
Shaft cutAt(const Shaft& part, double z_mm);

/// A cylinder before the split, long enough, without a tolerance where there is a choice, the longest of those. None:
/// there is none; `missing_mm` then says how much the best one lacks.
std::optional<Grip> gripBefore(const Shaft& part, const Job& job, double split_mm, double& missing_mm);

/// Both clampings of a part that is split.
std::vector<Clamping> twoClampings(const Shaft& part, const Job& job, double split_mm, const Grip& grip);

}  // namespace lathelier::cam
