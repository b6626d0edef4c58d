#include "widgets/program_common/program_editor.h"

#include <QAccessibleWidget>
#include <QEvent>
#include <QFontDatabase>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

namespace lathelier::program_common {
namespace {

constexpr int typingPause_ms = 400;
constexpr int numberMargin = 0;
constexpr int remarkMargin = 1;
constexpr int warningMark = 1;
constexpr int errorMark = 2;
constexpr int warningWave = 8;
constexpr int errorWave = 9;
constexpr int dwell_ms = 300;
constexpr double fontSizes = 100;  // Scintilla's font size unit: 1/100 point
constexpr std::size_t mostMarks = 2000;
constexpr std::size_t mostStyledBytes = 20000;  // largest number of styled bytes of one line

ProgramEditor::Style styleOf(const gcode::Word& word)
{
    using Style = ProgramEditor::Style;
    if (word.kind == gcode::WordKind::Comment) return Style::Comment;
    if (word.kind == gcode::WordKind::Bad || !word.is_understood) return Style::NotUnderstood;
    if (word.kind != gcode::WordKind::Number && word.kind != gcode::WordKind::Expression) return Style::Control;
    switch (word.letter) {
        case 'G': return Style::Preparatory;
        case 'M': return Style::Miscellaneous;
        case 'N':
        case 'O': return Style::Number;
        case 'F':
        case 'S':
        case 'T':
        case 'D': return Style::Technology;
        default: return Style::Coordinate;
    }
}

/// Colours for light and dark background.
QColor colourOf(ProgramEditor::Style style, const QPalette& palette)
{
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    switch (style) {
        case ProgramEditor::Comment: return dark ? QColor(0x8f, 0xb3, 0x8f) : QColor(0x3d, 0x6b, 0x3d);
        case ProgramEditor::Preparatory: return dark ? QColor(0x7d, 0xb8, 0xf5) : QColor(0x0b, 0x52, 0x94);
        case ProgramEditor::Miscellaneous: return dark ? QColor(0xd4, 0xa5, 0xf0) : QColor(0x76, 0x2a, 0x96);
        case ProgramEditor::Technology: return dark ? QColor(0xf0, 0xb9, 0x6b) : QColor(0x8a, 0x50, 0x00);
        case ProgramEditor::Number: return dark ? QColor(0x9a, 0x9a, 0x9a) : QColor(0x6a, 0x6a, 0x6a);
        case ProgramEditor::Control: return dark ? QColor(0x6f, 0xd0, 0xc5) : QColor(0x00, 0x66, 0x5c);
        case ProgramEditor::NotUnderstood: return dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb0, 0x1c, 0x12);
        default: return palette.color(QPalette::Text);
    }
}

/// Accessibility interface: role, name, and the line of the caret. QScintilla's own interface counts all characters
/// before the caret at every update, a tenth of a second in a program of a million lines.
class EditorAccess : public QAccessibleWidget {
public:
    explicit EditorAccess(ProgramEditor* editor) : QAccessibleWidget(editor, QAccessible::EditableText), editor_(editor)
    {
    }
    QString text(QAccessible::Text wanted) const override
    {
        if (wanted != QAccessible::Value) return QAccessibleWidget::text(wanted);
        return editor_->text(static_cast<int>(editor_->line() - 1)).trimmed();
    }

private:
    ProgramEditor* editor_;
};

QAccessibleInterface* makeEditorAccess(const QString&, QObject* object)
{
    auto* editor = qobject_cast<ProgramEditor*>(object);
    return editor ? new EditorAccess(editor) : nullptr;
}

/// Scintilla takes colours as 0xBBGGRR.
long bgr(const QColor& colour)
{
    return colour.red() | colour.green() << 8 | colour.blue() << 16;
}

/// End of the token that begins at `from` in a line: blank or next word.
std::size_t endOfWord(std::string_view line, std::size_t from)
{
    std::size_t at = from + 1;
    bool had_digit = false;
    for (; at < line.size() && std::isspace(static_cast<unsigned char>(line[at])) == 0; ++at) {
        const auto c = static_cast<unsigned char>(line[at]);
        if (had_digit && std::isalpha(c) != 0) break;
        had_digit = had_digit || std::isdigit(c) != 0;
    }
    return std::min(at, line.size());
}

}  // namespace

