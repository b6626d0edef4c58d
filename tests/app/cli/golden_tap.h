// Records of impact tests, for the golden lines of `tap`.
#pragma once

#include <functional>
#include <string>

namespace lathelier::golden {

/// tapped.csv, .uff, .wav: three hits on a mode of 300 Hz, ζ 3 %, 10000 N/mm; broken and unstated ones.
void makeTapRecords(const std::function<void(const std::string& name, const std::string& content)>& write);

}  // namespace lathelier::golden
