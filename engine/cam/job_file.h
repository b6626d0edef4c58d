// JOB.json: the described fields of Job and the shaft within, errors with line and column.
#pragma once

#include <string>

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/io/file_kind.h"

namespace lathelier::cam {

/// Corners ("holder", "keep_out") may be lists of two numbers. Errors with line and column: malformed, keyMissing
/// (stock.diameter_mm, setup.chuck_face_z_mm, tools, cutting.rough, cutting.finish), keyOutOfRange. Notes: unknownKey.
/// Tools are filled from the library (job_library.h): toolNotInLibrary. The rules of job_rules.h are not checked here.
Job readJob(const std::string& json, Notes& notes);

/// The text of a file that readJob() reads to the same bits.
std::string jobText(const Job& job);

/// A job with the facts and notes of its file.
struct JobFile {
    Job job;
    io::FileFacts facts;  ///< as jobFiles() has them
    Notes notes;          ///< of the reading, with the path
};

/// In any encoding. Errors of readJob() and fileEmpty, with the path.
JobFile loadJob(const io::FileToRead& file);

/// JOB.json. facts: format "job_json"; details "title", "tools" (count), "segments" (of its shaft, or null),
/// "stock_diameter_mm".
const io::FileKind& jobFiles();

}  // namespace lathelier::cam
