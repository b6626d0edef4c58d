// Outcome of the panel Surface: that of the task with its pictures prepared for drawing.
#pragma once

#include <QImage>
#include <string>
#include <vector>

#include "engine/surface/stripes.h"
#include "engine/surface/task/surface_task.h"

namespace lathelier::surface_panel {

/// One picture, prepared for drawing.
struct ShownImage {
    std::string name;                            ///< name of the file or of the generated picture
    QImage photograph;                           ///< as the file has it, grey
    QImage evaluated;                            ///< unrolled and made smaller, grey
    QImage flat;                                 ///< without its uneven light
    std::vector<surface::Stripe> feed_stripes;   ///< crests of the feed marks in `flat`
    std::vector<surface::Stripe> chatter_bands;  ///< crests of the chatter marks in `flat`
};

struct ShownOutcome : surface::SurfaceOutcome {
    std::vector<ShownImage> shown;  ///< pictures, one or two
    QImage before, after;           ///< of two pictures: one scale, direction, size and grey
    double common_mm_per_px = 0;    ///< of these two; 0: not known
    surface::Vector laid;           ///< shift that was taken off the second one, in its pixels

    bool isLaid() const { return question.lay_right_px || question.lay_down_px; }  ///< true: aligned by two clicks
};

/// The answer of the task, prepared; thread-safe. Error: of the first picture that cannot be read. Throws Cancelled.
ShownOutcome answerAndPrepare(const project::PanelState& state, Stores& stores, task::Sources& sources,
                              const Progress& progress);

}  // namespace lathelier::surface_panel
