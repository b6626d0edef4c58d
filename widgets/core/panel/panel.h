// Panel = inputs → engine call → views.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "widgets/core/panel/panel_base.h"
#include "widgets/core/session.h"

namespace lathelier {

/// A panel whose answer is a `Result`. A concrete panel says how to compute it and how to show it; files, form,
/// progress, cancel, answer, notes, messages, exports and reports are PanelBase's.
///
///     class ComparePanel : public Panel<CompareOutcome> {
///         explicit ComparePanel(Session& session) : Panel(session, compareFacts(), inputs()) { setViews(…); }
///         …
template <class Result>
class Panel : public PanelBase {
public:
    using PanelBase::PanelBase;

    /// The shown result; nullptr before the first one.
    std::shared_ptr<const Result> result() const { return result_; }

protected:
    using Compute = std::function<std::shared_ptr<const Result>(const Progress&)>;

    /// The computation for `state`, whose required inputs are all given. Called in the GUI thread; the returned
    /// function runs in the worker and must own all data it uses (objects of session().stores(), copies of values). It
    /// loads the files.
    virtual Compute compute(const project::PanelState& state) const = 0;

    virtual void showResult(const std::shared_ptr<const Result>& result) = 0;
    virtual report::Answer answer(const Result& result) const = 0;
    virtual Notes notes(const Result& result) const = 0;
    virtual report::Document document(const Result& result) const = 0;

    /// Reason why there is a result to show (facts of a file) but no answer.
    virtual std::optional<Error> problem(const Result&) const { return std::nullopt; }

private:
    Worker::Job makeJob(const project::PanelState& state) const final
    {
        return [compute = compute(state)](const Progress& progress) -> std::shared_ptr<const void> {
            return compute(progress);
        };
    }
    void showValue(std::shared_ptr<const void> value) final
    {
        result_ = std::static_pointer_cast<const Result>(std::move(value));
        showResult(result_);
    }
    report::Answer answerOf(const void* value) const final { return answer(*static_cast<const Result*>(value)); }
    Notes notesOf(const void* value) const final { return notes(*static_cast<const Result*>(value)); }
    report::Document documentOf(const void* value) const final { return document(*static_cast<const Result*>(value)); }
    std::optional<Error> problemOf(const void* value) const final
    {
        return problem(*static_cast<const Result*>(value));
    }

    std::shared_ptr<const Result> result_;
};

}  // namespace lathelier
