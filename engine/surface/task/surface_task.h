// The task surface: marks on photographs of turned surfaces, the vibration that made them, and a model beside them. The
// verb and the panel Surface.
//
// The pictures of the command line are those of the role "before", in their order; a window has one before and one
// after. A picture that is made stands in place of the files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/stability/marks_item.h"
#include "engine/stability/speed_choice.h"
#include "engine/surface/surface.h"
#include "engine/surface/task/surface_question.h"
#include "engine/task/task.h"

namespace lathelier::surface {

struct SurfaceOutcome : task::Answered {
    SurfaceQuestion question;
    project::PanelState stated;                          ///< as the command line states it: statedValues()
    std::vector<NamedImage> images;                      ///< in their order, or the one that was made
    std::vector<std::string> names;                      ///< of the files, without folder
    std::string made_png;                                ///< the picture that was made, as a file; empty: none
    std::vector<Error> unread;                           ///< pictures that cannot be read: then nothing is evaluated
    std::shared_ptr<const SurfaceResult> result;         ///< null: see `unread` and `refused`
    std::optional<Error> refused;                        ///< of the evaluation of the pictures; none: evaluated
    std::optional<stability::SurfaceMarks> marks;        ///< the first picture's, if it has a frequency
    std::shared_ptr<const stability::LobeResult> model;  ///< about the speed of the cut; null: none given
    std::optional<stability::ModelCheck> check;          ///< of the marks by the model
    std::optional<stability::SpeedResult> next;          ///< speed in place of that of the cut; where the two agree

    bool asks() const { return isAsking(question); }  ///< true: an open question, results are hidden
    const ImageMarks& first() const { return result->images.front(); }
};

/// Another light, answer or model evaluates no picture anew. Pictures that cannot be read or evaluated, and a response
/// that cannot be used, are part of the outcome. Throws Cancelled.
SurfaceOutcome answerSurface(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const SurfaceOutcome>& outcome);

const task::Task& surfaceTask();

}  // namespace lathelier::surface