ProgramEditor::ProgramEditor(QWidget* parent) : QsciScintilla(parent)
{
    [[maybe_unused]] static const bool is_known = (QAccessible::installFactory(makeEditorAccess), true);
    setUtf8(true);
    setEolMode(EolUnix);
    setWrapMode(WrapNone);
    setMarginType(numberMargin, NumberMargin);
    setMarginType(remarkMargin, SymbolMargin);
    setMarginMarkerMask(remarkMargin, 1 << warningMark | 1 << errorMark);
    markerDefine(RightTriangle, warningMark);
    markerDefine(Circle, errorMark);
    indicatorDefine(SquiggleIndicator, warningWave);
    indicatorDefine(SquiggleIndicator, errorWave);
    setCaretLineVisible(true);
    send(SCI_SETCARETLINEVISIBLEALWAYS, 1);  // visible without focus, for clicks on the path
    send(SCI_SETLEXER, SCLEX_CONTAINER);
    send(SCI_SETSCROLLWIDTH, 1);
    send(SCI_SETSCROLLWIDTHTRACKING, 1);
    send(SCI_SETMOUSEDWELLTIME, dwell_ms);
    // Changes are handled before they are applied: after them QScintilla counts all characters before the place.
    send(SCI_SETMODEVENTMASK, SC_MOD_BEFOREINSERT | SC_MOD_BEFOREDELETE);
    pause_.setSingleShot(true);
    pause_.setInterval(typingPause_ms);
    connect(&pause_, &QTimer::timeout, this, [this] {
        fitMargin();
        emit edited();
    });
    connect(this, &QsciScintillaBase::SCEN_CHANGE, this, [this] {
        if (!loading_) pause_.start();
    });
    connect(this, &QsciScintilla::cursorPositionChanged, this, [this](int at) {
        if (at + 1 == line_) return;
        line_ = at + 1;
        emit lineReached(line_);
    });
    connect(this, &QsciScintillaBase::SCN_STYLENEEDED, this, [this](int) { styleVisible(); });
    connect(this, &QsciScintillaBase::SCN_UPDATEUI, this, [this](int) { styleVisible(); });
    connect(this, &QsciScintillaBase::SCN_DWELLSTART, this, &ProgramEditor::showRemark);
    connect(this, &QsciScintillaBase::SCN_DWELLEND, this, [this](int, int, int) { send(SCI_CALLTIPCANCEL); });
    restyle();
}

void ProgramEditor::setProgram(const QByteArray& utf8, const QString& file, gcode::ControlPtr control)
{
    const bool same_control = control == control_;
    control_ = std::move(control);
    pause_.stop();
    loading_ = true;
    if (file != file_ || length() == 0) {
        file_ = file;
        send(SCI_SETUNDOCOLLECTION, 0);
        send(SCI_CLEARALL);
        SendScintilla(SCI_APPENDTEXT, static_cast<unsigned long>(utf8.size()), utf8.constData());
        send(SCI_SETUNDOCOLLECTION, 1);
        send(SCI_EMPTYUNDOBUFFER);
        send(SCI_GOTOPOS, 0);
        const int first_end = utf8.indexOf('\n');
        setEolMode(first_end > 0 && utf8[first_end - 1] == '\r' ? EolWindows : EolUnix);
    } else if (const QByteArray now = program(); now != utf8) {
        const auto [a, b] = std::mismatch(now.begin(), now.end(), utf8.begin(), utf8.end());
        const auto begin = a - now.begin();
        const auto most = std::min(now.end() - a, utf8.end() - b);
        std::ptrdiff_t tail = 0;
        while (tail < most &&
               now[static_cast<int>(now.size() - 1 - tail)] == utf8[static_cast<int>(utf8.size() - 1 - tail)])
            ++tail;
        send(SCI_SETTARGETSTART, static_cast<unsigned long>(begin));
        send(SCI_SETTARGETEND, static_cast<unsigned long>(now.size() - tail));
        SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(utf8.size() - tail - begin),
                      utf8.constData() + begin);
    }
    loading_ = false;
    fitMargin();
    if (!same_control) send(SCI_STARTSTYLING, 0);
    styleVisible();
}

