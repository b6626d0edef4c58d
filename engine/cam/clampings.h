// Division of a part into one or two clampings: turned stretch of each, grip of the second.
//
// The second clamping is planned by the same functions on the mirrored shaft. The part is split in the middle of the
// row with the largest radius; the two turned stretches overlap by splitOverlap_mm. The first clamping is the one that
// the job states, at the drawn free end. The second grips a cylinder finished in the first.
#pragma once

#include <optional>

#include "engine/cam/job.h"
#include "engine/cam/threads.h"

namespace lathelier::cam {

inline constexpr double splitOverlap_mm = 0.5;    ///< beyond the split, turned in both clampings
inline constexpr double jawsFromShoulder_mm = 5;  ///< smallest distance from the chuck face to the next shoulder
inline constexpr double mostFacedOff_mm = 5;      ///< longer ends are cut off by hand before the second clamping
inline constexpr double leastGripLength_mm = 15;  ///< used if the job states none

/// One clamping of a plan.
struct Clamping {
    bool is_mirrored = false;   ///< z counts from the other end of the part
    Shaft part;                 ///< turned stretch, z from the free end of this clamping; may be shorter than the part
    Job job;                    ///< with this clamping's chuck; parting off left to the plan
    double finished_to_mm = 0;  ///< z up to which this clamping finishes the drawing, from its free end
    bool parts_off = false;     ///< the work is cut off at its end
    double part_off_z_mm = 0;   ///< z of the end where it is cut off
    double work_length_mm = 0;  ///< of a second clamping: of the work before it, from the face finished first
    /// The same where the work is cut off to it by hand before; none: it need not be.
    std::optional<double> cut_off_to_mm{};
    std::vector<DrawnThread> threads;  ///< to be cut in this clamping, from its free end
};

/// The grip of the second clamping, z of the whole part from its drawn free end.
struct Grip {
    double from_mm = 0, to_mm = 0;  ///< gripped interval; the chuck face is at `to`
    bool has_tolerance = false;     ///< on its diameter: soft jaws
};

/// All of the part in the clamping of the job.
Clamping wholeClamping(const Shaft& part, const Job& job);

/// True if the drawing states limits of the diameter.
bool isToleranced(const ShaftSegment& row);

/// z of the split; none: the part has one row only.
std::optional<double> splitOf(const Shaft& part);

/// Rows up to z; a row that z divides keeps its shape.
Shaft cutAt(const Shaft& part, double z_mm);

/// The longest sufficient cylinder before the split, preferably without a tolerance. None: no cylinder is long enough;
/// `missing_mm` is then the smallest missing length.
std::optional<Grip> gripBefore(const Shaft& part, const Job& job, double split_mm, double& missing_mm);

/// Both clampings of a part that is split. What the first leaves beyond the part is faced off in the second up to
/// mostFacedOff_mm. A longer end, or one whose length is not stated, is cut off by hand at a stop before it: facing
/// takes a pass for each millimetre, and a saw or a blade does it in one cut.
std::vector<Clamping> twoClampings(const Shaft& part, const Job& job, double split_mm, const Grip& grip);

}  // namespace lathelier::cam
