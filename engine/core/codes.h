// The English pattern behind each code; used by texts.cpp and the tests.
#pragma once

#include "engine/core/error.h"
#include "engine/core/text.h"

namespace lathelier {

Text pattern(ErrorCode code);
Text pattern(NoteCode code);

}  // namespace lathelier
