// What the tests of the readers share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "engine/io/scan_reader.h"

namespace lathelier::testing {

/// Reads a file that exists only as text; without a unit of its own it is in mm.
inline ScanFile readText(const std::string& content, ImportOptions options = {})
{
    if (options.unit == LengthUnit::Auto) options.unit = LengthUnit::Millimetre;
    return readScan("test", content, options);
}

/// The error that reading gives.
inline Error errorOf(const std::string& content, const ImportOptions& options = {})
{
    try {
        readScan("test", content, options);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error for: " << content.substr(0, 200);
    return Error(errors::unknownOption, {});
}

inline std::int64_t integerOf(const Error& error, const char* name)
{
    const Value* value = find(error.values(), name);
    return value && std::holds_alternative<std::int64_t>(*value) ? std::get<std::int64_t>(*value) : -1;
}

inline std::string wordOf(const Error& error, const char* name)
{
    const Value* value = find(error.values(), name);
    return value ? text(*value) : std::string();
}

/// Notes besides the one that every table has: which columns were read.
inline std::size_t furtherNotes(const Notes& notes)
{
    return static_cast<std::size_t>(
        std::count_if(notes.begin(), notes.end(), [](const Note& note) { return !(note.code == notes::columnsRead); }));
}

inline std::string reasonOf(const SkippedRow& row)
{
    return row.reason.english;
}

}  // namespace lathelier::testing
