// Question of the panel Turning program: control, clampings, and the job, from its file or from the form.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/job.h"
#include "engine/cam/plan.h"
#include "engine/project/project.h"

namespace lathelier::turning_panel {

inline constexpr const char* jobRole = "job";          ///< of the input; besides: shaftRole, spindleRole
inline constexpr const char* jobOfKey = "job_of";      ///< key of job_of; not in the form
inline constexpr const char* toolsKey = "tools";       ///< of the job
inline constexpr const char* skippedKey = "skipped";   ///< of the plan; edited in the list of operations
inline constexpr const char* orderKey = "order";       ///< of the plan; edited in the list of operations
inline constexpr const char* draftsKey = "drafts";     ///< programs changed by hand; made by the editor
inline constexpr const char* postRole = "post_file";   ///< of the input in place of a built-in post
inline constexpr const char* programRole = "program";  ///< of the input in place of a planned program

/// The posts that are built in.
enum class PostChoice { FanucA, FanucB, Haas, Sinumerik, LinuxCnc, Grbl };

/// As cam::postNamed() takes it.
const char* nameOf(PostChoice post);
Text labelOf(PostChoice post);  ///< shown label

/// A program that was changed by hand.
struct TurningDraft {
    int setup = 1;               ///< clamping, 1 or 2
    std::string of_sha256;       ///< of the program before the changes
    std::string text;            ///< the whole program, UTF-8
    std::string checked_sha256;  ///< of the text that was asked to be checked; another one: its check is void
    friend bool operator==(const TurningDraft&, const TurningDraft&) = default;
};

const std::vector<Field<TurningDraft>>& fieldsOf(const TurningDraft*);

struct TurningQuestion {
    PostChoice post = PostChoice::FanucA;  ///< control that the program is for
    cam::TurningParameters plan;           ///< clampings, relation, part, operations that are left out
    cam::Job job;                          ///< job of the form; has precedence if it has tools
    std::string job_of;                    ///< identity() of the file that the form was changed from
    std::vector<TurningDraft> drafts;      ///< changes by hand, at most one for each clamping

    TurningQuestion();
};

const std::vector<Field<TurningQuestion>>& fieldsOf(const TurningQuestion*);

/// Whether this is the key of a field of the job.
bool isOfJob(const std::string& key);

/// The job as values of the form.
Values jobValues(const cam::Job& job);

/// Identity of the job file; empty without one.
std::string identity(const project::PanelState& state);

/// Whether the form has precedence over the file.
bool formRules(const TurningQuestion& question, const project::PanelState& state);

bool formRules(const project::PanelState& state);

/// Stores the job in the form, assigned to the present file.
void setJob(project::PanelState& state, const Values& job);

/// Clears the form when a file is opened, which it would override.
void openJob(project::PanelState& state, const std::string& path);

/// Whether there is a job, and a part or a file that may contain one.
std::vector<Text> missingInputs(const project::PanelState& state);

}  // namespace lathelier::turning_panel
