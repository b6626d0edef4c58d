// The trainer's generator: sliders for the cut, the vibration and the light of a picture that is made, and beside them
// what follows for the marks.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>
#include <string>
#include <vector>

#include "engine/surface/synthetic.h"
#include "widgets/core/form/number_edit.h"
#include "widgets/surface/quiz_pane.h"

class QGridLayout;

namespace lathelier::surface_panel {

class GeneratorPane : public QWidget {
    Q_OBJECT

public:
    explicit GeneratorPane(QWidget* parent = nullptr);

    void setQuestion(const surface::SurfaceQuestion& question);  ///< announces nothing
    void setFound(const QString& words);                         ///< what the evaluation says of the picture
    QuizPane* quiz() const { return quiz_; }
    QSlider* slider(const std::string& key) const;     ///< nullptr: there is none
    NumberEdit* number(const std::string& key) const;  ///< nullptr: there is none
    void retranslate();

signals:
    /// Changes with the same gesture are one undo step. `key`: of the field of SyntheticParameters.
    void valueRequested(const std::string& key, const lathelier::Value& value, int gesture);

private:
    struct Row {
        FieldInfo info;    ///< what it changes
        double from, to;   ///< ends of the slider, which are narrower than the field's
        bool logarithmic;  ///< the slider
        QLabel* label;     ///< name and unit
        QSlider* slider;   ///< rough
        NumberEdit* edit;  ///< exact
    };
    void addRow(const FieldInfo& info, double from, double to, bool logarithmic, QGridLayout* grid);
    void setParameters(const surface::SyntheticParameters& parameters);
    void showWaves();

    std::vector<Row> rows_;
    QuizPane* quiz_;
    QWidget* cut_;  ///< the sliders
    QComboBox* light_;
    QLabel* lightName_;
    QCheckBox* cylinder_;
    QLabel* title_;
    QLabel* waves_;
    QLabel* found_;
    surface::SyntheticParameters parameters_;
    int gesture_ = 0;
};

}  // namespace lathelier::surface_panel
