// Identification of an input file.
#pragma once

#include <cstdint>
#include <string>

namespace lathelier {

/// A file as the audit names it.
struct InputFile {
    std::string path;        ///< as it was opened
    std::int64_t bytes = 0;  ///< size of the content that was read
    std::string sha256;      ///< lower-case hexadecimal
};

}  // namespace lathelier
