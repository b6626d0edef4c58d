// Programs of other files: found by what they declare or by the name of the file, run behind the program, named with
// their own lines.
#include "engine/gcode/subprograms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "engine/gcode/controls/controls.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

namespace fs = std::filesystem;

class Subprograms : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() /
                  ("lathelier_subprograms_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) + "_" +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        parameters_.dialect = "fanuc";
        parameters_.subprograms = folder_.string();
        parameters_.file_name = "main.nc";
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

    Toolpath run(const std::string& text)
    {
        FoundSubprograms found = findSubprograms(text, parameters_, {}, {});
        files_ = found.files.size();
        notes_ = found.notes;
        parameters_.parts = std::make_shared<const std::vector<ProgramPart>>(std::move(found.parts));
        program_ = readProgram(text, controlOf(parameters_), {}, parameters_.file_name, partsOf(parameters_));
        return findToolpath(program_, parameters_);
    }

    fs::path folder_;
    ToolpathParameters parameters_;
    Program program_;
    Notes notes_;
    std::size_t files_ = 0;
};

const std::string head = "O0001\nG21 G18 G40 G99\nT0101\nG97 S500 M3\nG0 X30. Z2.\n";

TEST_F(Subprograms, RunBehindTheProgramWithoutChangingIt)
{
    write("o1234", "G1 Z-5. F0.1\nM99\n");
    const std::string text = head + "M98 P1234\nM30";  // without the last end of line
    const Toolpath path = run(text);
    ASSERT_EQ(path.moves.size(), 2U);
    EXPECT_DOUBLE_EQ(path.moves[1].z_mm, -5);
    EXPECT_TRUE(path.understanding.isWhole());
    EXPECT_EQ(program_.ownText(), text);
    EXPECT_EQ(path.moves[1].line, 8);
    const LinePlace place = program_.placeOf(path.moves[1].line);
    EXPECT_EQ(place.path, (folder_ / "o1234").string());
    EXPECT_EQ(place.line, 1);
    EXPECT_EQ(program_.placeOf(7).path, "");
    ASSERT_EQ(notes_.size(), 1U);
    EXPECT_EQ(*find(notes_.front().values, "first_line"), Value(std::int64_t{8}));
    EXPECT_EQ(*find(notes_.front().values, "last_line"), Value(std::int64_t{9}));
}

/// What a file declares counts before its name; a number is the same with zeros before it.
TEST_F(Subprograms, AreFoundByWhatTheyDeclare)
{
    write("10.nc", "O20\nG1 Z-9. F0.1\nM99\n");
    write("store.txt", "%\n:0010\nG1 Z-7. F0.1\nM99\n%\n");
    const Toolpath path = run(head + "M98 P10\nM30\n");
    ASSERT_EQ(path.moves.size(), 2U);
    EXPECT_DOUBLE_EQ(path.moves[1].z_mm, -7);
    EXPECT_EQ(files_, 1U);
}

TEST_F(Subprograms, TwoDifferentFilesOfOneNameRemainAGap)
{
    write("O5.nc", "G1 Z-9. F0.1\nM99\n");
    write("5.nc", "G1 Z-8. F0.1\nM99\n");
    Toolpath path = run(head + "M98 P5\nM30\n");
    EXPECT_FALSE(path.understanding.isWhole());
    EXPECT_EQ(path.missing, std::vector<std::string>{"O5"});
    write("5.nc", "G1 Z-9. F0.1\nM99\n");  // the same text
    path = run(head + "M98 P5\nM30\n");
    EXPECT_TRUE(path.understanding.isWhole());
}

TEST_F(Subprograms, CallThemselvesOnlySoDeep)
{
    write("O7.nc", "G0 U1.\nM98 P7\nM99\n");
    const Toolpath path = run(head + "M98 P7\nM30\n");
    ASSERT_TRUE(path.has_errors);
    const auto deep = std::find_if(path.diagnostics.begin(), path.diagnostics.end(),
                                   [](const Diagnostic& found) { return found.is_error; });
    EXPECT_EQ(deep->code, errors::ncNesting.key);
    EXPECT_EQ(deep->line, 2);
    EXPECT_EQ(deep->path, (folder_ / "O7.nc").string());
    EXPECT_EQ(*find(deep->error->values(), "path"), Value((folder_ / "O7.nc").string()));
}

TEST_F(Subprograms, AMainProgramDoesNotRunOnIntoThem)
{
    write("O7.nc", "G0 U1.\nM99\n");
    const Toolpath path = run(head + "M98 P7\nG0 X50.\n");  // without M30
    ASSERT_EQ(path.moves.size(), 3U);
    EXPECT_DOUBLE_EQ(path.moves[2].x_mm, 25);
}

TEST_F(Subprograms, AFolderThatIsNotThereIsRefused)
{
    parameters_.subprograms = (folder_ / "absent").string();
    EXPECT_THROW(findSubprograms(head, parameters_, {}, {}), Error);
}

TEST(SubprogramNames, OfEveryControl)
{
    using Names = std::vector<std::string>;
    EXPECT_EQ(programsIn("%\nO0012 (X)\nG0\no3\n:4\nN5 G0\n", *controlNamed("fanuc")), (Names{"O12", "O3", "O4"}));
    EXPECT_EQ(programsIn("%_N_L54_SPF\nM17\nPROC TURN(REAL A)\n", *controlNamed("sinumerik")), (Names{"L54", "TURN"}));
    EXPECT_EQ(programsIn("o<turn> sub\no<turn> endsub\no100 sub\n(o5 sub)\n", *controlNamed("linuxcnc")),
              (Names{"OTURN", "O100"}));
}

}  // namespace
}  // namespace lathelier::gcode
