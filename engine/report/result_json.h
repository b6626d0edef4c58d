// A result as one JSON object: what the command line prints, and what the window writes beside a report.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/json.h"
#include "engine/core/understanding.h"
#include "engine/report/document.h"

namespace lathelier::report {

/// Head of every object: command, version, inputs (path, bytes, sha256), parameters (all of them).
Json resultHead(const std::string& command, const std::vector<InputFile>& inputs, const Values& parameters);

/// Adds `understanding` (with gaps that count the `verdict` is undecided), `error`, of several also `errors`, and
/// `notes`, among which stands why there is no answer.
void addRemarks(Json& result, const Understanding& understanding, const std::vector<Error>& errors, const Notes& notes);

/// A whole object: head, the keys of `result`, notes.
Json wholeResult(const std::string& command, const std::vector<InputFile>& inputs, const Values& parameters,
                 const Json& result, const Notes& notes);

/// Indented by two spaces, arrays of numbers on one line; ends with a line feed.
std::string toText(const Json& json);

/// The same text, passed on in chunks as it is generated: for large objects and for cancellation.
void writeText(const Json& json, const std::function<void(std::string_view)>& append);

/// The results of a report (Document::results) as one text: a single one as it is, several as {"results": [...]}; empty
/// when there is none.
std::string joinedResults(const std::vector<std::string>& results);

}  // namespace lathelier::report
