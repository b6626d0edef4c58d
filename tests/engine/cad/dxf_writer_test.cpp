// DXF R12: volumes from the entities of the file, its grammar, texts in ASCII.
#include "engine/cad/dxf_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "engine/shaft/shaft_contour.h"
#include "parts.h"

namespace lathelier::cad {
namespace {

constexpr double pi = std::numbers::pi;

struct Entity {
    std::string kind;
    std::map<int, std::string> values;
    double at(int code) const { return std::atof(values.at(code).c_str()); }
};

std::vector<Entity> entities(const std::string& text)
{
    std::vector<Entity> found;
    bool inside = false;
    std::size_t at = 0;
    const auto line = [&] {
        const std::size_t end = text.find('\n', at);
        EXPECT_NE(end, std::string::npos);
        const std::string result = text.substr(at, end - at);
        at = end + 1;
        return result;
    };
    while (at < text.size()) {
        const int code = std::atoi(line().c_str());
        const std::string value = line();
        if (code == 2 && value == "ENTITIES") inside = true;
        if (code == 0 && inside && value != "ENDSEC" && value != "EOF")
            found.push_back({value, {}});
        else if (!found.empty())
            found.back().values.emplace(code, value);
    }
    return found;
}

Contour piecesOf(const std::vector<Entity>& all)
{
    Contour pieces;
    for (const Entity& one : all) {
        if (one.kind == "LINE") {
            pieces.push_back({{one.at(10), one.at(20)}, {one.at(11), one.at(21)}, 0});
            continue;
        }
        const Eigen::Vector2d centre(one.at(10), one.at(20));
        const auto end = [&](int code) -> Eigen::Vector2d {
            const double angle = one.at(code) * pi / 180;
            return centre + one.at(40) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        };
        // Anticlockwise: it bulges to the right of its travel.
        pieces.push_back({end(50), end(51), -one.at(40)});
    }
    return pieces;
}

/// The volume that the closed contour of a file sweeps; 0 when it is not closed.
double sweptVolume(Contour pieces)
{
    double volume = 0;
    const Eigen::Vector2d begin = pieces.front().from_mm;
    Eigen::Vector2d at = begin;
    while (!pieces.empty()) {
        const auto next = std::find_if(pieces.begin(), pieces.end(), [&](const ContourPiece& piece) {
            return (piece.from_mm - at).norm() < 1e-7 || (piece.to_mm - at).norm() < 1e-7;
        });
        if (next == pieces.end()) return 0;
        const ContourPiece piece = (next->from_mm - at).norm() < 1e-7 ? *next : next->reversed();
        volume += piece.sweptVolume_mm3();
        at = piece.to_mm;
        pieces.erase(next);
    }
    return (at - begin).norm() < 1e-7 ? volume : 0;
}

TEST(Dxf, TheContourSweepsTheVolumeOfTheShaft)
{
    for (const Shaft& shaft : allParts()) {
        const std::string text = contourDxf(shaft);
        EXPECT_NEAR(std::abs(sweptVolume(piecesOf(entities(text)))) / volume_mm3(shaft), 1, 1e-9) << shaft.name;
        EXPECT_EQ(text, contourDxf(shaft));
        EXPECT_EQ(text.find('\r'), std::string::npos);
        EXPECT_EQ(text.find("-0.000000000"), std::string::npos);
        EXPECT_TRUE(text.ends_with("0\nEOF\n"));
        EXPECT_NE(text.find("9\n$ACADVER\n1\nAC1009\n"), std::string::npos);
    }
}

TEST(Dxf, ADrawingWithTextsArrowsAndLayers)
{
    DxfDrawing drawing;
    drawing.lines = {{{0, 0}, {10, 0}, layers::axis}, {{0, 1}, {1, 2}, layers::hatch}, {{0, 0}, {1, 1}, "own layer"}};
    drawing.arcs = {{{5, 5}, 2, 350, 10, layers::contour}};
    drawing.texts = {{{5, -3}, 3.5, 90, "⌀30 h6 ±0,01 45° ×2", DxfText::Align::Centre, layers::dimensions}};
    drawing.arrows = {{{10, 0}, {1, 0}, 3, layers::dimensions}};
    const std::string text = dxfText(drawing);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c < 127); }));
    const std::vector<Entity> all = entities(text);
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[2].values.at(8), "OWN_LAYER");
    EXPECT_NE(text.find("0\nLAYER\n2\nOWN_LAYER\n"), std::string::npos);
    EXPECT_EQ(all[4].values.at(1), "%%c30 h6 %%p0,01 45%%d \\U+00D72");
    EXPECT_EQ(all[4].values.at(72), "1");
    EXPECT_EQ(all[5].kind, "SOLID");
    EXPECT_NEAR(all[5].at(11), 7, 1e-9);
    EXPECT_NEAR(all[5].at(21), 0.5, 1e-9);
    EXPECT_FALSE(dxfText({}).empty());
}

}  // namespace
}  // namespace lathelier::cad
