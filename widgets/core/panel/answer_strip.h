// The answer of a panel above its views, in a strip of constant height: badge, value ± uncertainty, ruler, sentence,
// findings, and the notes as chips. The layout below does not move when the answer changes.
#pragma once

#include <QFrame>
#include <QLabel>
#include <array>
#include <optional>

#include "engine/core/error.h"
#include "engine/report/answer.h"
#include "engine/report/answer_ruler.h"

namespace lathelier {

class NotesChips;

/// One elided line of text, shown in full in the tooltip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const char* name);
    void say(const QString& text);  ///< sets the text; text() is not elided

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// A finding; one with a place can be activated by pointer or Enter.
class FindingLink : public ElidedLabel {
    Q_OBJECT
public:
    explicit FindingLink(const char* name);
    void offer(const QString& text, bool leads);  ///< `leads`: the finding has a place and can be clicked

signals:
    void clicked();

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool leads_ = false;
};

/// Ruler of the value against its limits.
class AnswerRuler : public QWidget {
    Q_OBJECT
public:
    explicit AnswerRuler(QWidget* parent = nullptr);
    void setAnswer(const std::optional<report::Answer>& answer);
    bool hasScale() const { return ruler_.has_value(); }  ///< false: no value, or no limit to compare it with
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<report::Ruler> ruler_;
    QString lower_, upper_;
};

class AnswerStrip : public QFrame {
    Q_OBJECT
public:
    explicit AnswerStrip(QWidget* parent = nullptr);
    void setAnswer(const report::Answer& answer);  ///< texts in the user's language
    void setNotes(const Notes& notes);
    void clear();
    void setPresenting(bool presenting);  ///< large value for presentations
    QString text() const;                 ///< all texts without the notes

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;  ///< however long the value is: the window sets the width

signals:
    void placeRequested(const lathelier::report::Place& place);  ///< request to show the place of a clicked finding
    void offerTaken(const lathelier::Values& parameters);        ///< a clicked finding proposes these parameters

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void applyFonts();
    void fitPresented(QFont& font) const;
    void showVerdict();
    void showRuler();
    void showPlate(const std::optional<Verdict>& verdict, bool known);

    QLabel* verdict_;
    ElidedLabel* quantity_;
    ElidedLabel* value_;
    AnswerRuler* ruler_;
    NotesChips* notes_;
    ElidedLabel* sentence_;
    std::array<FindingLink*, 3> findings_{};
    std::optional<report::Answer> answer_;
    bool presenting_ = false;
    QString verdictWords_;  ///< the plate shows its sign alone where they do not fit
    int whole_px_ = 0;      ///< height with all lines; a low panel shows only the first
};

}  // namespace lathelier
