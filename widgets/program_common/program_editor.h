// The text of an NC program: syntax colours, line numbers, remarks in place. Only visible lines are processed, so that
// a million lines can be scrolled.
#pragma once

#include <Qsci/qsciscintilla.h>

#include <QTimer>
#include <vector>

#include "engine/gcode/program.h"
#include "widgets/core/form/typing.h"

namespace lathelier::program_common {

/// A remark at a line.
struct LineRemark {
    std::int64_t line = 0;    ///< line, from 1
    std::int64_t column = 0;  ///< column in characters, from 1; 0: the whole line
    bool is_error = false;    ///< true: error; false: warning
    QString text;             ///< text of the remark
};

class ProgramEditor : public QsciScintilla, public TypingEditor {
    Q_OBJECT

public:
    explicit ProgramEditor(QWidget* parent = nullptr);

    /// Shows another text; for the same file only the differing part is replaced.
    void setProgram(const QByteArray& utf8, const QString& file, gcode::ControlPtr control);
    QByteArray program() const;  ///< UTF-8, line ends as they are

    void setRemarks(std::vector<LineRemark> remarks);
    const std::vector<LineRemark>& remarks() const { return remarks_; }

    /// Puts the caret at the beginning of a line and shows it in the middle; the keyboard focus is unchanged.
    void goToLine(std::int64_t line);
    std::int64_t line() const;  ///< line of the caret, from 1

    bool isTyping() const { return pause_.isActive(); }  ///< pending input exists
    void takeOver() override;

    /// Finds the next or previous occurrence of a text, cyclically; false when there is none.
    bool find(const QString& wanted, bool forward);

    /// Style index at a position, for tests.
    int styleAt(std::int64_t line, int column) const;
    enum Style { Plain, Comment, Preparatory, Miscellaneous, Coordinate, Technology, Number, Control, NotUnderstood };

signals:
    void edited();                     ///< after a pause in typing, or by takeOver()
    void lineReached(qlonglong line);  ///< the caret moved to another line

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void styleVisible();
    void styleLine(long line);
    void fitMargin();
    void markRemarks();
    void showRemark(int position, int x, int y);
    long send(unsigned int message, unsigned long w = 0, long l = 0) const { return SendScintilla(message, w, l); }

    gcode::ControlPtr control_ = gcode::usualControl();
    QString file_;
    std::vector<LineRemark> remarks_;
    QTimer pause_;
    qlonglong line_ = 0;
    bool loading_ = false;
};

}  // namespace lathelier::program_common
