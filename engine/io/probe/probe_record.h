// Signals of the probes around a spindle, as recorded.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/value.h"

namespace lathelier::io {

/// One channel of a record.
struct ProbeChannel {
    enum class Unit { Micrometre, Millimetre, Volt, Degree, Unknown };

    std::string name;            ///< heading of its column ("X3"), or "channel 3" of a recorder
    Unit unit = Unit::Unknown;   ///< unit of `values`
    int gain = 1;                ///< already applied to values in volts; kept for the facts
    std::vector<double> values;  ///< by frame; NaN where missing
};

/// A continuous recording of all channels. Channel c was sampled c · skew later than its frame.
struct ProbeRecord {
    std::string name;                                           ///< name of the file without folder
    std::vector<ProbeChannel> channels;                         ///< without a column of time
    std::vector<double> time_s;                                 ///< frame times; empty when only the rate is known
    double rate_hz = std::numeric_limits<double>::quiet_NaN();  ///< frame rate
    std::optional<double> channel_skew_s;                       ///< stated in the file, or 1 / converter rate
    std::string device;                                         ///< recorder, "L783"; empty when unknown
    std::string recorded;                                       ///< date and time as the file writes them
    /// Cutting data and other header entries ("rpm_nominal", "D_mm", "n_rev", "feed_mm_rev", "tool"…), as written;
    /// quoted in the report.
    Values header;

    std::size_t frames() const { return channels.empty() ? 0 : channels.front().values.size(); }
};

/// Mean displacements over the revolutions of one section, at uniform angles: the "averaged" shape of a record.
struct AveragedSection {
    int section = 0;                                         ///< as the file numbers it
    double z_mm = std::numeric_limits<double>::quiet_NaN();  ///< position along the workpiece; NaN: not stated
    std::vector<double> angle_deg;                           ///< spindle angle of each mean
    std::vector<double> X3_um, Y3_um, Xp_um, Yp_um;          ///< mean displacements of workpiece (mandrel) and tool
    std::vector<double> sX3_um, sY3_um, sXp_um, sYp_um;      ///< standard deviations over the revolutions; may be empty
};

struct AveragedRecord {
    std::string name;                       ///< name of the file without folder
    std::vector<AveragedSection> sections;  ///< in the order of the file
    Values header;                          ///< key=value lines of the file, as written
};

}  // namespace lathelier::io
