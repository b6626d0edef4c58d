// Files of frequency responses, for the golden lines that inspect them.
#pragma once

#include <string>

namespace lathelier::golden {

/// Adds universal files, tables and a MAT file to the folder.
void makeFrfs(const std::string& folder);

}  // namespace lathelier::golden
