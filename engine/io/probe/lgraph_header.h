// The .par file of an L-Graph recording (L-Card's recorder program): what it says, checked against itself.
// Layout: found from recordings of L-Graph I and II.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace lathelier::io {

enum class LGraphVersion { One, After2008, Two };

/// One recorded channel, in the order of the samples of a frame.
struct LGraphChannel {
    int number = 0;  ///< physical, from 1
    int gain = 1;    ///< of the converter's input: 1, 2, 4 or 8
};

struct LGraphHeader {
    LGraphVersion version = LGraphVersion::One;  ///< as the signature tells
    std::string device;                          ///< "L783"
    std::string recorded;                        ///< date and time as written
    std::vector<LGraphChannel> channels;         ///< the active ones, their numbers ascending
    std::int64_t frames = 0;                     ///< samples of each channel
    double total_s = 0;                          ///< duration of the recording, as stated
    double converter_kHz = 0;                    ///< as stated
    double delay_ms = 0;                         ///< from sample to sample, as stated
    double channel_kHz = 0;                      ///< frames per millisecond
    std::int64_t segments = 1;                   ///< pieces that the recording consists of; 1 but for L-Graph II
};

/// True when `par` starts with the signature of an L-Graph.
bool hasLGraphSignature(std::string_view par);

/// "lgraph_1", "lgraph_2008", "lgraph_2".
std::string formatName(LGraphVersion version);

/// Takes the header apart. Errors, all with `byte`: formatUnknown (signature), truncated, recordContradicts (`check`,
/// `found`, `expected`): size of the .par, number of channels, active channels, frames, samples, gain, rate, total
/// time.
LGraphHeader readLGraphHeader(std::string_view par);

/// Error recordContradicts with the place.
Error recordContradicts(Text check, std::int64_t byte, Value found, Value expected);

}  // namespace lathelier::io
