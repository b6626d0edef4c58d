// The files the golden lines speak of, made by the test itself.
#pragma once

#include <string>

namespace lathelier::golden {

/// Fills the folder: see golden_data.cpp for the names.
void makeData(const std::string& folder);

}  // namespace lathelier::golden
