#include "engine/sample/sample_record.h"
#include "engine/io/io_codes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/form/circle/circles.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/probe/probe_table.h"

namespace lathelier {
namespace {

TEST(SampleRecord, ItsTextIsReadBackAsItWas)
{
    sample::SpindleModel model = sample::sampleSpindle();
    model.sections = 2;
    model.revolutions = 5;
    const io::ProbeRecord made = sample::makeProbeRecord(model);
    const io::ProbeFile file = io::readProbeTable("probe_record.csv", sample::toCsv(made));
    const auto& read = std::get<io::ProbeRecord>(file.record);
    ASSERT_EQ(read.channels.size(), 5u);
    ASSERT_EQ(read.frames(), made.frames());
    for (std::size_t channel = 0; channel < 5; ++channel) {
        EXPECT_EQ(read.channels[channel].unit, made.channels[channel].unit);
        for (std::size_t i = 0; i < made.frames(); ++i)
            ASSERT_NEAR(read.channels[channel].values[i], made.channels[channel].values[i], 5.1e-4);
    }
    ASSERT_TRUE(read.channel_skew_s);
    EXPECT_NEAR(*read.channel_skew_s, *made.channel_skew_s, 1e-12);
    for (const auto& [key, value] : made.header) {
        ASSERT_TRUE(find(read.header, key)) << key;
        EXPECT_EQ(*find(read.header, key), value) << key;
    }
    EXPECT_TRUE(contains(file.notes, notes::syntheticData));
    EXPECT_TRUE(contains(file.notes, notes::columnsRead));
    EXPECT_EQ(file.notes.size(), 2u);
}

TEST(SampleRecord, TheAveragesAreReadBackToo)
{
    const io::AveragedRecord made = sample::makeAveragedRecord(sample::sampleSpindle());
    const io::ProbeFile file = io::readProbeTable("averaged.csv", sample::toCsv(made));
    const auto& read = std::get<io::AveragedRecord>(file.record);
    ASSERT_EQ(read.sections.size(), 20u);
    EXPECT_NEAR(read.sections[19].z_mm, 97.5, 1e-9);
    ASSERT_EQ(read.sections[7].Xp_um.size(), 200u);
    EXPECT_NEAR(read.sections[7].Xp_um[31], made.sections[7].Xp_um[31], 1e-4);
    EXPECT_NEAR(read.sections[7].sXp_um[31], made.sections[7].sXp_um[31], 1e-4);
    EXPECT_TRUE(contains(file.notes, notes::syntheticData));
}

TEST(SampleRecord, TheSeedDecidesAndTheTruthHasTheStatedTaperAndBarrel)
{
    sample::SpindleModel model = sample::sampleSpindle();
    model.sections = 3;
    const io::ProbeRecord one = sample::makeProbeRecord(model);
    EXPECT_EQ(one.channels[1].values, sample::makeProbeRecord(model).channels[1].values);
    model.seed = 2;
    EXPECT_NE(one.channels[1].values, sample::makeProbeRecord(model).channels[1].values);

    // Ends at ∓ taper / 4 - barrel, the middle at 0. The 200 samples of a revolution lie half a sample before its
    // middle on average: of 10 mm along z that is 2 · 3e-5, worth 4 · 5 µm · 3e-5.
    double radius_um[3];
    for (int i = 0; i < 3; ++i)
        radius_um[i] = 1e3 * form::fitLeastSquaresCircle(sample::trueImage_mm(model, i)).radius_mm;
    EXPECT_NEAR(radius_um[2] - radius_um[0], model.taper_diameter_um / 2, 2e-3);
    EXPECT_NEAR(radius_um[1] - (radius_um[0] + radius_um[2]) / 2, model.barrel_um, 2e-3);
}

}  // namespace
}  // namespace lathelier
