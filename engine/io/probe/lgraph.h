// Probe records of the recorder L-Graph from memory.
#pragma once

#include <string>
#include <string_view>

#include "engine/io/probe/probe_reader.h"

namespace lathelier::io {

/// An L-Graph pair from memory; `name` replaces the path of the .par in messages, `datName` that of the .dat.
ProbeFile readLGraph(const std::string& name, std::string_view par, std::string_view dat,
                     const RecorderOptions& recorder = {}, const Progress& progress = {},
                     const std::string& datName = {});

}  // namespace lathelier::io
