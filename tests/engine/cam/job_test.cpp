// JOB.json: read, written and read again the same; what is missing or impossible is named with its place.
#include <gtest/gtest.h>

#include "cam_data.h"
#include "engine/cam/cam_codes.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/job_rules.h"
#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "engine/stock/stock_codes.h"

namespace lathelier::cam {
namespace {

Job read(const std::string& text)
{
    Notes notes;
    return readJob(text, notes);
}

/// The error that a call throws; none: nullopt.
template <class Call>
std::optional<Error> errorOf(Call call)
{
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    return {};
}

double numberOf(const Error& error, const char* name)
{
    const Value* value = find(error.values(), name);
    if (!value) return -1;
    if (const auto* whole = std::get_if<std::int64_t>(value)) return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(value);
    return number ? *number : -1;
}

TEST(Job, IsReadWithItsDefaults)
{
    const Job job = jobOf("small");
    ASSERT_TRUE(job.shaft);
    EXPECT_EQ(job.shaft->segments.size(), 4U);
    EXPECT_EQ(job.stock.diameter_mm, 34);
    EXPECT_FALSE(job.stock.length_mm);
    EXPECT_FALSE(job.setup.tailstock);
    ASSERT_EQ(job.tools.size(), 2U);
    EXPECT_EQ(job.tools[1].use, ToolUse::Finish);
    EXPECT_EQ(job.tools[1].hand, Hand::TowardChuck);
    EXPECT_EQ(job.tools[1].back_margin_deg, 2);
    EXPECT_EQ(job.tools[1].backAngle_deg(), 5);
    EXPECT_EQ(job.cutting.rough.allowance_mm, 0.3);
    EXPECT_EQ(job.max_rpm, 3000);
    EXPECT_EQ(job.edge_break_mm, 0);
    EXPECT_EQ(stockOf(job).length_mm(), 60 + 10 + 1);
}

TEST(Job, IsWrittenAndReadTheSame)
{
    for (const char* name : {"small", "contour", "neck_all", "paper_s1"}) {
        const Job job = jobOf(name);
        EXPECT_EQ(read(jobText(job)), job) << name;
    }
    Job job = jobOf("small");
    job.setup.tailstock = JobTailstock{4, {{0, 2}, {-30, 20}}};
    job.setup.jaw_diameter_mm = 120;
    job.tools[0].holder = {{0, 20}, {5, 100}, {-20, 100}};
    job.sections = {{20, 2000}};
    EXPECT_EQ(read(jobText(job)), job);
}

TEST(Job, CornersMayBeListsOfTwoNumbers)
{
    std::string text =
        replaced(textOf("small_job.json"), R"("chuck_face_z_mm": 60)",
                 R"("chuck_face_z_mm": 60, "tailstock": {"centre_hole_mm": 3, "keep_out": [[0, 1.5], [-20, 13]]})");
    text = replaced(text, R"("edge_length_mm": 12)",
                    R"("edge_length_mm": 12, "holder": [[-1, 12], [-20, 12], [-20, 90]])");
    const Job job = read(text);
    ASSERT_TRUE(job.setup.tailstock);
    ASSERT_EQ(job.setup.tailstock->keep_out.size(), 2U);
    EXPECT_EQ(job.setup.tailstock->keep_out[1], (KeepOutCorner{-20, 13}));
    ASSERT_EQ(job.tools[0].holder.size(), 3U);
    EXPECT_EQ(job.tools[0].holder[1], (HolderCorner{-20, 12}));
    const auto error = errorOf([&] { read(replaced(text, "[0, 1.5]", "[0]")); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), errors::malformed);
}

TEST(Job, MissingAndWrongKeysAreNamedWithTheirPlace)
{
    const std::string text = textOf("small_job.json");
    for (const auto& [words, by, key] :
         {std::tuple{R"("diameter_mm": 34, )", "", "stock.diameter_mm"},
          std::tuple{R"("chuck_face_z_mm": 60)", "", "setup.chuck_face_z_mm"},
          std::tuple{R"("tools")", R"("tool")", "tools"}, std::tuple{R"("number": 1, )", "", "number"},
          std::tuple{R"("finish": {"feed)", R"("finishing": {"feed)", "finish"}}) {
        const auto error = errorOf([&, words = words, by = by] { read(replaced(text, words, by)); });
        ASSERT_TRUE(error) << words;
        EXPECT_EQ(error->code(), errors::keyMissing) << words;
        EXPECT_EQ(*find(error->values(), "key"), Value(std::string(key)));
        EXPECT_GT(numberOf(*error, "line"), 0);
    }
    const auto range = errorOf([&] { read(replaced(text, R"("nose_radius_mm": 0.8)", R"("nose_radius_mm": -1)")); });
    ASSERT_TRUE(range);
    EXPECT_EQ(range->code(), errors::keyOutOfRange);
    Notes notes;
    readJob(replaced(text, R"("title")", R"("titel")"), notes);
    EXPECT_TRUE(contains(notes, notes::unknownKey));
}

TEST(Job, FormerKeysOfToolsGiveTheSameTools)
{
    const auto job_with = [](const std::string& tools) {
        return read(R"({"stock": {"diameter_mm": 34}, "setup": {"chuck_face_z_mm": 60}, "tools": [)" + tools +
                    R"(], "cutting": {"rough": {"depth_mm": 2, "feed_mm_rev": 0.2, "cutting_speed_m_min": 190},
                        "finish": {"feed_mm_rev": 0.1, "cutting_speed_m_min": 190}}})");
    };
    const std::vector<std::pair<std::string, std::string>> pairs{
        {R"({"number": 1, "use": "rough", "nose_radius_mm": 0.8, "lead_angle_deg": -5, "tip_angle_deg": 80})",
         R"({"number": 1, "use": "rough", "corner_radius_mm": 0.8, "entering_angle_deg": 95, "tip_angle_deg": 80})"},
        {R"({"number": 8, "use": "groove", "width_mm": 3, "corner_radius_mm": 0.2, "max_depth_mm": 18})",
         R"({"number": 8, "use": "groove", "width_mm": 3, "corner_radius_mm": 0.2, "reach_mm": 18})"},
        {R"({"number": 9, "width_mm": 4, "edge_length_mm": 40, "use": "centre_drill"})",
         R"({"number": 9, "use": "centre_drill", "diameter_mm": 4, "reach_mm": 40})"},
        // As jobText() wrote them: every key, null or 0 where the tool has none.
        {R"({"number": 1, "use": "rough", "insert": "CNMG 120408", "nose_radius_mm": null, "corner_radius_mm": 0.0,
             "width_mm": null, "max_depth_mm": null})",
         R"({"number": 1, "use": "rough", "insert": "CNMG 120408"})"},
        {R"({"number": 1, "use": "finish", "nose_radius_mm": 0.4, "corner_radius_mm": 0.0, "hand": "from_chuck"})",
         R"({"number": 1, "use": "finish", "corner_radius_mm": 0.4, "hand": "from_chuck"})"}};
    for (const auto& [former, today] : pairs) EXPECT_EQ(job_with(former), job_with(today)) << today;
    const auto kind_of = [&](std::size_t pair) { return job_with(pairs[pair].first).tools[0].kind; };
    EXPECT_EQ(kind_of(0), ToolKind::Insert);
    EXPECT_EQ(kind_of(1), ToolKind::Blade);
    EXPECT_EQ(kind_of(2), ToolKind::Drill);
    EXPECT_EQ(job_with(pairs[2].first).tools[0].diameter_mm, 4);
    EXPECT_EQ(job_with(pairs[4].first).tools[0].tip, 4);
    for (const char* twice : {R"({"number": 1, "use": "rough", "corner_radius_mm": 0.4,
  "nose_radius_mm": 0.8})",
                              R"({"number": 8, "use": "groove", "reach_mm": 18,
  "max_depth_mm": 18})",
                              R"({"number": 9, "use": "centre_drill", "diameter_mm": 4,
  "width_mm": 4})"}) {
        const auto error = errorOf([&] { job_with(twice); });
        ASSERT_TRUE(error) << twice;
        EXPECT_EQ(error->code(), errors::valueStatedTwice);
        EXPECT_TRUE(find(error->values(), "former") && find(error->values(), "key"));
        EXPECT_EQ(numberOf(*error, "line"), 2);
        EXPECT_GT(numberOf(*error, "column"), 2);
    }
}

