#include "widgets/turning/turning_question.h"

#include <algorithm>
#include <array>

#include "engine/core/field_within.h"
#include "widgets/core/form/input_column.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::turning_panel {
namespace {

constexpr std::array posts{"fanuc_a", "fanuc_b", "haas", "sinumerik", "linuxcnc", "grbl"};

// A job to begin with where no file is given.
constexpr double usualBar_mm = 40, usualChuck_mm = 110, usualAllowance_mm = 1;
constexpr double usualDepth_mm = 2, usualFeed_mm_rev = 0.25, usualSpeed_m_min = 180;
constexpr double finishFeed_mm_rev = 0.1, finishSpeed_m_min = 200;

std::vector<FieldChoice> postChoices()
{
    return {{posts[0], LT_TEXT("Engine", "Fanuc, system A")},
            {posts[1], LT_TEXT("Engine", "Fanuc, system B")},
            {posts[2], LT_TEXT("Engine", "Haas")},
            {posts[3], LT_TEXT("Engine", "Sinumerik")},
            {posts[4], LT_TEXT("Engine", "LinuxCNC")},
            {posts[5], LT_TEXT("Engine", "GRBL")}};
}

std::vector<Field<TurningQuestion>> allFields()
{
    using Q = TurningQuestion;
    std::vector<Field<Q>> all{
        field("post", &Q::post, postChoices(),
              Label{LT_TEXT("Engine", "Control"), LT_TEXT("Engine", "The program is written for it.")})};
    all.push_back(within(&Q::plan, "setups"));
    for (const Field<cam::Job>& inner : fields<cam::Job>()) {
        all.push_back(within(&Q::job, inner.info.key));
        FieldInfo& info = all.back().info;
        if (info.key != toolsKey) continue;
        info.minimum = 0;  // none yet: a file fills the table
        for (FieldInfo& column : info.columns)
            column.advanced = column.kind == FieldInfo::Kind::Rows || column.key == "back_margin_deg";
    }
    for (const char* key : {"relation", "part_model", "cycles", "tool_change_s", skippedKey, orderKey})
        all.push_back(foldedWithin(&Q::plan, key));
    all.push_back(field(
        jobOfKey, &Q::job_of,
        Label{LT_TEXT("Engine", "Job changed from"), LT_TEXT("Engine", "The file that the form was changed from.")}));
    all.push_back(
        rows(draftsKey, &Q::drafts, Range{0, 10},
             Label{LT_TEXT("Engine", "Changed programs"),
                   LT_TEXT("Engine", "Programs that were changed by hand and stand in place of planned ones."),
                   {},
                   true}));
    return all;
}

bool hasTools(const project::PanelState& state)
{
    const Value* const tools = find(state.parameters, toolsKey);
    const Rows* const rows = tools ? std::get_if<Rows>(tools) : nullptr;
    return rows && !rows->rows.empty();
}

}  // namespace

const char* nameOf(PostChoice post)
{
    return posts.at(static_cast<std::size_t>(post));
}

Text labelOf(PostChoice post)
{
    return postChoices().at(static_cast<std::size_t>(post)).label;
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
    static const auto all = allFields();
    return all;
}

bool isOfJob(const std::string& key)
{
    const auto& all = fields<cam::Job>();
    return std::any_of(all.begin(), all.end(), [&](const Field<cam::Job>& field) { return field.info.key == key; });
}

Values jobValues(const cam::Job& job)
{
    return toValues(job);
}

std::string identity(const project::PanelState& state)
{
    const auto source = state.inputs.find(jobRole);
    return source == state.inputs.end() ? std::string() : source->second.path;
}

bool formRules(const TurningQuestion& question, const project::PanelState& state)
{
    return !question.job.tools.empty() && question.job_of == identity(state);
}

bool formRules(const project::PanelState& state)
{
    const Value* const of = find(state.parameters, jobOfKey);
    const auto* const stated = of ? std::get_if<std::string>(of) : nullptr;
    return hasTools(state) && identity(state) == (stated ? *stated : std::string());
}

void setJob(project::PanelState& state, const Values& job)
{
    for (const auto& [key, value] : job) set(state.parameters, key, value);
    set(state.parameters, jobOfKey, identity(state));
}

void openJob(project::PanelState& state, const std::string& path)
{
    state.inputs[jobRole] = newSource(QString::fromStdString(path));
    set(state.parameters, toolsKey, Rows{});
    set(state.parameters, jobOfKey, std::string());
    set(state.parameters, skippedKey, Rows{});
    set(state.parameters, orderKey, Rows{});
}

std::vector<Text> missingInputs(const project::PanelState& state)
{
    const bool has_file = state.inputs.count(jobRole) > 0;
    std::vector<Text> missing;
    if (!has_file && !hasTools(state)) missing.push_back(LT_TEXT("Engine", "Job or tools"));
    if (!has_file && state.inputs.count(part_common::shaftRole) == 0) missing.push_back(LT_TEXT("Engine", "Shaft"));
    return missing;
}

}  // namespace lathelier::turning_panel
