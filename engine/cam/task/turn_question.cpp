#include "engine/cam/task/turn_question.h"

#include <algorithm>
#include <map>

#include "engine/cam/post/post.h"
#include "engine/core/field_within.h"
#include "engine/task/edited_segments.h"

namespace lathelier::cam {
namespace {

// A job to begin with where no file is given.
constexpr double usualBar_mm = 40, usualChuck_mm = 110, usualAllowance_mm = 1;
constexpr double usualDepth_mm = 2, usualFeed_mm_rev = 0.25, usualSpeed_m_min = 180;
constexpr double finishFeed_mm_rev = 0.1, finishSpeed_m_min = 200;

std::vector<Field<TurningQuestion>> turningFields()
{
    using Q = TurningQuestion;
    std::vector<Field<Q>> all{
        choice("post", &Q::post, postChoices(),
               Label{LT_TEXT("Engine", "Control"),
                     LT_TEXT("Engine", "The program is written for it: a post that is built in, or POST.json.")})};
    all.back().info.is_open = true;
    all.push_back(within(&Q::plan, "setups"));
    for (const Field<Job>& inner : fields<Job>()) {
        all.push_back(within(&Q::job, inner.info.key));
        FieldInfo& info = all.back().info;
        info.is_kept = true;
        if (info.key != toolsKey) continue;
        info.minimum = 0;  // none yet: a file fills the table
        for (FieldInfo& column : info.columns)
            column.advanced = column.kind == FieldInfo::Kind::Rows || column.key == "back_margin_deg";
    }
    for (const char* key :
         {"relation", "part_model", "cycles", "optional_stops", "work_offset", "tool_change_s", skippedKey, orderKey})
        all.push_back(foldedWithin(&Q::plan, key));
    all.push_back(field(
        jobOfKey, &Q::job_of,
        Label{LT_TEXT("Engine", "Job changed from"), LT_TEXT("Engine", "The file that the form was changed from.")}));
    all.back().info.is_kept = true;
    all.push_back(
        rows(draftsKey, &Q::drafts, Range{0, 10},
             Label{LT_TEXT("Engine", "Changed programs"),
                   LT_TEXT("Engine", "Programs that were changed by hand and stand in place of planned ones."),
                   {},
                   true}));
    all.back().info.is_kept = true;
    return all;
}

}  // namespace

std::vector<FieldChoice> postChoices()
{
    std::vector<FieldChoice> choices;
    for (const std::string& name : postNames()) choices.push_back({name, labelOfPost(name)});
    return choices;
}

Text labelOfPost(const std::string& post)
{
    static const std::map<std::string, std::string> labels = [] {  // as long as the program: a Text points to them
        std::map<std::string, std::string> all;
        for (const std::string& name : postNames()) {
            const std::string label = postNamed(name).label;
            all.emplace(name, label.empty() ? name : label);
        }
        return all;
    }();
    const auto found = labels.find(post);
    return found == labels.end() ? Text{} : Text{found->second.c_str()};
}

TurningQuestion::TurningQuestion()
{
    job.stock.diameter_mm = usualBar_mm;
    job.stock.face_allowance_mm = usualAllowance_mm;
    job.setup.chuck_face_z_mm = usualChuck_mm;
    job.cutting.rough = {usualDepth_mm, usualFeed_mm_rev, usualSpeed_m_min};
    job.cutting.finish = {finishFeed_mm_rev, finishSpeed_m_min};
}

const std::vector<Field<TurningDraft>>& fieldsOf(const TurningDraft*)
{
    using D = TurningDraft;
    static const auto all = described<D>(
        field("setup", &D::setup, {1, 2}, Label{LT_TEXT("Engine", "Clamping"), LT_TEXT("Engine", "First or second.")}),
        field("of_sha256", &D::of_sha256,
              Label{LT_TEXT("Engine", "Changed from"),
                    LT_TEXT("Engine", "SHA-256 of the program before."),
                    {},
                    false,
                    true}),
        field("text", &D::text, Label{LT_TEXT("Engine", "Program"), LT_TEXT("Engine", "As changed."), {}, false, true}),
        field("checked_sha256", &D::checked_sha256,
              Label{LT_TEXT("Engine", "Checked"), LT_TEXT("Engine", "SHA-256 of the text that was checked.")}));
    return all;
}

const std::vector<Field<TurningQuestion>>& fieldsOf(const TurningQuestion*)
{
    static const auto all = turningFields();
    return all;
}

std::string identity(const project::PanelState& state)
{
    return task::identity(state, jobRole);
}

bool formRules(const TurningQuestion& question, const project::PanelState& state)
{
    return !question.job.tools.empty() && question.job_of == identity(state);
}

bool hasTools(const project::PanelState& state)
{
    const Value* const tools = find(state.parameters, toolsKey);
    const Rows* const rows = tools ? std::get_if<Rows>(tools) : nullptr;
    return rows && !rows->rows.empty();
}

}  // namespace lathelier::cam
