#include "engine/io/cloud/raw_scan.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/row_reader.h"

namespace lathelier::io {
namespace {

struct Box {
    Eigen::Array3d min = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array3d max = Eigen::Array3d::Constant(-std::numeric_limits<double>::infinity());
    bool all_finite = true;
};

Box boxOf(const std::vector<Eigen::Vector3d>& points, const Progress& progress)
{
    return parallelReduce(
        points.size(), pointsPerTask, progress, Box{},
        [&points](std::size_t begin, std::size_t end) {
            Box box;
            double sum = 0;  // not finite as soon as one coordinate is not (0 times it is NaN)
            for (std::size_t i = begin; i < end; ++i) {
                const Eigen::Array3d p = points[i].array();
                box.min = box.min.min(p);
                box.max = box.max.max(p);
                sum += (p * 0.0).sum();
            }
            box.all_finite = sum == 0;
            return box;
        },
        [](const Box& a, const Box& b) {
            return Box{a.min.min(b.min), a.max.max(b.max), a.all_finite && b.all_finite};
        });
}

Values pointPlace(const PointPlaces& places, std::size_t point)
{
    const auto index = static_cast<std::int64_t>(point);
    if (places.first_line > 0) return {{"line", places.first_line + index}, {"column", std::int64_t{1}}};
    return {{"byte", places.first_byte + index * places.stride}};
}

/// Removes points that are not finite, and the triangles at them.
void dropNotFinite(RawScan& raw)
{
    Scan& scan = raw.scan;
    constexpr auto gone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> newIndex(scan.isMesh() ? scan.points_mm.size() : 0, gone);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scan.points_mm.size(); ++i) {
        if (!scan.points_mm[i].allFinite()) {
            ++raw.not_finite;
            ++raw.skipped_count;
            if (raw.facts.skipped.size() < listedRows)
                raw.facts.skipped.push_back(
                    {std::max<std::int64_t>(raw.places.first_line, 1) + static_cast<std::int64_t>(i),
                     LT_TEXT("Engine", "not a finite number")});
            continue;
        }
        if (scan.isMesh()) newIndex[i] = static_cast<std::uint32_t>(kept);
        scan.points_mm[kept] = scan.points_mm[i];
        if (scan.hasNormals()) scan.normals[kept] = scan.normals[i];
        ++kept;
    }
    scan.points_mm.resize(kept);
    if (scan.hasNormals()) scan.normals.resize(kept);
    for (auto& triangle : scan.triangles)
        for (std::uint32_t& corner : triangle) corner = newIndex[corner];
    std::erase_if(scan.triangles, [](const auto& t) { return t[0] == gone || t[1] == gone || t[2] == gone; });
}

/// Removes triangles with two equal corners.
void dropDegenerate(RawScan& raw)
{
    const std::size_t removed =
        std::erase_if(raw.scan.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    if (removed == 0) return;
    const auto count = static_cast<std::int64_t>(removed);
    set(raw.facts.details, "triangles_without_area", count);
    raw.notes.push_back({notes::facetsDegenerate, {{"count", count}}});
}

/// Normalises the normals; drops all when one has no direction, since incomplete normals are of no use.
void normalise(RawScan& raw, const Progress& progress)
{
    std::vector<Eigen::Vector3f>& normals = raw.scan.normals;
    if (normals.empty()) return;
    const std::int64_t unusable = parallelReduce(
        normals.size(), pointsPerTask, progress, std::int64_t{0},
        [&normals](std::size_t begin, std::size_t end) {
            std::int64_t count = 0;
            for (std::size_t i = begin; i < end; ++i) {
                const double length = normals[i].cast<double>().norm();
                if (length > 1e-6 && std::isfinite(length))
                    normals[i] = (normals[i].cast<double>() / length).cast<float>();
                else
                    ++count;
            }
            return count;
        },
        [](std::int64_t a, std::int64_t b) { return a + b; });
    if (unusable == 0) return;
    normals.clear();
    raw.notes.push_back({notes::normalsUnusable, {{"count", unusable}}});
}

void checkCoordinates(const RawScan& raw, const Box& box, double largest)
{
    if (box.min.minCoeff() >= -largest && box.max.maxCoeff() <= largest) return;
    const auto& points = raw.scan.points_mm;
    const auto isFar = [largest](const Eigen::Vector3d& p) { return p.cwiseAbs().maxCoeff() > largest; };
    const auto far = std::find_if(points.begin(), points.end(), isFar);
    Values values = raw.places.find ? raw.places.find(largest)
                                    : pointPlace(raw.places, static_cast<std::size_t>(far - points.begin()));
    set(values, "found", far->cwiseAbs().maxCoeff());
    set(values, "maximum", largest);
    throw Error(errors::coordinateTooLarge, values);
}

std::array<double, 3> toArray(const Eigen::Array3d& a)
{
    return {a.x(), a.y(), a.z()};
}

}  // namespace

void refuseMoreBytes(std::string_view bytes, std::size_t end)
{
    constexpr std::size_t largestFilling = 65536;
    const std::string_view rest = bytes.substr(end);
    const std::size_t more = rest.substr(0, largestFilling).find_first_not_of(std::string_view("\0\n\r \t\x1a", 6));
    if (rest.size() <= largestFilling && more == std::string_view::npos) return;
    throw Error(errors::malformed,
                {{"byte", static_cast<std::int64_t>(end + (rest.size() > largestFilling ? 0 : more))},
                 {"found", LT_TEXT("Engine", "further bytes behind the last element")},
                 {"bytes", static_cast<std::int64_t>(rest.size())},
                 {"expected", LT_TEXT("Engine", "the end of the file")}});
}

ScanFile finishScan(RawScan raw, const std::string& path, const ImportOptions& options, const Progress& progress)
{
    Box box = boxOf(raw.scan.points_mm, progress);
    if (!box.all_finite) {
        dropNotFinite(raw);
        box = boxOf(raw.scan.points_mm, progress);
    }
    if (raw.scan.points_mm.empty()) throw Error(errors::noPoints, {{"path", path}});
    dropDegenerate(raw);
    normalise(raw, progress);

    checkCoordinates(raw, box, largestCoordinate(raw.stated_unit, options));
    const LengthScale unit =
        chooseLengthUnit(raw.stated_unit, options, (box.max - box.min).maxCoeff(), raw.facts, raw.notes);
    if (unit.mm != 1) {
        auto& points = raw.scan.points_mm;
        parallelFor(points.size(), pointsPerTask, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) points[i] *= unit.mm;
        });
        box.min *= unit.mm;
        box.max *= unit.mm;
    }

    FileFacts& facts = raw.facts;
    facts.path = path;
    facts.min_mm = toArray(box.min);
    facts.max_mm = toArray(box.max);
    set(facts.details, "points", static_cast<std::int64_t>(raw.scan.points_mm.size()));
    if (raw.scan.isMesh()) set(facts.details, "triangles", static_cast<std::int64_t>(raw.scan.triangles.size()));
    set(facts.details, "normals", raw.scan.hasNormals());
    if (raw.skipped_count > static_cast<std::int64_t>(facts.skipped.size()))
        set(facts.details, "skipped_rows", raw.skipped_count);
    if (raw.not_finite > 0) raw.notes.push_back({notes::pointsNotFinite, {{"count", raw.not_finite}}});
    for (Note& note : raw.notes)
        if (!find(note.values, "path")) set(note.values, "path", path);
    progress.report(1);
    return {std::move(raw.scan), std::move(raw.facts), std::move(raw.notes)};
}

}  // namespace lathelier::io
