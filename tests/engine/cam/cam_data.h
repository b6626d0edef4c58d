// Jobs and programs of tests/data/turning, and faults planted into them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/cam/check/turning_check.h"
#include "engine/cam/job_file.h"

namespace lathelier::cam {

inline std::string textOf(const std::string& name)
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/tests/data/turning/" + name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), {}};
}

inline Job jobOf(const std::string& name)
{
    Notes notes;
    Job job = readJob(textOf(name + "_job.json"), notes);
    EXPECT_TRUE(notes.empty()) << name;
    return job;
}

/// Line (from 1) of the first occurrence of `words` in a text.
inline std::int64_t lineOf(const std::string& text, const std::string& words)
{
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
}

inline std::string replaced(std::string text, const std::string& words, const std::string& by)
{
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    return text.replace(at, words.size(), by);
}

inline CheckResult checked(const std::string& text, const Job& job, const CheckParameters& parameters = {},
                           const CheckInputs& inputs = {})
{
    return checkTurning(text, *job.shaft, job, parameters, inputs);
}

/// The rest interval that contains z, or the nearest; fails if there is none.
inline const RestInterval* restAt(const CheckResult& result, double z_mm)
{
    for (const RestInterval& rest : result.rest)
        if (z_mm >= rest.z_start_mm - 0.05 && z_mm <= rest.z_end_mm + 0.05) return &rest;
    return nullptr;
}

}  // namespace lathelier::cam
