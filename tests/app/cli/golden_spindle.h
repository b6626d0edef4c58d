// Probe records for the golden lines of `trajectory`, made by the generator of the sample.
#pragma once

#include <functional>
#include <string>

namespace lathelier::golden {

/// spindle.csv and averages.csv (five sections, eight revolutions each, no noise), and sections, whole and broken.
void makeSpindleRecords(const std::function<void(const std::string& name, const std::string& content)>& write);

}  // namespace lathelier::golden
