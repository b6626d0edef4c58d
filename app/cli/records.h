// Reading the profiles and probe records of a request.
#pragma once

#include "app/cli/verb.h"
#include "engine/io/probe_reader.h"
#include "engine/io/profile_reader.h"

namespace lathelier::cli {

/// Reads one profile as the request's options say; what the reader notes goes into the answer.
ProfileFile readProfile(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                        Answer& answer);

/// The same for a file that is open already.
ProfileFile readProfile(const std::string& path, std::string_view bytes, const Request& request,
                        const Progress& progress, Answer& answer);

/// Reads one record, with the partner of an L-Graph file.
ProbeFile readRecord(const std::string& path, const Request& request, InputFiles& inputs, const Progress& progress,
                     Answer& answer);

/// The same for a file that is open already.
ProbeFile readRecord(const std::string& path, std::string_view bytes, const Request& request, InputFiles& inputs,
                     const Progress& progress, Answer& answer);

/// What a file holds; None: a cloud, a mesh, or nothing that is known.
enum class RecordKind { None, Profile, ProbeRecord, Qdas };
RecordKind kindOf(const std::string& path, std::string_view bytes, const Request& request);

}  // namespace lathelier::cli
