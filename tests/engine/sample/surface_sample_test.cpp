// The photographs of the sample against its machine and their known truth.
#include "engine/sample/surface_sample.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/io/frf/frf_reader.h"
#include "engine/io/image/image.h"
#include "engine/sample/chatter_sample.h"
#include "engine/stability/marks_item.h"
#include "engine/surface/surface.h"

namespace lathelier {
namespace {

TEST(SurfaceSample, ItsMarksAreWhatItsMachineDoes)
{
    const SampleContent content = sample::surfaceSample().make(1, {});
    const Json& truth = content.truth->at("surface");
    surface::SurfaceParameters p;
    p.feed_mm_rev = truth.at("feed_mm_rev");
    p.diameter_mm = truth.at("diameter_mm");
    p.mm_per_px = truth.at("mm_per_px");
    p.speed_rpm = {{truth.at("before").at("speed_rpm")}, {truth.at("after").at("speed_rpm")}};
    p.feed_direction_deg = 0;
    p.cut_direction = surface::CutDirection::Down;
    std::vector<surface::NamedImage> images;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(content.texts[i].size(), 1000000U);
        EXPECT_NE(content.texts[i].find("SYNTHETIC"), std::string::npos);  // in the comment of the file
        images.push_back({std::to_string(i), io::readImage("x.png", content.texts[i])});
    }
    const surface::SurfaceResult found = findSurfaceMarks(images, p);
    ASSERT_TRUE(found.images[0].chatter_marks && found.images[0].chatter_marks->frequency_hz);
    const double marks_hz = *found.images[0].chatter_marks->frequency_hz;
    EXPECT_TRUE(found.images[0].chatter_marks->m_certain);
    EXPECT_NEAR(marks_hz, truth.at("before").at("chatter_hz").get<double>(), 0.3);
    EXPECT_EQ(found.images[1].verdict, surface::MarksVerdict::FeedMarks);

    const SampleContent machine = sample::chatterSample().make(1, {});
    const Frf tip = io::readFrf("tip.uff", machine.texts[2], {}, {}).frfs.front().frf;
    stability::LobeParameters lobes;
    lobes.speed_rpm = {{1400, 2800}};
    const auto check = checkModel({"", 2016, marks_hz, 1, {}}, findLobes(tip, lobes));
    ASSERT_TRUE(check);
    EXPECT_LT(std::abs(check->difference_percent), 0.5);
}

}  // namespace
}  // namespace lathelier
