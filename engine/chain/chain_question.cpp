#include "engine/chain/chain_question.h"

#include <filesystem>

#include "engine/core/error.h"
#include "engine/core/units.h"
#include "engine/io/io_codes.h"

namespace lathelier::chain {
namespace {

Label labelled(Text label, Text help, bool required = false)
{
    Label made{label, help};
    made.required = required;
    return made;
}

}  // namespace

const std::vector<FieldChoice>& cutsInPicture()
{
    static const std::vector<FieldChoice> all{{"unknown", LT_TEXT("Engine", "not known")},
                                              {"down", LT_TEXT("Engine", "down")},
                                              {"up", LT_TEXT("Engine", "up")}};
    return all;
}

const std::vector<Field<ChainQuestion>>& fieldsOf(const ChainQuestion*)
{
    using Q = ChainQuestion;
    static const std::vector<Field<Q>> all{
        field("out", &Q::out,
              labelled(LT_TEXT("Engine", "Folder"),
                       LT_TEXT("Engine", "Where every file goes; made when it is missing."), true)),
        field("machine", &Q::machine,
              labelled(LT_TEXT("Engine", "Machine"),
                       LT_TEXT("Engine", "The spindle at the chuck face, from SPINDLE.json; else that of the shop."))),
        field("job", &Q::job,
              labelled(LT_TEXT("Engine", "Job"),
                       LT_TEXT("Engine", "Stock, set-up, tools and cutting data, from JOB.json; else from the shop."))),
        field(
            "setup", &Q::setup,
            labelled(LT_TEXT("Engine", "Set-up of deflection"),
                     LT_TEXT("Engine",
                             "SETUP.json; without a stock of its own it takes the job's bar; else from the shop, where "
                             "the job is too or a SHOP.json is stated."))),
        field("shop", &Q::shop,
              labelled(LT_TEXT("Engine", "Shop"),
                       LT_TEXT("Engine",
                               "Makes what is not given of machine, job and set-up, marked as assumed: SHOP.json, or "
                               "built-in; empty: their steps are missing."))),
        field("copy", &Q::copy,
              labelled(LT_TEXT("Engine", "Copy"), LT_TEXT("Engine", "The scan of the machined copy."))),
        field("drawing", &Q::drawing,
              labelled(LT_TEXT("Engine", "Drawing"),
                       LT_TEXT("Engine", "SHAFT.json that somebody has confirmed, in place of what was recognised."))),
        field("confirmed_by", &Q::confirmed_by,
              labelled(LT_TEXT("Engine", "Confirmed by"), LT_TEXT("Engine", "Who answers for the drawing."))),
        field("post", &Q::post,
              labelled(LT_TEXT("Engine", "Post"),
                       LT_TEXT("Engine",
                               "Control that the program is for: fanuc_a, fanuc_b, haas, sinumerik, linuxcnc, grbl, "
                               "or POST.json."))),
        field("tolerance_mm", &Q::tolerance_mm, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Tolerance of the copy"), LT_TEXT("Engine", "Of its surface, to both sides."),
                    unit::mm}),
        field("tolerance_um", &Q::tolerance_um, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Tolerance of the predicted diameter"), LT_TEXT("Engine", "To both sides."),
                    unit::um}),
        field("photograph_before", &Q::photograph_before,
              labelled(LT_TEXT("Engine", "Photograph before"),
                       LT_TEXT("Engine", "Of the turned surface before the speeds were chosen anew."))),
        field("photograph_after", &Q::photograph_after,
              labelled(LT_TEXT("Engine", "Photograph after"),
                       LT_TEXT("Engine", "Of the same surface on the copy, taken alike."))),
        field("photograph_z_mm", &Q::photograph_z_mm, Range{0, 1e5},
              Label{LT_TEXT("Engine", "Place of the photographs"),
                    LT_TEXT("Engine", "z from the free end: diameter and speed there turn marks into frequencies."),
                    unit::mm}),
        field("photograph_mm_px", &Q::photograph_mm_px, Range{1e-6, 1e3},
              Label{LT_TEXT("Engine", "Scale of the photographs"), LT_TEXT("Engine", "Width of a pixel."), unit::mm}),
        field("photograph_feed_deg", &Q::photograph_feed_deg, Range{-360, 360},
              Label{LT_TEXT("Engine", "Direction of feed in the photographs"),
                    LT_TEXT("Engine", "From right toward down; without it both signs of the marks stay open."),
                    unit::deg}),
        field("photograph_cut", &Q::photograph_cut, cutsInPicture(),
              labelled(LT_TEXT("Engine", "Direction of cut in the photographs"),
                       LT_TEXT("Engine", "Of later points of a track, the feed pointing right."))),
        field(
            "resume", &Q::resume,
            Label{LT_TEXT("Engine", "Go on"),
                  LT_TEXT("Engine", "Take over the steps in the folder whose files and questions are as they were.")})};
    return all;
}

const std::vector<std::string>& recognitionKeys()
{
    static const std::vector<std::string> keys{
        "snap",           "form_tolerance_mm", "unexplained",       "scanner_accuracy_mm",
        "scene",          "exclude_z_mm",      "free_end",          "length_mm",
        "accepted_sizes", "library_material",  "general_tolerances"};
    return keys;
}

void refuseOverwriting(const ChainQuestion& question)
{
    for (const std::string& path :
         {question.scan, question.machine, question.job, question.setup, question.shop, question.copy, question.drawing,
          question.photograph_before, question.photograph_after}) {
        std::error_code ignored;
        const std::filesystem::path file(path);
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
        const bool is_file = !path.empty() && path != shop::builtInName;
        if (is_file && std::filesystem::equivalent(folder, question.out, ignored))
            throw Error(errors::outputIsInput, {{"parameter", "--out"}, {"file", path}});
    }
}

}  // namespace lathelier::chain
