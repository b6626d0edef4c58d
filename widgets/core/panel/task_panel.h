// A panel over a task: inputs, form, report, exports and files follow from its description; the panel adds views.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/task/task.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/panel.h"

namespace lathelier {

/// Inputs of the task as those of a panel, in this order.
std::vector<InputRole> rolesOf(const task::Task& task, const std::vector<std::string>& roles);

/// The left column. `unfolded`: keys of the fields that are open, in order; `rest`: whether the others follow, folded,
/// but for those of `without`. Fields that a window keeps are not in the form.
PanelInputs inputsOf(const task::Task& task, const std::vector<std::string>& roles,
                     const std::vector<std::string>& unfolded, bool rest, Text invitation,
                     const std::vector<std::string>& without = {});

/// Folds all fields but these, in the order of the form.
void foldAllBut(PanelInputs& inputs, const std::vector<std::string>& unfolded);

/// Id, title, kinds, roles, items and the report of a panel with these inputs. `begins_with`: values that the panel
/// begins with in place of the task's defaults.
PanelFacts factsOf(const task::Task& task, const char* id, const char* icon, const std::vector<std::string>& roles,
                   const task::Wanted& wanted, const Values& begins_with = {});

/// The state with what is not given yet.
project::PanelState filledWith(project::PanelState state, const Values& values);

/// Opens a shaft; a table of segments, which would rule over it, is emptied.
void openShaft(project::PanelState& state, const std::string& role, const std::string& path);

/// Assigns files to the inputs that take their kind; those of no kind to the last one.
void assignByKind(project::PanelState& state, const std::vector<InputRole>& roles, const std::vector<FoundFile>& files);

/// Reads the inputs that are given.
Worker::Job readingOf(const task::Task& task, const project::PanelState& state, std::shared_ptr<Stores> stores);

/// A parameter that an answer lacks, by its label in place of its key; other errors as they are.
Error neededBy(const task::Task& task, const Error& error);

/// The exports that the outcome can be written as.
std::vector<PanelExport> exportsOf(const task::Task& task, const std::shared_ptr<const task::Outcome>& outcome);

/// What the outcome makes of this kind; none: not possible.
std::optional<task::Product> productOf(const task::Outcome& outcome, const std::string& kind, const std::string& part);

/// PanelFacts::answer by a function to the typed outcome R; outcomeOf(shared_ptr<const R>).
template <class R>
auto answeredBy(R (*answer)(const project::PanelState&, Stores&, task::Sources&, const Progress&))
{
    return [answer](const project::PanelState& state, Stores& stores, task::Sources& sources,
                    const Progress& progress) -> walk::PlaceAnswer {
        const auto value = std::make_shared<const R>(answer(state, stores, sources, progress));
        return {value, outcomeOf(value), value->sources.synthetic};
    };
}

/// R: the typed outcome of the task, with `asked` (the state), `sources` and `notes`; that of PanelFacts::answer.
template <class R>
class TaskPanel : public Panel<R> {
public:
    TaskPanel(Session& owner, const PanelFacts& facts, const PanelInputs& inputs, QWidget* parent)
        : Panel<R>(owner, facts, inputs, parent), task_(*facts.task)
    {
    }

protected:
    /// What is missing comes from the part's other questions: in the worker, where they are answered too.
    typename Panel<R>::Compute compute(const project::PanelState& state) const override
    {
        for (const FieldInfo& field : task_.fields)  // ranges are checked before the computation
            if (const Value* const given = find(state.parameters, field.key)) check(field, *given);
        return [state, id = this->facts().id, answer = this->facts().answer, walk = this->session().walk(),
                stores = this->session().sharedStores()](const Progress& progress) {
            if (walk->place(id)) return std::static_pointer_cast<const R>(walk->answer(id, progress)->value);
            task::Sources sources;
            return std::static_pointer_cast<const R>(answer(state, *stores, sources, progress).value);
        };
    }
    Notes notes(const R& outcome) const override { return outcome.notes; }
    report::Answer answer(const R& outcome) const override { return whole(outcome).answer(screenLanguage()); }
    report::Document document(const R& outcome) const override
    {
        return documentOf(task_, outcome.asked, outcome.sources, whole(outcome), screenLanguage());
    }
    std::vector<PanelExport> exports() const override
    {
        const auto outcome = this->result();
        if (!outcome) return {};
        return exportsOf(task_, std::make_shared<const task::Outcome>(outcomeOf(outcome)));
    }
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override
    {
        assignByKind(state, this->inputs().roles, files);
    }
    Worker::Job makeReadingJob(const project::PanelState& state) const override
    {
        return readingOf(task_, state, this->session().sharedStores());
    }

    /// Offers the project what the outcome makes of this kind; `part`: of several.
    void offer(const std::string& kind, int part = -1)
    {
        const auto outcome = this->result();
        if (!outcome) return;
        const auto made = productOf(outcomeOf(outcome), kind, part < 0 ? std::string() : std::to_string(part));
        if (!made) return;
        try {
            this->offerItem(made->name, kind, made->values(), outcome->sources.synthetic);
        } catch (const Error& error) {
            emit this->messageRaised({error, this->facts().title});
        }
    }

private:
    /// Valid while `outcome` is.
    static task::Outcome whole(const R& outcome)
    {
        return outcomeOf(std::shared_ptr<const R>(std::shared_ptr<const R>(), &outcome));
    }

    const task::Task& task_;
};

}  // namespace lathelier
