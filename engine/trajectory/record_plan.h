// Preparation of the records before the sections are evaluated: channel map, revolutions, segmentation along z.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/trajectory/revolutions.h"

namespace lathelier::trajectory {

/// A raw record prepared for sampling.
struct PreparedRecord {
    const io::ProbeRecord* record = nullptr;  ///< of the caller, who keeps it
    std::string path;                         ///< of the file, for messages
    FrameClock clock;                         ///< when each frame was sampled
    ChannelMap map;                           ///< which channel is which signal
    double channel_skew_s = 0;                ///< from one channel to the next within a frame
    Revolutions revolutions;                  ///< those found in the record
    UsedValues used;                          ///< sensitivity and skew with their origin
};

/// Channel map, delays and revolutions of a record, with its notes. Errors carry `path`.
PreparedRecord prepare(const io::ProbeRecord& record, const std::string& path, const TrajectoryParameters& parameters,
                       Notes& notes);

/// The revolutions of one section.
struct RecordSegment {
    std::vector<Revolution> chosen;  ///< the regular revolutions used, at most the number requested
    int found = 0;                   ///< number of regular revolutions in the segment
    double z_mm = std::numeric_limits<double>::quiet_NaN();  ///< middle of the used revolutions; NaN: unknown
};

/// Segmentation of a record along the workpiece.
struct Segmentation {
    double feed_mm_rev = 0;  ///< axial feed per revolution
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