TEST(Job, PartMustFitIntoItsStock)
{
    Job job = jobOf("small");
    EXPECT_FALSE(errorOf([&] { checkStock(job, *job.shaft); }));
    job.stock.diameter_mm = 29;
    auto error = errorOf([&] { checkStock(job, *job.shaft); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), errors::stockSmallerThanPart);
    EXPECT_NEAR(numberOf(*error, "missing_mm"), 0.5, 1e-12);
    EXPECT_NEAR(numberOf(*error, "z_mm"), 18, 1e-12);
    job.stock.diameter_mm = 34;
    job.stock.length_mm = 28.5;
    error = errorOf([&] { checkStock(job, *job.shaft); });
    ASSERT_TRUE(error);
    EXPECT_NEAR(numberOf(*error, "missing_mm"), 0.5, 1e-12);
}

TEST(Job, SegmentsThatCannotBeTurnedAreNumbered)
{
    const Shaft sound = *jobOf("small").shaft;
    EXPECT_FALSE(errorOf([&] { checkPart(sound); }));
    for (const auto& [length, start, end, arc] :
         {std::tuple{-1.0, 20.0, 24.0, -2.0}, std::tuple{0.0, 20.0, 24.0, -2.0}, std::tuple{2.0, -20.0, 24.0, -2.0},
          std::tuple{2.0, 20.0, 24.0, 1.4}, std::tuple{1.0, 20.0, 24.0, 1.2}}) {
        Shaft shaft = sound;
        shaft.segments[2] = {length, start, end, 0, arc, ""};
        const auto error = errorOf([&, &shaft = shaft] { checkPart(shaft); });
        ASSERT_TRUE(error) << length << ' ' << arc;
        EXPECT_EQ(error->code(), errors::segmentImpossible);
        EXPECT_EQ(numberOf(*error, "segment"), 3);
    }
}

