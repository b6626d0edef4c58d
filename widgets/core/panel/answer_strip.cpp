#include "widgets/core/panel/answer_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/report/abbreviations.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/notes_chips.h"

namespace lathelier {
namespace {

constexpr double valueSize = 1.9;      // font size of the value relative to the application's
constexpr int presentedValue_px = 96;  // font height in presenter mode
constexpr int leastRuler_chars = 24;
constexpr int mostRuler_chars = 60;
constexpr int presentedLeast_px = 56;  // font height in presenter mode in a small window
constexpr int rowSpacing_px = 14;      // between badge, value, ruler and notes
constexpr int side_px = 10;            // left and right of them

QFont scaled(const QFont& font, double factor)
{
    QFont result = font;
    result.setPointSizeF(font.pointSizeF() * factor);
    return result;
}

/// Badge colours: dark enough for white text in light and dark themes; symbol and text also distinguish the verdict.
QString plateColour(const std::optional<Verdict>& verdict)
{
    if (!verdict) return "#52606d";
    switch (*verdict) {
        case Verdict::Pass: return "#1d6f42";
        case Verdict::Fail: return "#a32020";
        case Verdict::Undecided: return "#8a5a00";
    }
    return {};
}

QString toQString(const std::string& text)
{
    return QString::fromStdString(text);
}

}  // namespace

AnswerStrip::AnswerStrip(QWidget* parent)
    : QFrame(parent),
      verdict_(new QLabel),
      quantity_(new ElidedLabel("quantity")),
      value_(new ElidedLabel("headline")),
      ruler_(new AnswerRuler),
      notes_(new NotesChips),
      sentence_(new ElidedLabel("sentence"))
{
    setObjectName("answer");
    setFrameShape(QFrame::StyledPanel);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    verdict_->setObjectName("verdict");
    verdict_->setAlignment(Qt::AlignCenter);
    auto* first = new QHBoxLayout;
    first->setSpacing(rowSpacing_px);
    first->addWidget(verdict_);
    auto* number = new QVBoxLayout;
    number->setSpacing(0);
    number->addWidget(quantity_);
    number->addWidget(value_);
    first->addLayout(number, 1);
    first->addWidget(ruler_, 1);
    first->addWidget(notes_, 0, Qt::AlignTop);
    auto* third = new QHBoxLayout;
    third->setSpacing(20);
    for (std::size_t i = 0; i < findings_.size(); ++i) {
        static constexpr std::array<const char*, 3> names{"finding1", "finding2", "finding3"};
        auto* button = new FindingLink(names[i]);
        connect(button, &FindingLink::clicked, this, [this, i] {
            if (!answer_ || i >= answer_->findings.size()) return;
            const report::Finding finding = answer_->findings[i];  // copied, since a slot may replace the answer
            if (finding.offer.empty())
                emit placeRequested(finding.place);
            else
                emit offerTaken(finding.offer);
        });
        third->addWidget(button, 1);
        findings_[i] = button;
    }
    third->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(side_px, 6, side_px, 6);
    layout->setSpacing(3);
    layout->addLayout(first);
    layout->addWidget(sentence_);
    layout->addLayout(third);
    applyFonts();
    clear();
}

void AnswerStrip::showPlate(const std::optional<Verdict>& verdict, bool known)
{
    verdict_->setVisible(known);
    verdict_->setStyleSheet(QString("QLabel { background: %1; color: white; border-radius: 6px; padding: 4px 12px; }")
                                .arg(plateColour(verdict)));
}

void AnswerStrip::setAnswer(const report::Answer& answer)
{
    const Language language = screenLanguage();
    answer_ = answer;
    report::Answer nameless = answer;
    nameless.value.reset();
    const std::string name = report::valueLine(nameless, language);
    const QString words = toQString(report::expansion(name, language));
    quantity_->say(toQString(name));
    quantity_->setToolTip(words.isEmpty() ? toQString(name) : toQString(name) + "\n" + words);
    value_->say(toQString(report::valueText(answer, language)));
    value_->setToolTip(toQString(report::valueLine(answer, language)));
    verdictWords_ = toQString(report::verdictText(answer, language));
    showPlate(answer.verdict, true);
    ruler_->setAnswer(answer);
    applyFonts();
    QString sentence = toQString(report::sentenceText(answer, language));
    if (const QString assumed = toQString(report::assumedText(answer, language)); !assumed.isEmpty())
        sentence += (sentence.isEmpty() ? QString() : QStringLiteral(" · ")) + assumed;
    sentence_->say(sentence);
    sentence_->setToolTip(sentence_->text());
    for (std::size_t i = 0; i < findings_.size(); ++i) {
        const bool there = i < answer.findings.size();
        QString text;
        if (there) {
            const report::Finding& finding = answer.findings[i];
            text = toQString(report::findingText(finding, language));
            if (finding.verdict)
                text = toQString(lathelier::text(shortName(*finding.verdict), language)).left(1) + " " + text;
        }
        const bool proposes = there && !answer.findings[i].offer.empty();
        findings_[i]->offer(text, there && (proposes || answer.findings[i].place.isAny()));
        if (proposes) findings_[i]->setToolTip(text + "\n" + tr("Click: use it. It can be undone."));
        if (there && answer.findings[i].verdict)
            findings_[i]->setToolTip(toQString(lathelier::text(shortName(*answer.findings[i].verdict), language)) +
                                     text.mid(1));
        findings_[i]->setVisible(sentence_->isVisibleTo(this) && (there || i == 0));  // the first line stays to keep
                                                                                      // the height
    }
    setAccessibleName(this->text());
}

void AnswerStrip::setNotes(const Notes& notes)
{
    notes_->setNotes(notes);
}

void AnswerStrip::clear()
{
    answer_.reset();
    for (ElidedLabel* label : {quantity_, value_, sentence_}) {
        label->say({});
        label->setToolTip({});
    }
    verdictWords_.clear();
    verdict_->clear();
    showPlate({}, false);
    ruler_->setAnswer({});
    showRuler();
    for (FindingLink* finding : findings_) {
        finding->offer({}, false);
        finding->setVisible(sentence_->isVisibleTo(this) && finding == findings_[0]);
    }
    setAccessibleName({});
}

void AnswerStrip::showRuler()
{
    const int chars = fontMetrics().averageCharWidth();
    const int others = verdict_->sizeHint().width() + value_->sizeHint().width() + notes_->sizeHint().width();
    const int room = width() - others - 10 * chars;
    ruler_->setVisible(ruler_->hasScale() && room > leastRuler_chars * chars);
    ruler_->setMaximumWidth(std::clamp(room, leastRuler_chars * chars, mostRuler_chars * chars));
    // Beside the ruler the value is whole, with its unit.
    value_->setMinimumWidth(ruler_->isVisibleTo(this) ? value_->sizeHint().width() : 0);
}

QString AnswerStrip::text() const
{
    QStringList lines{quantity_->text() + " " + value_->text() + " " + verdictWords_, sentence_->text()};
    for (const FindingLink* finding : findings_)
        if (!finding->text().isEmpty()) lines << finding->text();
    return lines.join('\n');
}

void AnswerStrip::setPresenting(bool presenting)
{
    presenting_ = presenting;
    applyFonts();
}

/// As large as the window allows; smaller where the value would not be whole beside badge and notes.
void AnswerStrip::fitPresented(QFont& font) const
{
    const int most_px = std::clamp(window()->height() / 9, presentedLeast_px, presentedValue_px);
    font.setPointSizeF(most_px * 72.0 / logicalDpiY());
    const int beside = verdict_->isVisibleTo(this) ? verdict_->sizeHint().width() + rowSpacing_px : 0;
    const int room = contentsRect().width() - 2 * side_px - beside - notes_->sizeHint().width() - 2 * rowSpacing_px;
    const int wanted = QFontMetrics(font).horizontalAdvance(value_->text()) + 4;
    if (wanted > room && room > 0) font.setPointSizeF(font.pointSizeF() * room / wanted);
}

void AnswerStrip::showVerdict()
{
    constexpr double mostPresented = 0.35;  // of the strip
    verdict_->setText(verdictWords_);
    const QString sign = verdictWords_.section(' ', 0, 0);
    if (presenting_ && sign.size() == 1 && verdict_->sizeHint().width() > mostPresented * width())
        verdict_->setText(sign);
}

/// The height of the strip is the same with and without an answer.
void AnswerStrip::applyFonts()
{
    QFont large = scaled(font(), valueSize);
    large.setWeight(QFont::DemiBold);
    verdict_->setFont(scaled(font(), presenting_ ? 1.5 : 1.25));
    showVerdict();
    if (presenting_) fitPresented(large);
    value_->setFont(large);
    const int first = std::max({QFontMetrics(large).height() + fontMetrics().height(),
                                QFontMetrics(verdict_->font()).height() + 10, ruler_->minimumSizeHint().height()});
    const int around = 12 + 2 * frameWidth();
    whole_px_ = first + 2 * (fontMetrics().height() + 4) + around + 6;
    setMinimumHeight(first + around);
    setMaximumHeight(whole_px_);
    showRuler();
    updateGeometry();
}

QSize AnswerStrip::sizeHint() const
{
    return {QFrame::sizeHint().width(), whole_px_};
}

QSize AnswerStrip::minimumSizeHint() const
{
    constexpr int least_chars = 40;
    return {fontMetrics().averageCharWidth() * least_chars, QFrame::minimumSizeHint().height()};
}

void AnswerStrip::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    const bool low = height() < whole_px_;
    sentence_->setVisible(!low);
    for (std::size_t i = 0; i < findings_.size(); ++i)
        findings_[i]->setVisible(!low && (i == 0 || !findings_[i]->text().isEmpty()));
    // Badge and value have precedence: the ruler is shown only with spare space.
    if (presenting_)
        applyFonts();
    else
        showRuler();
}

void AnswerStrip::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange) applyFonts();
}

}  // namespace lathelier
