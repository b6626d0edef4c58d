// What is known of the records before their sections are evaluated: places of signals, revolutions, segmentation along
// z.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/trajectory/revolutions.h"

namespace lathelier::trajectory {

/// A raw record made ready for sampling.
struct PreparedRecord {
    const io::ProbeRecord* record = nullptr;  ///< of the caller, who keeps it
    std::string path;                         ///< of the file, for messages
    FrameClock clock;                         ///< when each frame was sampled
    ChannelMap map;                           ///< which channel is which signal
    double channel_skew_s = 0;                ///< from one channel to the next within a frame
    Revolutions revolutions;                  ///< those found in the record
    UsedValues used;                          ///< sensitivity and skew, and who said them
};

/// Channel map, delays and revolutions of a record, with its notes. Errors carry `path`.
PreparedRecord prepare(const io::ProbeRecord& record, const std::string& path, const TrajectoryParameters& parameters,
                       Notes& notes);

/// The revolutions of one section.
struct RecordSegment {
    std::vector<Revolution> chosen;                          ///< regular ones, at most as many as asked for
    int found = 0;                                           ///< regular ones in the segment
    double z_mm = std::numeric_limits<double>::quiet_NaN();  ///< middle of the chosen ones; NaN: not known
};

/// How a record is cut along the workpiece.
struct Segmentation {
    double feed_mm_rev = 0;  ///< along the workpiece
    int sections = 1;        ///< number of segments of equal length
};

/// The segmentation asked for, or stated by the record itself ("feed_mm_rev" and "sections", with a note).
std::optional<Segmentation> segmentationOf(const io::ProbeRecord& record, const TrajectoryParameters& parameters,
                                           Notes& notes, UsedValues& used);

/// One segment: the first `revolutions` regular ones of the record.
RecordSegment wholeRecord(const PreparedRecord& prepared, const TrajectoryParameters& parameters);

/// Segments of equal length over all turns of the record. Error recordTooShort.
std::vector<RecordSegment> segmentRecord(const PreparedRecord& prepared, const TrajectoryParameters& parameters,
                                         const Segmentation& segmentation);

}  // namespace lathelier::trajectory
