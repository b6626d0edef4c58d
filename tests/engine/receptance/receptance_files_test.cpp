// SPINDLE.json, SHAFT.json, stock files and MEASUREMENTS.json: content and located errors.
#include <gtest/gtest.h>

#include "../core/code_of_error.h"
#include "engine/beam/beam_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/shaft/shaft_codes.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

using io::readMaterial;
using io::readShaft;
using io::readShaftFile;
using io::readStock;

template <class Run>
Values valuesOfError(const Run& run)
{
    try {
        run();
    } catch (const Error& error) {
        return error.values();
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(SpindleFile, WritesWhatItReads)
{
    Notes notes;
    for (const SpindleReceptance& spindle : {springs(), SpindleReceptance{livelySpindle(50, 400, 17)}})
        EXPECT_EQ(readSpindle(spindleText(spindle), notes), spindle);
    EXPECT_TRUE(notes.empty());
}

TEST(SpindleFile, SaysWhereItIsWrong)
{
    Notes notes;
    const auto reading = [&notes](const std::string& text) { return [&notes, text] { readSpindle(text, notes); }; };
    EXPECT_EQ(codeOfError(reading("{}")), errors::keyMissing);
    EXPECT_EQ(codeOfError(reading(R"({"springs": {"radial_N_mm": 1}})")), errors::keyMissing);
    EXPECT_EQ(codeOfError(reading(R"({"springs": {"radial_N_mm": -1, "tilt_N_mm_rad": 1, "loss_factor": 0}})")),
              errors::keyOutOfRange);
    const Values place =
        valuesOfError(reading("{\"frequency_hz\": [1, 2],\n \"H_mm_N\": [[1, 2], [3]],\n"
                              " \"L_mm_Nmm\": [], \"P_rad_Nmm\": []}"));
    EXPECT_EQ(*find(place, "line"), Value(std::int64_t{2}));
    EXPECT_EQ(*find(place, "column"), Value(std::int64_t{21}));
    EXPECT_EQ(codeOfError(reading(R"({"frequency_hz": [2, 1]})")), errors::malformed);
    EXPECT_EQ(codeOfError(reading(R"({"frequency_hz": [1], "H_mm_N": [[0, 0], [0, 0]]})")), errors::malformed);
    EXPECT_TRUE(notes.empty());
    readSpindle(R"({"springs": {"radial_N_mm": 1, "tilt_N_mm_rad": 1, "loss_factor": 0}, "name": "x"})", notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, notes::unknownKey);
}

TEST(SpindleReceptance, IsLinearBetweenLinesAndNothingBeyond)
{
    const SpindleReceptance spindle{livelySpindle(100, 200, 50)};
    const auto& table = std::get<SpindleTable>(spindle.source);
    EXPECT_EQ(spindle.at(100)(0, 0), table.H_mm_N[0]);
    EXPECT_EQ(spindle.at(200)(1, 1), table.P_rad_Nmm[2]);
    EXPECT_LT(std::abs(spindle.at(125)(0, 1) - (table.L_mm_Nmm[0] + table.L_mm_Nmm[1]) / 2.0), 1e-20);
    EXPECT_EQ(codeOfError([&] { spindle.at(99.9); }), errors::frequencyOutsideSpindle);
    EXPECT_EQ(codeOfError([&] { spindle.at(200.1); }), errors::frequencyOutsideSpindle);
}

constexpr const char* shaftJson = R"({"name": "a", "marks": [], "segments": [
  {"length_mm": 50, "start_diameter_mm": 30, "end_diameter_mm": 30, "tolerance": {"class": "h6"}, "measured": {}},
  {"length_mm": 50, "start_diameter_mm": 40, "end_diameter_mm": 50}],
  "bores": [{"from": "chuck", "segments": [{"length_mm": 20, "start_diameter_mm": 12, "end_diameter_mm": 12},
                                           {"length_mm": 40, "start_diameter_mm": 8, "end_diameter_mm": 8}]}]})";