TEST(Job, ToolsMustBePossible)
{
    const Job sound = jobOf("small");
    EXPECT_FALSE(errorOf([&] { checkTools(sound); }));
    EXPECT_FALSE(errorOf([&] { checkUses(sound); }));
    Job job = sound;
    job.tools[0].entering_angle_deg = 100;
    auto error = errorOf([&] { checkTools(job); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), errors::toolImpossible);
    job = sound;
    job.tools[1].number = 1;
    EXPECT_EQ(errorOf([&] { checkTools(job); })->code(), errors::toolNumberTwice);
    job = sound;
    job.tools[1].corner_radius_mm.reset();
    EXPECT_EQ(errorOf([&] { checkTools(job); })->code(), errors::toolIncomplete);
    job = sound;
    job.tools.pop_back();
    EXPECT_EQ(errorOf([&] { checkUses(job); })->code(), errors::toolMissing);
    job = sound;
    job.part_off = true;
    EXPECT_EQ(errorOf([&] { checkUses(job); })->code(), errors::toolMissing);
    job = jobOf("neck_all");
    EXPECT_FALSE(errorOf([&] { checkUses(job); }));
    job.tools.back().reach_mm = 15.9;
    EXPECT_EQ(errorOf([&] { checkUses(job); })->code(), errors::toolTooShort);
}

TEST(Job, MirroredPartIsThePartFromItsOtherEnd)
{
    const Shaft part = *jobOf("small").shaft;
    const Shaft turned = mirrored(part);
    EXPECT_EQ(turned.segments.front().start_diameter_mm, 30);
    EXPECT_EQ(turned.segments[1].start_diameter_mm, 24);
    EXPECT_EQ(turned.segments[1].end_diameter_mm, 20);
    EXPECT_EQ(turned.segments[1].arc_radius_mm, -2);
    EXPECT_EQ(mirrored(turned), part);
}

}  // namespace
}  // namespace lathelier::cam
