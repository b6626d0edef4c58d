// A scan between its reader and the caller: in the unit of the file, perhaps with points that are not finite.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include "engine/io/cloud/scan_reader.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/text/encoding.h"

namespace lathelier::io {

/// Of a loop over points, for each task of the machine.
inline constexpr std::size_t pointsPerTask = 1 << 16;

/// What a reader is given. Text formats read `text`, binary ones `bytes`.
struct ScanSource {
    std::string_view bytes;        ///< content of the file
    std::string_view text;         ///< the same in UTF-8; empty for binary formats
    std::string encoding;          ///< of `text`
    const ImportOptions& options;  ///< of the caller, who keeps them
    const Progress& progress;      ///< receives the progress; throws Cancelled when stopped
};

/// Where the points stand in the file, for errors about one of them. All views live as long as the source.
struct PointPlaces {
    std::int64_t firstLine = 0;  ///< text: the line of the first point, the others follow; 0 in a binary file
    std::int64_t firstByte = 0;  ///< binary: the byte of the first point
    std::int64_t stride = 0;     ///< binary: from one point to the next; 0 when they are not evenly spaced
    /// Where points are not one to a line or evenly spaced: the place of the first coordinate beyond `largest`.
    std::function<Values(double largest)> find = {};
};

/// What a reader gives: points in the unit of the file, normals of any length, everything as it stands there.
struct RawScan {
    Scan scan;        ///< coordinates in the unit of the file
    FileFacts facts;  ///< format, encoding, delimiter, decimal, columns, skipped, details by format
    Notes notes;      ///< what the reader had to assume or leave out
    std::optional<LengthScale> statedUnit;  ///< of the coordinates; none: the file states none
    PointPlaces places;                     ///< where the points stand in the file
    std::int64_t notFinite = 0;             ///< points that the reader itself has left out
    std::int64_t skippedCount = 0;          ///< all skipped rows, of which `facts.skipped` has the first ones
};

/// Leaves out points that are not finite and triangles without area, settles the unit, scales to mm, fills in what the
/// facts of all formats share. Errors: noPoints, coordinateTooLarge, unitUnknown.
ScanFile finishScan(RawScan raw, const std::string& path, const ImportOptions& options, const Progress& progress);

/// Error malformed (`byte`, `bytes` that follow) when more follows behind the last element of a binary file than a line
/// end and the filling of a disk's cluster.
void refuseMoreBytes(std::string_view bytes, std::size_t end);

}  // namespace lathelier::io
