// Tasks of tests: a part is a file that holds a number, judged against a factor and the number of a reference.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "engine/batch/batch.h"
#include "tests/scratch_folder.h"

namespace lathelier::batch {

/// Runs of all tasks of this file.
std::atomic<int>& runsCounted();

/// "number": reference (fixed, --reference), part (several); parameters factor, limit, pause_ms, name.
const task::Task& numberTask();

/// "pair": the varied operands first and second.
const task::Task& pairTask();

Tasks numberTasks();

void writeText(const std::filesystem::path& path, const std::string& text);
std::string textOf(const std::filesystem::path& path);

/// A recipe of numberTask() with reference.txt in `folder`, which is written, and a part as an example.
Recipe numberRecipe(const ScratchFolder& folder, const Values& parameters = {});

/// p000.txt… in folder/parts with the numbers 0, 1…; the paths.
std::vector<std::string> writeParts(const ScratchFolder& folder, int count);

BatchSettings into(const std::filesystem::path& folder, int jobs = 1);

}  // namespace lathelier::batch
