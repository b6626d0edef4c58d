// Images as a kind of file: PNG, JPEG, TIFF.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::io {

const FileKind& imageFiles();

}  // namespace lathelier::io
