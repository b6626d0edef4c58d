// Why a database did not do what it was asked: the reasons of errors, alike for both drivers.
#pragma once

#include "engine/core/text.h"

namespace lathelier::archive::sql::reasons {

inline constexpr Text diskFull = LT_TEXT("Engine", "the disk is full");
inline constexpr Text readOnly = LT_TEXT("Engine", "it can only be read");
inline constexpr Text notPermitted = LT_TEXT("Engine", "this role may not do that");
inline constexpr Text held = LT_TEXT("Engine", "another program holds it");
inline constexpr Text damaged = LT_TEXT("Engine", "the file is damaged");
inline constexpr Text memory = LT_TEXT("Engine", "there is not enough memory");
inline constexpr Text connectionLost = LT_TEXT("Engine", "the connection to the server was lost");
inline constexpr Text tooSlow = LT_TEXT("Engine", "the server took too long");
inline constexpr Text noServer = LT_TEXT("Engine", "the server does not answer");

}  // namespace lathelier::archive::sql::reasons