TEST(ShaftFile, LaysBoresIntoTheSegments)
{
    Notes notes;
    const Shaft shaft = readShaftFile(shaftJson, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(readShaft(shaftJson, notes).bores.size(), 1U);
    ASSERT_EQ(shaft.segments.size(), 4U);
    EXPECT_EQ(shaft.segments[0].length_mm, 40);
    EXPECT_EQ(shaft.segments[0].bore_diameter_mm, 0);
    EXPECT_EQ(shaft.segments[1].bore_diameter_mm, 8);
    EXPECT_EQ(shaft.segments[2].length_mm, 30);
    EXPECT_EQ(shaft.segments[2].end_diameter_mm, 46);
    EXPECT_EQ(shaft.segments[2].bore_diameter_mm, 8);
    EXPECT_EQ(shaft.segments[3].start_diameter_mm, 46);
    EXPECT_EQ(shaft.segments[3].bore_diameter_mm, 12);
    EXPECT_NEAR(shaft.length_mm(), 100, 1e-12);
    std::string twice = shaftJson;
    twice.replace(twice.find("\"end_diameter_mm\": 30"), 0, "\"bore_diameter_mm\": 5, ");
    EXPECT_EQ(codeOfError([&] { readShaftFile(twice, notes); }), errors::boresStatedTwice);
}

TEST(ShaftFile, RefusesAnotherSchema)
{
    Notes notes;
    EXPECT_EQ(codeOfError([&] { readShaft(R"({"schema": "other", "segments": []})", notes); }), errors::malformed);
    EXPECT_EQ(codeOfError([&] { readShaft(R"({"schema_version": 2, "segments": []})", notes); }), errors::malformed);
    EXPECT_EQ(codeOfError([&] { readShaft(R"({"name": "no segments"})", notes); }), errors::keyMissing);
}

TEST(ShaftFile, ReadsAMaterial)
{
    Notes notes;
    const Material brass = readMaterial(R"({"name": "brass", "elastic_modulus_MPa": 100000, "x": 1})", notes);
    EXPECT_EQ(brass.elastic_modulus_MPa, 100000);
    EXPECT_EQ(brass.density_kg_m3, 7850);
    EXPECT_TRUE(contains(notes, notes::unknownKey));
}

TEST(StockFile, IsRadiiAndLengths)
{
    const Shaft shaft = readStock("# from the free end\n17 0 17 0 287.5\n\n20 5 25 5 10\r\n");
    ASSERT_EQ(shaft.segments.size(), 2U);
    EXPECT_EQ(shaft.segments[0].start_diameter_mm, 34);
    EXPECT_EQ(shaft.segments[0].length_mm, 287.5);
    EXPECT_EQ(shaft.segments[1].start_diameter_mm, 40);
    EXPECT_EQ(shaft.segments[1].end_diameter_mm, 50);
    EXPECT_EQ(shaft.segments[1].bore_diameter_mm, 10);
    EXPECT_EQ(readStock("20 5 20 10 50").segments.size(), 50U);
    EXPECT_EQ(codeOfError([] { readStock("# nothing\n"); }), errors::shaftEmpty);
}

TEST(StockFile, SaysWhereItIsWrong)
{
    const Values few = valuesOfError([] { readStock("17 0 17 0 10\n17 0 17 0\n"); });
    EXPECT_EQ(*find(few, "line"), Value(std::int64_t{2}));
    const Values word = valuesOfError([] { readStock("17 0 x 0 10\n"); });
    EXPECT_EQ(*find(word, "column"), Value(std::int64_t{6}));
    EXPECT_EQ(codeOfError([] { readStock("17 0 17 0 10 3\n"); }), errors::malformed);
    EXPECT_EQ(codeOfError([] { readStock("17 0 17 17 10\n"); }), errors::malformed);
}

TEST(ShaftFile, ToldApartByContent)
{
    Notes notes;
    EXPECT_EQ(readShaftFile("20 0 20 0 250\n", notes).segments.size(), 1u);
    EXPECT_EQ(readShaftFile("\xEF\xBB\xBF {\"segments\": [{\"length_mm\": 9, \"start_diameter_mm\": 4, "
                            "\"end_diameter_mm\": 4}]}",
                            notes)
                  .length_mm(),
              9);
    EXPECT_EQ(codeOfError([&] { readShaftFile("", notes); }), errors::fileEmpty);
}

TEST(Measurements, RodsAndNodes)
{
    Notes notes;
    const std::string text = R"({"frf": "a.uff", "rods": [{"length_mm": 150, "diameter_mm": 40,
        "points": [{"node": 101, "distance_from_chuck_mm": 50}, {"node": 102, "distance_from_chuck_mm": 140}]}]})";
    const MeasurementFile file = readMeasurements(text, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(file.frf, "a.uff");
    EXPECT_FALSE(file.rods.at(0).material);
    ASSERT_EQ(file.rods.at(0).points.size(), 2U);
    Frf frf;
    const std::vector<NodeFrf> frfs{{101, 102, frf}, {7, 102, frf}};
    const SpindleMeasurements both = measurementsOf(file, frfs);
    ASSERT_EQ(both.frfs.size(), 1U);
    EXPECT_EQ(both.frfs[0].point_b, 1U);
    const std::vector<NodeFrf> one{{101, 101, frf}};
    const auto missing = [&] { measurementsOf(file, one); };
    EXPECT_EQ(codeOfError(missing), errors::measuredNodeMissing);
    EXPECT_EQ(*find(valuesOfError(missing), "node"), Value(std::int64_t{102}));
    std::string beyond = text;
    beyond.replace(beyond.find("140"), 3, "151");
    EXPECT_EQ(codeOfError([&] { readMeasurements(beyond, notes); }), errors::measuredPointBeyondRod);
}

}  // namespace
}  // namespace lathelier::receptance
