// Universal files of two points, and what becomes of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "tests/engine/io/frf_files.h"

namespace lathelier::testing {

inline io::FrfFile readUffFrf(const std::string& bytes, const io::FrfOptions& options = {})
{
    return io::readFrf("test.uff", bytes, {}, options);
}

inline Error uffRefusal(const std::string& bytes, const io::FrfOptions& options = {})
{
    try {
        readUffFrf(bytes, options);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error";
    return Error(errors::unknownOption, {});
}

inline bool has(const Notes& notes, const NoteCode& code)
{
    return contains(notes, code);
}

inline UffText twoPoints()
{
    UffText set;
    set.points = 2;
    return set;
}

inline const std::string twoValues =
    "  1.000000000000E+00 -2.000000000000E+00  3.000000000000E+00 -4.000000000000E+00\n";

}  // namespace lathelier::testing
