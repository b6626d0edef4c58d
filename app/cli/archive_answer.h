// What the verb archive answers: objects for scripts, tables for people.
#pragma once

#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/core/json.h"

namespace lathelier::cli {

Json entryJson(const archive::Entry& entry);
Json recordJson(const archive::Record& record);
Json verificationJson(const archive::Verification& verification);

std::string entriesText(const std::vector<archive::Entry>& entries);
std::string recordText(const archive::Record& record);
std::string characteristicsText(const std::vector<archive::ArchivedCharacteristic>& characteristics);
std::string seriesText(const std::string& characteristic, const std::vector<archive::SeriesPoint>& points);
std::string verificationText(const archive::Verification& verification);

}  // namespace lathelier::cli
