#include "app/cli/jobs.h"

#include <nlohmann/json.hpp>

#include "app/cli/any_shaft.h"
#include "engine/cam/cam_codes.h"

namespace lathelier::cli {

cam::Job readJob(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                 Answer& answer)
{
    cam::JobFile file = cam::loadJob({path, inputs.open(path, progress), request.parameters, inputs, progress});
    answer.notes.insert(answer.notes.end(), file.notes.begin(), file.notes.end());
    return std::move(file.job);
}

Shaft partOf(const cam::Job& job, const std::string& path, const std::string& job_path, io::InputFiles& inputs,
             const Progress& progress, Answer& answer)
{
    if (path.empty()) {
        if (!job.shaft) throw Error(errors::jobWithoutShaft, {{"path", job_path}});
        return *job.shaft;
    }
    Json facts;
    Notes notes;
    try {
        Shaft part = readAnyShaft(inputs.open(path, progress), notes, facts, progress);
        for (Note& note : notes) {
            set(note.values, "path", path);
            answer.notes.push_back(std::move(note));
        }
        return part;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::cli
