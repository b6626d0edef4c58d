// The sample project: example data of each room, written into one folder and marked synthetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// The parts of all rooms, in the order of their files.
const std::vector<const SamplePart*>& sampleParts();

/// The names of the files that writeSample() writes, the project last.
std::vector<std::string> sampleFileNames();

/// Writes the parts' files, truth.json (their expected results) and sample.lathelier into the folder `directory` (made
/// when missing). Gives the paths in the order of sampleFileNames(). Error fileNotWritable.
std::vector<std::string> writeSample(const std::string& directory, std::uint64_t seed = 1,
                                     const Progress& progress = {});

}  // namespace lathelier::sample
