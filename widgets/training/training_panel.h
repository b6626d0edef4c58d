// The panel "Training": chatter of a lathe seen, heard and computed by a class.
#pragma once

#include <QTabWidget>

#include "engine/training/task/training_task.h"
#include "widgets/core/panel/task_panel.h"
#include "widgets/training/exercise_pane.h"
#include "widgets/training/frame_writer.h"
#include "widgets/training/sound_player.h"
#include "widgets/training/tour_pane.h"
#include "widgets/training/training_views.h"
#include "widgets/training/transport_bar.h"

namespace lathelier::training_panel {

/// The panel's line of the panel table.
PanelFacts trainingPanelFacts();

class TrainingPanel : public TaskPanel<training::TrainingOutcome> {
    Q_OBJECT

public:
    explicit TrainingPanel(Session& session, QWidget* parent = nullptr);

    TrainingViews& views() const { return *views_; }
    TourPane& tour() const { return *tour_; }
    ExercisePane& exercises() const { return *exercises_; }
    TransportBar& transport() const { return *transport_; }
    SoundPlayer& player() { return player_; }
    void setPresenting(bool presenting) override;
    void openFound(const std::vector<FoundFile>& files) override;

protected:
    void showResult(const std::shared_ptr<const training::TrainingOutcome>& outcome) override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void movePoint(double speed_rpm, double depth_mm, bool dropped);
    void takeSetting(const training::Setting& setting);
    void updateTour();
    void playCut(const stability::SimulationResult& cut, const std::vector<stability::Mode>& modes);
    void playPicture();
    void openLesson(const QString& path);
    void askForLesson();
    void askForSheet();
    void writeDemonstration(const QString& path) const;
    void writePictures(const QString& path) const;

    SoundPlayer player_;
    FrameWriter* frames_;
    TrainingViews* views_;
    TourPane* tour_;
    ExercisePane* exercises_;
    QTabWidget* panes_;
    TransportBar* transport_;
    QTimer listening_;                               ///< updates the tour with the seconds played
    std::string sounding_;                           ///< key of the machine being played
    double score_ = training::LessonState::unknown;  ///< of the last exercise since the step began
    int gesture_ = 0;                                ///< drags of the operating point so far: one undo step each
};

}  // namespace lathelier::training_panel
