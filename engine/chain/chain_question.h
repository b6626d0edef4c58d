// What the chain is asked: the files from the scan of the worn part to that of its copy, and the choices.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/value.h"

namespace lathelier::chain {

/// Of later points of a track, in a picture turned so that the feed points right.
enum class CutInPicture : std::uint8_t { Unknown, Down, Up };

/// "unknown", "down", "up", as the verb `surface` takes them.
const std::vector<FieldChoice>& cutsInPicture();

/// Paths; an empty one is not given, and the steps that need it are missing.
struct ChainQuestion {
    std::string scan;                           ///< of the worn part
    std::string out;                            ///< folder of the chain
    std::string machine;                        ///< SPINDLE.json
    std::string job;                            ///< JOB.json
    std::string setup;                          ///< SETUP.json of deflection
    std::string copy;                           ///< scan of the copy
    std::string drawing;                        ///< SHAFT.json; empty: the drawing is what was recognised
    std::string confirmed_by;                   ///< name of who answers for the drawing
    std::string post = "fanuc_a";               ///< control
    std::optional<double> tolerance_mm;         ///< of the copy's surface
    std::optional<double> tolerance_um;         ///< of the predicted diameter error
    std::string photograph_before;              ///< of the surface before
    std::string photograph_after;               ///< of the same surface after
    std::optional<double> photograph_z_mm;      ///< where on the part; none: no diameter and speed, so no frequencies
    std::optional<double> photograph_mm_px;     ///< scale of both photographs; none: periods in pixels only
    std::optional<double> photograph_feed_deg;  ///< direction of feed in both, from right toward down; none: not known
    CutInPicture photograph_cut = CutInPicture::Unknown;  ///< direction of cut in both
    bool resume = false;  ///< take over steps whose files and questions are as they were
    Values recognition;   ///< parameters of the first step
    Values reading;       ///< what files may leave open
};

/// All but the scan, recognition and reading, which the command line takes otherwise.
const std::vector<Field<ChainQuestion>>& fieldsOf(const ChainQuestion*);

/// Keys of the parameters of recognition that a chain takes: without those of the published method.
const std::vector<std::string>& recognitionKeys();

/// Error outputIsInput: an input lies in the folder of the chain.
void refuseOverwriting(const ChainQuestion& question);

}  // namespace lathelier::chain
