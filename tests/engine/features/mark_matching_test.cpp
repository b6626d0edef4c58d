// Marks of a drawing that a copy has or lacks.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/features/comparison/mark_matching.h"
#include "engine/features/features_codes.h"

namespace lathelier::features {
namespace {

ShaftMark placedMark(MarkKind kind, double from_mm, double to_mm)
{
    ShaftMark mark{kind};
    mark.z_start_mm = from_mm;
    mark.z_end_mm = to_mm;
    return mark;
}

std::size_t countOf(const Notes& notes, const NoteCode& code)
{
    std::size_t count = 0;
    for (const Note& note : notes) count += note.code == code;
    return count;
}

TEST(MarkMatching, SaysWhichMarksTheCopyLacks)
{
    Shaft drawn;
    drawn.marks = {placedMark(MarkKind::Keyway, 4, 16), placedMark(MarkKind::CrossHole, 22, 26)};
    Recognition copy;
    copy.marks = {placedMark(MarkKind::Keyway, 4.1, 15.9)};
    const Eigen::Isometry3d same = Eigen::Isometry3d::Identity();
    const Notes notes = notesOfMarks(drawn, copy, same);
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(countOf(notes, notes::markNotFound), 1u);
    EXPECT_EQ(countOf(notes, notes::marksNotCompared), 1u);
    copy.marks.push_back(placedMark(MarkKind::CrossHole, 22, 26));
    EXPECT_EQ(countOf(notesOfMarks(drawn, copy, same), notes::markNotFound), 0u);
    EXPECT_TRUE(notesOfMarks({}, copy, same).empty());
}

TEST(MarkMatching, OneMarkOfTheCopyIsOneOfTheDrawing)
{
    Shaft drawn;
    drawn.marks = {placedMark(MarkKind::Keyway, 4, 16), placedMark(MarkKind::Keyway, 4, 16)};
    Recognition copy;
    copy.marks = {placedMark(MarkKind::Keyway, 4, 16)};
    EXPECT_EQ(countOf(notesOfMarks(drawn, copy, Eigen::Isometry3d::Identity()), notes::markNotFound), 1u);
    copy.marks.push_back(placedMark(MarkKind::Keyway, 24, 36));  // elsewhere
    EXPECT_EQ(countOf(notesOfMarks(drawn, copy, Eigen::Isometry3d::Identity()), notes::markNotFound), 1u);
}

TEST(MarkMatching, FollowsTheFrameOfTheDrawing)
{
    Shaft drawn;
    drawn.marks = {placedMark(MarkKind::Keyway, 4, 16)};
    Recognition copy;  // of a part of 28 mm, end for end
    copy.marks = {placedMark(MarkKind::Keyway, 12, 24)};
    Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
    turned.rotate(Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d::UnitX()));
    turned.pretranslate(Eigen::Vector3d(0, 0, 28));
    EXPECT_EQ(countOf(notesOfMarks(drawn, copy, turned), notes::markNotFound), 0u);
    EXPECT_EQ(countOf(notesOfMarks(drawn, copy, Eigen::Isometry3d::Identity()), notes::markNotFound), 1u);
}

}  // namespace
}  // namespace lathelier::features
