// Assignment of the channels of a record to signals, and conversion of their values to micrometres.
#pragma once

#include <array>

#include "engine/io/probe/probe_record.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Channel and scale factor of a displacement signal.
struct ProbePlace {
    std::size_t channel = 0;  ///< index into ProbeRecord::channels
    double um_per_value = 1;  ///< scale factor with the sign given in the map
};

struct ChannelMap {
    std::size_t reference = 0;           ///< channel of the marker, or of the encoder's angle
    bool is_angle = false;               ///< `reference` is an encoder's angle, not a marker
    std::array<ProbePlace, 4> probes{};  ///< in the order of Probe
    UsedValues used;                     ///< the sensitivity, when a channel in volts needed the one of all probes
};

/// Assumed sensitivity of a probe in volts when none is stated.
inline constexpr double assumedSensitivity_um_per_V = 50;

/// Reads `parameters.channels`: entries "X3=1" for marker or angle, X3, Y3, Xp, Yp; a channel by its index (from 0) or
/// its name; "-X3=1" inverts the sign. With the default map a record whose headings name all of them is mapped by name,
/// and a channel in degrees in the marker's place is an encoder's angle. Values in volts are multiplied by the probe's
/// sensitivity, else by that of all probes (not given: assumedSensitivity_um_per_V, with the note sensitivityAssumed),
/// those in µm and mm only brought to µm; without any unit they are refused. Constant and clipped signals are noted.
/// Errors: valueNotUnderstood (`parameter` channels, `column` in it; probes, where one is named twice), channelsUnknown
/// (`signal`, `found`, `reason`), channelUnitMissing.
ChannelMap mapChannels(const io::ProbeRecord& record, const TrajectoryParameters& parameters, Notes& notes);

/// "X3", "Y3", "Xp", "Yp".
const char* name(Probe probe);

}  // namespace lathelier::trajectory
