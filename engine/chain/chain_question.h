// Input files and options of the chain, from the scan of the worn part to that of its copy.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/value.h"
#include "engine/shop/shop_library.h"

namespace lathelier::chain {

/// Direction of cut in a picture rotated so that the feed points right.
enum class CutInPicture : std::uint8_t { Unknown, Down, Up };

/// "unknown", "down", "up", the keys of the task surface.
const std::vector<FieldChoice>& cutsInPicture();

/// Paths, empty if not given and not made from the shop; steps that need a missing file get StepState::Missing.
struct ChainQuestion {
    std::string scan;                      ///< of the worn part
    std::string out;                       ///< folder of the chain
    std::string machine;                   ///< SPINDLE.json
    std::string job;                       ///< JOB.json
    std::string setup;                     ///< SETUP.json of deflection
    std::string shop = shop::builtInName;  ///< makes those of the three that are not given: SHOP.json, the built-in
                                           ///< one by its name; empty: they are missing
    std::string copy;                      ///< scan of the copy
    std::string drawing;                   ///< SHAFT.json; empty: the recognised part is the drawing
    std::string confirmed_by;              ///< name of the person who confirmed the drawing
    std::string post = "fanuc_a";
    std::optional<double> tolerance_mm;      ///< of the copy's surface
    std::optional<double> tolerance_um;      ///< of the predicted diameter error
    std::string photograph_before;           ///< of the surface before
    std::string photograph_after;            ///< of the same surface after
    std::optional<double> photograph_z_mm;   ///< position on the part; none: diameter and speed unknown, no frequencies
    std::optional<double> photograph_mm_px;  ///< scale of both photographs; none: periods in pixels only
    std::optional<double> photograph_feed_deg;  ///< direction of feed in both, from right toward down; none: not known
    CutInPicture photograph_cut = CutInPicture::Unknown;  ///< direction of cut in both
    bool resume = false;                                  ///< reuse steps whose files and requests are unchanged
    std::string shop_text;                                ///< of a project, in place of the file: the text of SHOP.json
    Values recognition;                                   ///< parameters of the first step
    Values reading;                                       ///< values that files may leave unstated

    /// Whether the shop makes a set-up that is not given: beside a given job only where a shop was stated, since the
    /// deflection of somebody's job is not predicted with an assumed machine unasked.
    bool makesSetup() const { return job.empty() || shop != shop::builtInName || !shop_text.empty(); }
};

/// All except scan, shop_text, recognition and reading, which are separate arguments of the command line.
const std::vector<Field<ChainQuestion>>& fieldsOf(const ChainQuestion*);

/// Keys of the first step's parameters used by the chain: those of the robust method, what a person confirms, and what
/// the shaft states in title blocks.
const std::vector<std::string>& recognitionKeys();

/// Error outputIsInput: an input lies in the folder of the chain.
void refuseOverwriting(const ChainQuestion& question);

}  // namespace lathelier::chain