QByteArray ProgramEditor::program() const
{
    const auto size = static_cast<int>(send(SCI_GETLENGTH));
    QByteArray utf8(size, Qt::Uninitialized);
    const auto* text = reinterpret_cast<const char*>(SendScintillaPtrResult(SCI_GETCHARACTERPOINTER));
    std::copy(text, text + size, utf8.data());
    return utf8;
}

void ProgramEditor::takeOver()
{
    if (!pause_.isActive()) return;
    pause_.stop();
    emit edited();
}

void ProgramEditor::goToLine(std::int64_t line)
{
    const auto at = static_cast<unsigned long>(std::clamp<std::int64_t>(line - 1, 0, std::max(0, lines() - 1)));
    send(SCI_GOTOLINE, at);
    send(SCI_VERTICALCENTRECARET);
    styleVisible();
}

std::int64_t ProgramEditor::line() const
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    return line + 1;
}

bool ProgramEditor::find(const QString& wanted, bool forward)
{
    int line = -1, index = -1;
    int end_line = 0, end_index = 0;
    if (!forward && hasSelectedText()) getSelection(&line, &index, &end_line, &end_index);
    return findFirst(wanted, false, false, false, true, forward, line, index);
}

int ProgramEditor::styleAt(std::int64_t line, int column) const
{
    return static_cast<int>(send(
        SCI_GETSTYLEAT, static_cast<unsigned long>(positionFromLineIndex(static_cast<int>(line - 1), column - 1))));
}

void ProgramEditor::setRemarks(std::vector<LineRemark> remarks)
{
    remarks_ = std::move(remarks);
    std::stable_sort(remarks_.begin(), remarks_.end(),
                     [](const LineRemark& a, const LineRemark& b) { return a.line < b.line; });
    markRemarks();
}

void ProgramEditor::markRemarks()
{
    markerDeleteAll(warningMark);
    markerDeleteAll(errorMark);
    const auto length = send(SCI_GETLENGTH);
    for (const int wave : {warningWave, errorWave}) {
        send(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(wave));
        send(SCI_INDICATORCLEARRANGE, 0, length);
    }
    std::size_t marked = 0;
    for (const LineRemark& remark : remarks_) {
        if (remark.line < 1 || remark.line > lines() || ++marked > mostMarks) continue;
        const int line = static_cast<int>(remark.line - 1);
        markerAdd(line, remark.is_error ? errorMark : warningMark);
        const QByteArray text = this->text(line).toUtf8();
        long from = positionFromLineIndex(line, std::max(0, static_cast<int>(remark.column) - 1));
        const long begin = send(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
        const long end = send(SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
        from = std::min(from, end);
        const long to =
            remark.column < 1
                ? end
                : begin + static_cast<long>(endOfWord({text.constData(), static_cast<std::size_t>(end - begin)},
                                                      static_cast<std::size_t>(from - begin)));
        send(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(remark.is_error ? errorWave : warningWave));
        if (to > from) send(SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), to - from);
    }
}

void ProgramEditor::showRemark(int position, int x, int y)
{
    if (position < 0) position = static_cast<int>(send(SCI_POSITIONFROMPOINT, static_cast<unsigned long>(x), y));
    const long line = send(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position)) + 1;
    QStringList remarkTexts;
    for (const LineRemark& remark : remarks_)
        if (remark.line == line) remarkTexts << remark.text;
    if (remarkTexts.isEmpty()) return;
    const QByteArray text = remarkTexts.join('\n').toUtf8();
    SendScintilla(SCI_CALLTIPSHOW, static_cast<unsigned long>(position), text.constData());
}

