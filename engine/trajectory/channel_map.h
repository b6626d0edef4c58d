// Which channel of a record is which signal, and how its numbers become micrometres.
#pragma once

#include <array>

#include "engine/io/probe/probe_record.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// A displacement signal: which channel, and by what its values are multiplied.
struct ProbePlace {
    std::size_t channel = 0;  ///< place in ProbeRecord::channels
    double um_per_value = 1;  ///< with the sign of the map
};

struct ChannelMap {
    std::size_t reference = 0;           ///< channel of the marker, or of the encoder's angle
    bool is_angle = false;               ///< `reference` is an encoder's angle, not a marker
    std::array<ProbePlace, 4> probes{};  ///< in the order of Probe
    UsedValues used;                     ///< the sensitivity, when a channel in volts needed the one of all probes
};

/// What a probe in volts is taken for when nobody says.
inline constexpr double assumedSensitivity_um_per_V = 50;

/// Reads `parameters.channels`: entries "X3=1" for marker or angle, X3, Y3, Xp, Yp; a channel by its place (from 0) or
/// its name; "-X3=1" turns the sign. With the default map a record whose headings name all of them is mapped by name,
/// and a channel in degrees in the marker's place is an encoder's angle.
/// Values in volts are multiplied by the probe's sensitivity, else by that of all probes (not given:
/// assumedSensitivity_um_per_V, with the note sensitivityAssumed), those in µm and mm only brought to µm; without any
/// unit they are refused. Signals that stand still or are cut off at the ends of their range are noted. Errors:
/// valueNotUnderstood (`parameter` channels, `column` in it; probes, where one is named twice), channelsUnknown
/// (`signal`, `found`, `reason`), channelUnitMissing.
ChannelMap mapChannels(const io::ProbeRecord& record, const TrajectoryParameters& parameters, Notes& notes);

/// "X3", "Y3", "Xp", "Yp".
const char* name(Probe probe);

}  // namespace lathelier::trajectory
