// Outcome of the panel Surface: the marks of one or two pictures, prepared for drawing.
#pragma once

#include <QImage>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/stability/marks_item.h"
#include "engine/stability/speed_choice.h"
#include "engine/surface/stripes.h"
#include "engine/surface/surface.h"
#include "engine/task/stores.h"
#include "widgets/surface/surface_question.h"

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

struct SurfaceOutcome {
    SurfaceQuestion question;                              ///< question of the request
    std::vector<ShownImage> shown;                         ///< pictures, one or two
    std::shared_ptr<const surface::SurfaceResult> result;  ///< null: see `refused`
    std::optional<Error> refused;                          ///< error of the evaluation of the pictures; none: evaluated
    QImage before, after;                                  ///< of two pictures: one scale, direction, size and grey
    double common_mm_per_px = 0;                           ///< of these two; 0: not known
    surface::Vector laid;                                  ///< shift that was taken off the second one, in its pixels
    std::shared_ptr<const stability::LobeResult> model;    ///< about the speed of the cut; null: none given
    std::optional<stability::SurfaceMarks> marks;          ///< the first picture's, if it has a frequency
    std::optional<stability::ModelCheck> check;            ///< of the marks by the model
    std::optional<stability::SpeedResult> next;            ///< speed in place of that of the cut; where the two agree
    std::vector<InputFile> inputs;                         ///< pictures and response
    Notes notes;                                           ///< of files and result
    bool synthetic = false;                                ///< a source is marked as synthetic, or the picture was made
    std::string made_png;                                  ///< the picture that was made, as a file; empty: none

    bool asks() const { return isAsking(question); }  ///< true: an open question, results are hidden
    bool isLaid() const { return question.lay_right_px || question.lay_down_px; }  ///< true: aligned by two clicks
    const surface::ImageMarks& first() const { return result->images.front(); }
};

/// Reads or generates, evaluates, prepares; thread-safe. Errors: those of the readers. Throws Cancelled.
SurfaceOutcome surfaceOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

}  // namespace lathelier::surface_panel
