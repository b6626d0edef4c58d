// The answer of a panel above its views, in a strip whose height the content does not change: badge, value ±
// uncertainty, ruler, sentence, findings, and the notes as chips. Nothing below moves when the answer changes.
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

/// One line of text; what has no room ends in "…" and stands in the tooltip as a whole.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const char* name);
    void say(const QString& text);  ///< text() stays whole

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

/// A finding; one that has a place leads there, by pointer or by Enter.
class FindingLink : public ElidedLabel {
    Q_OBJECT
public:
    explicit FindingLink(const char* name);
    void offer(const QString& text, bool leads);  ///< `leads`: to a place, so that it can be clicked

signals:
    void clicked();

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool leads_ = false;
};

/// The value against its limits.
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
    void setAnswer(const report::Answer& answer);  ///< in the language of the screen
    void setNotes(const Notes& notes);
    void clear();
    void setPresenting(bool presenting);  ///< the value at a size for the last row of a room
    QString text() const;                 ///< all that is said, without the notes

    QSize sizeHint() const override;

signals:
    void placeWanted(const lathelier::report::Place& place);  ///< a finding was clicked
    void offerTaken(const lathelier::Values& parameters);     ///< a finding that proposes these was clicked

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void applyFonts();
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
    int whole_px_ = 0;  ///< height with all lines; in a low panel there is the first one only
};

}  // namespace lathelier
