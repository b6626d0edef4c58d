// What the tests of the readers share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/io/cloud/scan_reader.h"
#include "engine/io/io_codes.h"

namespace lathelier::testing {

/// Reads a file that exists only as text; without a unit of its own it is in mm.
inline io::ScanFile readText(const std::string& content, io::ImportOptions options = {})
{
    if (options.unit == io::LengthUnit::Auto) options.unit = io::LengthUnit::Millimetre;
    return io::readScan("test", content, options);
}

/// The error that reading gives.
inline Error errorOf(const std::string& content, const io::ImportOptions& options = {})
{
    try {
        io::readScan("test", content, options);
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

template <class T>
void appendBytes(std::string& out, T value, bool bigEndian = false)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (bigEndian) std::reverse(bytes, bytes + sizeof(T));
    out.append(bytes, sizeof(T));
}

inline std::string reasonOf(const io::SkippedRow& row)
{
    return row.reason.english;
}

}  // namespace lathelier::testing
