// The .par file of an L-Graph recording (L-Card's recorder program): content and consistency checks. Layout determined
// from recordings of L-Graph I and II.
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
    int number = 0;  ///< physical channel number, from 1
    int gain = 1;    ///< gain of the converter's input: 1, 2, 4 or 8
};

struct LGraphHeader {
    LGraphVersion version = LGraphVersion::One;  ///< by the signature
    std::string device;                          ///< recorder, "L783"
    std::string recorded;                        ///< date and time as written
    std::vector<LGraphChannel> channels;         ///< the active ones, their numbers ascending
    std::int64_t frames = 0;                     ///< samples of each channel
    double total_s = 0;                          ///< duration of the recording, as stated
    double converter_kHz = 0;                    ///< stated rate of the converter
    double delay_ms = 0;                         ///< stated delay between samples
    double channel_kHz = 0;                      ///< frame rate of a channel
    std::int64_t segments = 1;                   ///< segments of the recording; 1 except for L-Graph II
};

/// True when `par` starts with the signature of an L-Graph.
bool hasLGraphSignature(std::string_view par);

/// "lgraph_1", "lgraph_2008", "lgraph_2".
std::string formatName(LGraphVersion version);

/// Parses the header. Errors, all with `byte`: formatUnknown (signature), truncated, recordContradicts (`check`,
/// `found`, `expected`): size of the .par, number of channels, active channels, frames, samples, gain, rate, total
/// time.
LGraphHeader readLGraphHeader(std::string_view par);

/// Throws recordContradicts with its location.
Error recordContradicts(Text check, std::int64_t byte, Value found, Value expected);

}  // namespace lathelier::io
