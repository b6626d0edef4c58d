#include "engine/registration/deviation_file.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "tests/scratch_folder.h"

namespace lathelier::registration {
namespace {

struct DeviationFile : testing::Test {
    DeviationFile()
    {
        for (int i = 0; i < 20000; ++i) {
            copy.points_mm.emplace_back(i, 0.5, -2);
            result.deviation_mm.push_back(i % 100 == 7 ? NAN : 0.25F);
            result.used.push_back(i % 100 != 7);
        }
        result.alignment.reference_T_copy.translation() = Eigen::Vector3d(0, 0, 1.25);
    }

    ScratchFolder folder;
    Scan copy;
    CompareResult result;
};

TEST_F(DeviationFile, CsvHasOneRowForEachPointInOrder)
{
    const std::string path = (folder / "d.csv").string();
    writeDeviations(path, copy, result);
    const io::FileBytes bytes(path);
    const std::string_view text = bytes.view();
    EXPECT_EQ(text.substr(0, text.find("1,0.5")), "x_mm,y_mm,z_mm,deviation_mm,used\n0,0.5,-0.75,0.25,1\n");
    EXPECT_NE(text.find("\n19907,0.5,-0.75,,0\n"), std::string_view::npos);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 20001);
}

TEST_F(DeviationFile, PlyHasTheSameProperties)
{
    const std::string path = (folder / "d.PLY").string();
    writeDeviations(path, copy, result);
    const io::FileBytes bytes(path);
    const std::string_view text = bytes.view();
    const std::size_t begin = text.find("end_header\n") + 11;
    EXPECT_NE(text.find("element vertex 20000\nproperty double x_mm\nproperty double y_mm\nproperty double z_mm\n"
                        "property float deviation_mm\nproperty uchar used\n"),
              std::string_view::npos);
    ASSERT_EQ(text.size(), begin + 20000u * 29);
    const char* row = text.data() + begin + 19907u * 29;
    double x = 0;
    float deviation_mm = 0;
    std::memcpy(&x, row, 8);
    std::memcpy(&deviation_mm, row + 24, 4);
    EXPECT_EQ(x, 19907);
    EXPECT_TRUE(std::isnan(deviation_mm));
    EXPECT_EQ(row[28], 0);
}

TEST_F(DeviationFile, CancelLeavesNothingBehind)
{
    std::stop_source stop;
    const Progress progress(stop.get_token(), [&](double, Text) { stop.request_stop(); });
    copy.points_mm.resize(400000);
    result.deviation_mm.resize(400000);
    result.used.resize(400000);
    EXPECT_THROW(writeDeviations((folder / "d.csv").string(), copy, result, progress), Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(DeviationFile, OtherNamesAreRefused)
{
    EXPECT_THROW(writeDeviations((folder / "d.txt").string(), copy, result), Error);
}

}  // namespace
}  // namespace lathelier::registration
