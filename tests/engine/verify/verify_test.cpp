#include "engine/verify/verify.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "engine/core/error.h"
#include "engine/form/verify/form_verification.h"
#include "tests/engine/form/form_data.h"
#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

TEST(Verify, EveryKindPasses)
{
    const verify::VerifyResult result = verify::verify(verify::verifyParts());
    EXPECT_TRUE(result.pass);
    EXPECT_GE(result.kinds.size(), 11U);
    std::set<std::string> names;
    for (const VerifyKind& kind : result.kinds) {
        EXPECT_TRUE(kind.pass) << kind.kind << " " << kind.largest_deviation << " of " << kind.limit;
        EXPECT_GT(kind.sets, 0) << kind.kind;
        EXPECT_GE(kind.limit, kind.largest_deviation);
        EXPECT_TRUE(names.insert(kind.kind).second);
        RecordProperty(kind.kind, std::to_string(kind.largest_deviation));
    }
}

TEST(Verify, TakesTheNistSetsOfADirectory)
{
    const verify::VerifyResult result = verify::verify(verify::verifyParts(), form::nistLikeData().string());
    EXPECT_EQ(result.kinds.back().kind, "nist_circle");
    EXPECT_EQ(result.kinds.back().sets, 10);
    EXPECT_TRUE(result.kinds.back().pass) << result.kinds.back().largest_deviation;
}

TEST(Verify, SaysWhatIsWrongWithADirectory)
{
    const ScratchFolder folder;
    EXPECT_THROW(verify::verify(verify::verifyParts(), (folder / "missing").string()), Error);
    const auto refusal = [&folder] {
        try {
            verify::verify(verify::verifyParts(), folder.string());
        } catch (const Error& error) {
            EXPECT_TRUE(find(error.values(), "path"));
            return std::string(error.code().key);
        }
        return std::string();
    };
    // Unusable reference data are an error, not a failed verification.
    EXPECT_EQ(refusal(), "reference_data_missing");
    std::ofstream(folder / "b.ds") << "4\n1 0 0\n0 1 5\n-1 0 10\n0 -1 2\n";
    EXPECT_EQ(refusal(), "file_not_found");  // a set without its answer
    std::ofstream(folder / "b.fit") << "0 0 0 0 0 1 2\n";
    EXPECT_EQ(refusal(), "reference_data_missing");  // a cylinder
    std::ofstream(folder / "b.fit") << "0 0 0 2\n";
    EXPECT_EQ(refusal(), "reference_data_missing");  // a sphere
    std::filesystem::remove(folder / "b.ds");
    std::ofstream(folder / "a.ds") << "3\n1 2 0\n3 4 zero\n";
    std::ofstream(folder / "a.fit") << "1 2 3 0 0 1 4\n";
    EXPECT_THROW(verify::verify(verify::verifyParts(), folder.string()), Error);
    // A wrong reference value is detected: the circle through these has the diameter 2.
    std::ofstream(folder / "a.ds") << "3\n1 0 0\n0 1 0\n-1 0 0\n";
    std::ofstream(folder / "a.fit") << "0 0 0 0 0 1 2.0001\n";
    const verify::VerifyResult wrong = verify::verify(verify::verifyParts(), folder.string());
    EXPECT_FALSE(wrong.pass);
    EXPECT_NEAR(wrong.kinds.back().largest_deviation, 5e-5, 1e-6);
}

TEST(Verify, WhatIsNoNumberFails)
{
    VerifyTally tally("kind", {}, {}, 1);
    tally.nextSet();
    tally.compare(std::nan(""), 0);
    tally.compare(0, 0);
    EXPECT_FALSE(tally.done().pass);
    VerifyTally empty("kind", {}, {}, 1);
    EXPECT_FALSE(empty.done().pass);
}

}  // namespace
}  // namespace lathelier
