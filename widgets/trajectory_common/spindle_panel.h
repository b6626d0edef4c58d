// What the three panels of workspace Roundness share: their state, where files go, what was understood of them, one
// computation, one chosen section and one marked angle.
#pragma once

#include <QObject>

#include "widgets/core/panel/panel.h"
#include "widgets/trajectory_common/spindle_picture.h"

namespace lathelier::trajectory_common {

/// The angle that all views of the workspace mark, seen from the part, 0…360°. Lives in the GUI thread, one for each
/// session (Stores).
class MarkedAngle : public QObject {
    Q_OBJECT

public:
    std::optional<double> angle_deg() const { return angle_deg_; }
    void set(std::optional<double> angle_deg);
    void takeBack();  ///< the last set(): it was the first half of a double click

signals:
    void changed();

private:
    std::optional<double> angle_deg_;
    std::optional<double> before_deg_;
};

/// The panel's line of the panel table, but for its maker and what it reports.
PanelFacts spindleFacts(const std::string& id, Text title, const QString& icon, SpindleWant want);

/// The inputs of a panel; of the engine's parameters those with these keys, in this order, none of them folded away but
/// the `advanced` ones.
PanelInputs spindleInputs(const std::vector<const InputRole*>& roles, const std::vector<std::string>& plain,
                          const std::vector<std::string>& advanced, Text invitation);

class SpindlePanel : public Panel<SpindlePicture> {
    Q_OBJECT

public:
    SpindlePanel(Session& session, const PanelFacts& facts, const PanelInputs& inputs, SpindleWant want,
                 QWidget* parent = nullptr);

    /// The section with this number for all panels of the workspace; none: the worst one. One undo step for a row of
    /// such choices.
    void chooseSection(std::optional<int> section);
    bool isSectionChosen() const;

    MarkedAngle& markedAngle() const { return *angle_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    Notes notes(const SpindlePicture& picture) const override { return picture.notes; }
    std::optional<Error> problem(const SpindlePicture& picture) const override { return picture.problem; }
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;

    /// Changes one shared parameter: one undo step, or one with its neighbours of the same `mergeKey`.
    void setParameter(const std::string& key, const Value& value, const QString& step, const QString& mergeKey = {});

private:
    SpindleWant want_;
    std::shared_ptr<MarkedAngle> angle_;
};

}  // namespace lathelier::trajectory_common
