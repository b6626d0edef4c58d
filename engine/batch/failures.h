// Parts without an answer: why, for people and for scripts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/json.h"

namespace lathelier::batch {

struct Failure {
    std::size_t place = 0;               ///< of the part in the list, from 0
    std::string path;                    ///< the file that the error is about, else that of the part
    int exit_code = 0;                   ///< of the verb
    std::string code;                    ///< of the error, "malformed"
    std::optional<std::int64_t> line;    ///< from 1
    std::optional<std::int64_t> column;  ///< from 1
    std::optional<std::int64_t> byte;    ///< from 0
    std::string message;                 ///< English
};

Failure failureOf(std::size_t place, const std::string& part, const Error& error);

/// Of a line of results with an exit code other than 0.
Failure failureFrom(std::size_t place, const std::string& part, const Json& line);

Json toJson(const Failure& failure);

/// file,exit_code,code,line,column,byte,message by RFC 4180, the heading always. Error fileNotWritable.
void writeFailures(const std::string& path, const std::vector<Failure>& failures);

}  // namespace lathelier::batch
