// STL files: ascii with one or several solids, and binary.
#include "engine/io/cloud/stl_reader.h"

#include <array>
#include <cmath>
#include <cstring>

#include "engine/io/cloud/raw_scan.h"
#include "engine/io/cloud/vertex_welder.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number_cell.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t headerBytes = 84;
constexpr std::size_t facetBytes = 50;

/// Adds triangles; one with a corner that is not finite is left out.
class TriangleSink {
public:
    explicit TriangleSink(RawScan& raw) : raw_(raw), welder_(raw.scan.points_mm) {}

    void add(const std::array<Eigen::Vector3d, 3>& corners, std::int64_t place)
    {
        for (const Eigen::Vector3d& corner : corners)
            if (!corner.allFinite()) {
                ++raw_.skipped_count;
                ++raw_.not_finite;
                if (raw_.facts.skipped.size() < 100)
                    raw_.facts.skipped.push_back({place, LT_TEXT("Engine", "not a finite number")});
                return;
            }
        raw_.scan.triangles.push_back(
            {welder_.indexOf(corners[0]), welder_.indexOf(corners[1]), welder_.indexOf(corners[2])});
    }

private:
    RawScan& raw_;
    VertexWelder welder_;
};

class AsciiStl {
public:
    AsciiStl(const ScanSource& source, RawScan& raw)
        : text_(source.text), lines_(source.text), numbers_(source), progress_(source.progress), raw_(raw), sink_(raw)
    {
    }

    void read()
    {
        std::int64_t solids = 0;
        std::int64_t facets = 0;
        bool inside = false;
        while (nextLine()) {
            if (is(0, "solid")) {
                if (inside) throw unexpected(0, LT_TEXT("Engine", "facet or endsolid"));
                inside = true;
                ++solids;
                if (!raw_.stated_unit) raw_.stated_unit = statedUnit(lines_.line());
            } else if (is(0, "endsolid") && inside) {
                inside = false;
            } else if (is(0, "facet") && inside) {
                readFacet();
                if ((++facets & 0x3FFF) == 0) progress_.check();
            } else {
                throw unexpected(0, inside ? LT_TEXT("Engine", "facet or endsolid") : LT_TEXT("Engine", "solid"));
            }
        }
        if (inside) throw malformedEnd(lines_, LT_TEXT("Engine", "endsolid"));
        set(raw_.facts.details, "solids", solids);
        raw_.facts.rows = facets;
        raw_.facts.decimal = numbers_.decimalName();
        raw_.places.find = [text = text_, decimal = numbers_.decimal()](double largest) {
            return placeOfLarge(text, "vertex", decimal, largest);
        };
    }

private:
    bool nextLine()
    {
        do {
            if (!lines_.next()) return false;
            splitWords(lines_.line(), words_);
        } while (words_.empty());
        return true;
    }

    bool is(std::size_t i, std::string_view word) const { return i < words_.size() && lowerCase(words_[i]) == word; }

    Error unexpected(std::size_t i, Text expected) const
    {
        const std::string_view line = lines_.line();
        return malformed(lines_.number(), line, i < words_.size() ? words_[i] : line.substr(line.size()), expected);
    }

    void expectLine(std::string_view first, std::string_view second, Text expected)
    {
        if (!nextLine()) throw malformedEnd(lines_, expected);
        if (!is(0, first) || (!second.empty() && !is(1, second))) throw unexpected(is(0, first) ? 1 : 0, expected);
    }

    void readFacet()
    {
        const std::int64_t line = lines_.number();
        expectLine("outer", "loop", LT_TEXT("Engine", "outer loop"));
        std::array<Eigen::Vector3d, 3> corners;
        for (Eigen::Vector3d& corner : corners) {
            expectLine("vertex", {}, LT_TEXT("Engine", "vertex"));
            for (std::size_t k = 0; k < 3; ++k) {
                if (k + 1 >= words_.size()) throw unexpected(k + 1, LT_TEXT("Engine", "a number"));
                corner[static_cast<int>(k)] = numbers_.read(lines_.number(), lines_.line(), words_[k + 1]);
            }
            if (words_.size() > 4) throw unexpected(4, LT_TEXT("Engine", "the end of the line"));
        }
        expectLine("endloop", {}, LT_TEXT("Engine", "endloop"));
        expectLine("endfacet", {}, LT_TEXT("Engine", "endfacet"));
        sink_.add(corners, line);
        if (raw_.places.first_line == 0) raw_.places.first_line = line;
    }

    std::string_view text_;
    Lines lines_;
    NumberCells numbers_;
    const Progress& progress_;
    RawScan& raw_;
    TriangleSink sink_;
    std::vector<std::string_view> words_;
};

std::array<float, 9> cornersOf(std::string_view bytes, std::size_t facet)
{
    std::array<float, 9> values{};
    std::memcpy(values.data(), bytes.data() + headerBytes + facet * facetBytes + 12, sizeof(values));
    return values;
}

/// The byte of the first coordinate beyond `largest`.
Values placeOfLargeCorner(std::string_view bytes, std::size_t facets, double largest)
{
    for (std::size_t i = 0; i < facets; ++i) {
        const std::array<float, 9> values = cornersOf(bytes, i);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (std::isfinite(values[k]) && std::abs(static_cast<double>(values[k])) > largest)
                return {{"byte", static_cast<std::int64_t>(headerBytes + i * facetBytes + 12 + 4 * k)}};
    }
    return {{"byte", static_cast<std::int64_t>(headerBytes)}};
}

}  // namespace

RawScan readAsciiStl(const ScanSource& source)
{
    RawScan raw;
    raw.facts.format = "stl_ascii";
    raw.facts.encoding = source.encoding;
    raw.facts.delimiter = "space";
    AsciiStl(source, raw).read();
    return raw;
}

RawScan readBinaryStl(const ScanSource& source)
{
    const std::string_view bytes = source.bytes;
    RawScan raw;
    raw.facts.format = "stl_binary";
    std::uint32_t announced = 0;
    std::memcpy(&announced, bytes.data() + headerBytes - 4, 4);
    const std::size_t available = (bytes.size() - headerBytes) / facetBytes;
    if (available < announced)
        throw Error(errors::truncated, {{"byte", static_cast<std::int64_t>(bytes.size())},
                                        {"found", static_cast<std::int64_t>(available)},
                                        {"expected", static_cast<std::int64_t>(announced)},
                                        {"items", LT_TEXT("Engine", "triangles")}});
    raw.stated_unit = statedUnit(bytes.substr(0, 80));
    raw.places.find = [bytes, announced](double largest) { return placeOfLargeCorner(bytes, announced, largest); };
    TriangleSink sink(raw);
    for (std::size_t i = 0; i < announced; ++i) {
        if ((i & 0xFFFF) == 0) source.progress.check();
        const std::array<float, 9> values = cornersOf(bytes, i);
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t k = 0; k < 9; ++k) corners[k / 3][static_cast<int>(k % 3)] = static_cast<double>(values[k]);
        sink.add(corners, static_cast<std::int64_t>(i) + 1);
    }
    raw.facts.rows = static_cast<std::int64_t>(announced);
    return raw;
}

}  // namespace lathelier::io
