// What the three panels of workspace Roundness share: their state, assignment and facts of files, one computation, one
// chosen section and one marked angle.
#pragma once

#include <QObject>

#include "widgets/core/panel/panel.h"
#include "widgets/trajectory_common/spindle_outcome.h"

namespace lathelier::trajectory_common {

/// The angle that all views of the workspace mark, seen from the part, 0…360°. Lives in the GUI thread, one for each
/// session (Stores).
class MarkedAngle : public QObject {
    Q_OBJECT

public:
    std::optional<double> angle_deg() const { return angle_deg_; }
    void set(std::optional<double> angle_deg);
    void takeBack();  ///< the last set(): undoes the last set(), which was the first half of a double click

signals:
    void changed();

private:
    std::optional<double> angle_deg_;
    std::optional<double> before_deg_;
};

/// The panel's entry in the panel table without its factory and report.
PanelFacts spindleFacts(const std::string& id, Text title, const QString& icon, SpindleStudyKind studyKind);

/// The inputs of a panel; of the engine's parameters those with these keys, in this order, none of them folded away but
/// the `advanced` ones.
PanelInputs spindleInputs(const std::vector<const InputRole*>& roles, const std::vector<std::string>& plain,
                          const std::vector<std::string>& advanced, Text invitation);

class SpindlePanel : public Panel<SpindleOutcome> {
    Q_OBJECT

public:
    SpindlePanel(Session& session, const PanelFacts& facts, const PanelInputs& inputs, SpindleStudyKind studyKind,
                 QWidget* parent = nullptr);

    /// The section with this number for all panels of the workspace; none: the worst one. One undo step for a row of
    /// such choices.
    void chooseSection(std::optional<int> section);
    bool isSectionChosen() const;

    MarkedAngle& markedAngle() const { return *angle_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    Notes notes(const SpindleOutcome& outcome) const override { return outcome.notes; }
    std::optional<Error> problem(const SpindleOutcome& outcome) const override { return outcome.problem; }
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;

    /// Changes one shared parameter: one undo step, or one with its neighbours of the same `mergeKey`.
    void setParameter(const std::string& key, const Value& value, const QString& step, const QString& mergeKey = {});

private:
    SpindleStudyKind studyKind_;
    std::shared_ptr<MarkedAngle> angle_;
};

}  // namespace lathelier::trajectory_common
