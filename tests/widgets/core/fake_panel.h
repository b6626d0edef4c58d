// A panel over a small computation, to drive Panel<Result> as a user would.
#pragma once

#include <QFile>
#include <QLabel>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "engine/core/fields.h"
#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "widgets/core/panel/panel.h"

namespace lathelier {

struct FakeParameters {
    double factor_mm = 2;
    std::optional<double> tolerance_mm;
    bool endless = false;  ///< runs until it is stopped
};

inline const std::vector<Field<FakeParameters>>& fieldsOf(const FakeParameters*)
{
    static const std::vector<Field<FakeParameters>> all{
        field("factor_mm", &FakeParameters::factor_mm, {0, 100}, {Text{"Factor"}, Text{"Multiplies"}, Text{"mm"}}),
        field("tolerance_mm", &FakeParameters::tolerance_mm, {0, 10}, {Text{"Tolerance"}, Text{"Band"}, Text{"mm"}}),
        field("endless", &FakeParameters::endless, {Text{"Endless"}, Text{"Never ends"}, {}, true})};
    return all;
}

/// The number of bytes of the file times the factor.
struct FakeResult {
    double value_mm = 0;
    FakeParameters parameters;
};

class FakePanel : public Panel<FakeResult> {
public:
    /// `state`: key of a state that it shares with other panels; empty: its own.
    explicit FakePanel(Session& owner, const std::string& id = "fake", const std::string& state = {})
        : FakePanel(owner, sharing(factsOf(id), state))
    {
    }
    FakePanel(Session& owner, const PanelFacts& facts) : Panel(owner, facts, inputs()), views_(new QLabel)
    {
        setViews(views_);
    }

    /// `title`: kept for the length of the program; none: "Fake".
    static PanelFacts factsOf(const std::string& id, const std::string& question = "copy", const char* title = "Fake")
    {
        return {id,
                Text{title},
                "compare",
                questionOf(question),
                [=](Session& owner) { return new FakePanel(owner, factsOf(id, question, title)); },
                [](const project::PanelState&, Stores&, task::Sources&, const Language&, const Progress&) {
                    return report::Document{};
                }};
    }

    QString shown() const { return views_->text(); }
    int computed() const { return *computed_; }

protected:
    Compute compute(const project::PanelState& state) const override
    {
        const auto parameters = fromValues<FakeParameters>(state.parameters);
        const std::string path = state.inputs.at("file").path;
        return [parameters, path, count = computed_](const Progress& progress) {
            ++*count;
            QFile file(QString::fromStdString(path));
            if (!file.exists()) throw Error(errors::fileNotFound, {{"path", path}});
            if (file.open(QIODevice::ReadOnly) && file.peek(3) == "bad")  // found in reading only
                throw Error(errors::malformed, {{"path", path}, {"found", "bad"}, {"expected", "x"}});
            const Progress part = progress.part(0, 1, Text{"Multiplying"});
            part.report(0.5);
            while (parameters.endless) {
                part.report(0.5);
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            return std::make_shared<const FakeResult>(
                FakeResult{static_cast<double>(file.size()) * parameters.factor_mm, parameters});
        };
    }
    void showResult(const std::shared_ptr<const FakeResult>& result) override
    {
        views_->setText(QString::number(result->value_mm));
    }
    report::Answer answer(const FakeResult& result) const override
    {
        report::Answer answer;
        answer.quantity = Text{"Product"};
        answer.value = result.value_mm;
        answer.unit = Text{"mm"};
        answer.decimals = 0;
        answer.upper_limit = result.parameters.tolerance_mm;
        if (result.parameters.tolerance_mm)
            answer.verdict = judge(result.value_mm, 0, *result.parameters.tolerance_mm, DecisionRule::Simple);
        return answer;
    }
    Notes notes(const FakeResult&) const override { return {{notes::rollNotDetermined, {}}}; }
    report::Document document(const FakeResult& result) const override
    {
        report::Document report;
        report.title = std::string("Fake report");
        report.sections.push_back({std::string("Result"), {answer(result)}});
        return report;
    }

private:
    static PanelFacts sharing(PanelFacts facts, const std::string& state)
    {
        facts.state = state;
        return facts;
    }
    static PanelInputs inputs()
    {
        return {{{"file", Text{"File"}, Text{"Any file"}, true, false, {&io::scanFiles()}}},
                infos<FakeParameters>(),
                toValues(FakeParameters()),
                Text{"Drop a file."}};
    }

    QLabel* views_;
    std::shared_ptr<std::atomic<int>> computed_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace lathelier
