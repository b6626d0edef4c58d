// Kinds of marks by their keys; a key that is not known is kept.
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/shaft/mark_codes.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier {
namespace {

ShaftMark markOfKind(const char* stated)
{
    return fromValues<ShaftMark>({{"kind", std::string(stated)}, {"z_start_mm", 1.0}});
}

TEST(MarkKind, KeysAreThoseOfFiles)
{
    for (int i = 0; i < static_cast<int>(MarkKind::Other); ++i) {
        const auto kind = static_cast<MarkKind>(i);
        const ShaftMark mark = markOfKind(key(kind));
        EXPECT_EQ(mark.kind, kind) << key(kind);
        EXPECT_TRUE(mark.other_kind.empty()) << key(kind);
        EXPECT_EQ(std::get<std::string>(*find(toValues(mark), "kind")), key(kind));
    }
}

TEST(MarkKind, AnUnknownOneIsKept)
{
    for (const char* stated : {"helical_groove", "Thread", ""}) {
        const ShaftMark mark = markOfKind(stated);
        EXPECT_EQ(mark.kind, MarkKind::Other);
        EXPECT_EQ(key(mark), stated);
        EXPECT_EQ(std::get<std::string>(nameOf(mark)), stated);
        EXPECT_EQ(std::get<std::string>(*find(toValues(mark), "kind")), stated);
    }
}

TEST(TurnedMarks, TeethPrismsAndEccentricsAreRefusedByName)
{
    for (const char* stated : {"spline", "hexagon", "square", "eccentric"}) {
        const Shaft shaft{"", {}, {}, {}, {markOfKind("keyway"), markOfKind(stated)}};
        try {
            requireTurned(shaft);
            FAIL() << stated;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::markNotTurned);
            EXPECT_EQ(std::get<double>(*find(error.values(), "z_start_mm")), 1.0);
        }
    }
}

TEST(TurnedMarks, OtherMarksAreNot)
{
    for (const char* stated : {"thread", "knurl", "keyway", "flat", "cross_hole", "sphere"})
        EXPECT_NO_THROW(requireTurned(Shaft{"", {}, {}, {}, {markOfKind(stated)}})) << stated;
}

}  // namespace
}  // namespace lathelier
