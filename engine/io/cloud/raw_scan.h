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

/// Points per task of a parallel loop.
inline constexpr std::size_t pointsPerTask = 1 << 16;

/// Input of a reader. Text formats read `text`, binary ones `bytes`.
struct ScanSource {
    std::string_view bytes;        ///< content of the file
    std::string_view text;         ///< the same in UTF-8; empty for binary formats
    std::string encoding;          ///< encoding of `text`
    const ImportOptions& options;  ///< owned by the caller
    const Progress& progress;      ///< receives the progress; throws Cancelled when stopped
};

/// Location of the points in the file, for errors about one of them. All views live as long as the source.
struct PointPlaces {
    std::int64_t first_line = 0;  ///< text: the line of the first point, the others follow; 0 in a binary file
    std::int64_t first_byte = 0;  ///< binary: the byte of the first point
    std::int64_t stride = 0;      ///< binary: from one point to the next; 0 when they are not evenly spaced
    /// For points not one to a line or evenly spaced: the place of the first coordinate beyond `largest`.
    std::function<Values(double largest)> find = {};
};

/// Output of a reader: points in the unit of the file, normals of any length.
struct RawScan {
    Scan scan;        ///< coordinates in the unit of the file
    FileFacts facts;  ///< format, encoding, delimiter, decimal, columns, skipped, details by format
    Notes notes;      ///< assumptions and omissions of the reader
    std::optional<LengthScale> stated_unit;  ///< unit of the coordinates; none: not stated
    PointPlaces places;                      ///< where the points stand in the file
    std::int64_t not_finite = 0;             ///< number of points skipped by the reader
    std::int64_t skipped_count = 0;          ///< all skipped rows, of which `facts.skipped` has the first ones
};

/// Removes non-finite points and degenerate triangles, determines the unit, scales to mm, fills in the facts common to
/// all formats. Errors: noPoints, coordinateTooLarge, unitUnknown.
ScanFile finishScan(RawScan raw, const std::string& path, const ImportOptions& options, const Progress& progress);

/// Error malformed (`byte`, `bytes` that follow) when more follows behind the last element of a binary file than a line
/// end and zero padding of a disk cluster.
void refuseMoreBytes(std::string_view bytes, std::size_t end);

}  // namespace lathelier::io
