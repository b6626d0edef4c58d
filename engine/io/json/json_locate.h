// The place in a file that an error is about, where the rule that was broken was looked at after the file was read.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/io/json/json_text.h"

namespace lathelier::io {

/// Adds line and column of the value at `where`, of the object around it where it is missing. The error stays as it is
/// where the text is no JSON.
void locate(Error& error, std::string_view text, const JsonPath& where);

/// The same in a file, which becomes the error's `path`. A file that cannot be read again gives the path alone.
void locateInFile(Error& error, const std::string& path, const JsonPath& where);

/// Errors that name a row of a shaft (`row` or `segment`, from 1; `contour`, where it is one of a bore): the place of
/// this row in the shaft at `shaft` in a file. Of a bore, that of the list of bores.
void locateRow(Error& error, const std::string& path, const JsonPath& shaft = {});

}  // namespace lathelier::io