void ProgramEditor::styleVisible()
{
    const long first = send(SCI_GETFIRSTVISIBLELINE);
    const long last = std::min<long>(first + send(SCI_LINESONSCREEN) + 1, lines() - 1);
    for (long line = first; line <= last; ++line) styleLine(line);
    // Earlier text is marked as styled, so that Scintilla does not request it; it is styled when it becomes visible.
    send(SCI_STARTSTYLING, static_cast<unsigned long>(send(SCI_GETLENGTH)));
}

void ProgramEditor::styleLine(long line)
{
    const long begin = send(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
    const long end = send(SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
    const long size = std::min<long>(end - begin, static_cast<long>(mostStyledBytes));
    if (size <= 0) return;
    std::string text(static_cast<std::size_t>(size) + 1, '\0');
    SendScintilla(SCI_GETTEXTRANGE, begin, begin + size, text.data());
    text.pop_back();
    QByteArray styles(static_cast<int>(size), static_cast<char>(Plain));
    for (const gcode::Word& word : gcode::wordsOfLine(std::move(text), control_))
        for (std::uint32_t i = word.begin; i < word.begin + word.length && i < static_cast<std::uint32_t>(size); ++i)
            styles[static_cast<int>(i)] = static_cast<char>(styleOf(word));
    send(SCI_STARTSTYLING, static_cast<unsigned long>(begin));
    SendScintilla(SCI_SETSTYLINGEX, static_cast<unsigned long>(size), styles.constData());
}

void ProgramEditor::fitMargin()
{
    setMarginWidth(numberMargin, QString(std::max<int>(3, QString::number(lines()).size()) + 1, '9'));
}

void ProgramEditor::restyle()
{
    const QPalette look = palette();
    QFont type = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    type.setPointSizeF(font().pointSizeF() > 0 ? font().pointSizeF() : type.pointSizeF());
    const QByteArray family = type.family().toUtf8();
    const auto style = [&](unsigned long number, const QColor& colour, const QColor& ground) {
        SendScintilla(SCI_STYLESETFONT, number, family.constData());
        send(SCI_STYLESETSIZEFRACTIONAL, number, std::lround(type.pointSizeF() * fontSizes));
        send(SCI_STYLESETFORE, number, bgr(colour));
        send(SCI_STYLESETBACK, number, bgr(ground));
    };
    style(STYLE_DEFAULT, look.color(QPalette::Text), look.color(QPalette::Base));
    send(SCI_STYLECLEARALL);
    for (const Style one :
         {Plain, Comment, Preparatory, Miscellaneous, Coordinate, Technology, Number, Control, NotUnderstood})
        style(static_cast<unsigned long>(one), colourOf(one, look), look.color(QPalette::Base));
    send(SCI_STYLESETBOLD, Preparatory, 1);
    send(SCI_STYLESETITALIC, Comment, 1);
    style(STYLE_LINENUMBER, look.color(QPalette::Disabled, QPalette::Text), look.color(QPalette::Window));
    setCaretForegroundColor(look.color(QPalette::Text));
    QColor current = look.color(QPalette::Highlight);
    current.setAlpha(45);
    setCaretLineBackgroundColor(current);
    setSelectionBackgroundColor(look.color(QPalette::Highlight));
    setSelectionForegroundColor(look.color(QPalette::HighlightedText));
    const QColor error = colourOf(NotUnderstood, look), warning = colourOf(Technology, look);
    setMarkerBackgroundColor(warning, warningMark);
    setMarkerForegroundColor(warning, warningMark);
    setMarkerBackgroundColor(error, errorMark);
    setMarkerForegroundColor(error, errorMark);
    setIndicatorForegroundColor(warning, warningWave);
    setIndicatorForegroundColor(error, errorWave);
    setMarginWidth(remarkMargin, QFontMetrics(type).height());
    fitMargin();
}

void ProgramEditor::changeEvent(QEvent* event)
{
    QsciScintilla::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) restyle();
}

void ProgramEditor::showEvent(QShowEvent* event)
{
    QsciScintilla::showEvent(event);
    styleVisible();
}

/// More lines may have become visible, for which Scintilla emits no signal.
void ProgramEditor::resizeEvent(QResizeEvent* event)
{
    QsciScintilla::resizeEvent(event);
    styleVisible();
}

}  // namespace lathelier::program_common
