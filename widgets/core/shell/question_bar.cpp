#include "widgets/core/shell/question_bar.h"

#include <QEvent>
#include <algorithm>
#include <numeric>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr int margin_px = 3;   // left and right of the boxes
constexpr int spacing_px = 2;  // between two
constexpr int apart_px = 10;   // between the chain and what stands beside it

}  // namespace

QuestionBar::QuestionBar(const std::vector<Question>& questions, QWidget* parent)
    : QWidget(parent), questions_(questions)
{
    setObjectName("questions");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    for (std::size_t i = 0; i < questions_.size(); ++i) {
        const Question& question = questions_[i];
        auto* box = new QuestionBox(this);
        box->setObjectName(QString::fromStdString("question_" + question.id));
        box->setIcon(icon(question.icon));
        boxes_.push_back(box);
        connect(box, &QAbstractButton::clicked, this, [this, box, id = question.id] {
            box->setChecked(true);  // a click on the open question leaves it open
            emit questionRequested(id);
        });
        connect(box, &QuestionBox::stepRequested, this, [this, i](int by) {
            const auto count = static_cast<int>(boxes_.size());
            boxes_[static_cast<std::size_t>((static_cast<int>(i) + by + count) % count)]->setFocus(Qt::TabFocusReason);
        });
        connect(box, &QuestionBox::menuRequested, this,
                [this, id = question.id](const QPoint& global) { emit menuRequested(id, global); });
    }
    retranslate();
}

QuestionBox* QuestionBar::box(const std::string& question) const
{
    for (std::size_t i = 0; i < questions_.size(); ++i)
        if (questions_[i].id == question) return boxes_[i];
    return nullptr;
}

void QuestionBar::setAnswer(const std::string& question, const QuestionAnswer& answer)
{
    if (QuestionBox* const known = box(question)) known->setAnswer(answer);
}

/// The Tab key reaches the open question, the arrow keys the others.
void QuestionBar::setCurrent(const std::string& question)
{
    for (std::size_t i = 0; i < questions_.size(); ++i) {
        boxes_[i]->setChecked(questions_[i].id == question);
        boxes_[i]->setFocusPolicy(boxes_[i]->isChecked() ? Qt::TabFocus : Qt::NoFocus);
    }
}

QSize QuestionBar::sizeHint() const
{
    const int height = boxes_.empty() ? 0 : boxes_.front()->sizeHint().height();
    return {static_cast<int>(boxes_.size()) * 110, height};
}

QSize QuestionBar::minimumSizeHint() const
{
    int width = 2 * margin_px + apart_px;
    for (const QuestionBox* one : boxes_) width += one->compactWidth() + spacing_px;
    return {width, sizeHint().height()};
}

/// Independent of the answers, so that no box moves when an answer comes. Every name is whole while there is room for
/// the names; what is left goes to the chain, whose boxes become equally wide. In a narrow window those beside the
/// chain show their icons alone, then all do.
std::vector<int> QuestionBar::widths() const
{
    const int fixed = 2 * margin_px + apart_px + spacing_px * static_cast<int>(boxes_.size());
    std::vector<int> widths;
    for (const QuestionBox* one : boxes_) widths.push_back(one->neededWidth());
    const auto left = [&] { return width() - fixed - std::accumulate(widths.begin(), widths.end(), 0); };
    for (const bool beside : {true, false})
        for (std::size_t i = 0; i < boxes_.size() && left() < 0; ++i)
            if (questions_[i].beside == beside) {
                for (std::size_t k = i; k < boxes_.size(); ++k)
                    if (questions_[k].beside == beside) widths[k] = boxes_[k]->compactWidth();
                break;
            }
    for (int rest = left(); rest > 0; --rest) {
        int* least = nullptr;
        for (std::size_t i = 0; i < widths.size(); ++i)
            if (!questions_[i].beside && (!least || widths[i] < *least)) least = &widths[i];
        if (!least) least = &widths.back();
        ++*least;
    }
    return widths;
}

void QuestionBar::arrange()
{
    const std::vector<int> all = widths();
    int left = margin_px;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (i > 0 && questions_[i].beside && !questions_[i - 1].beside) left += apart_px;
        boxes_[i]->setCompact(all[i] < boxes_[i]->neededWidth());
        boxes_[i]->setGeometry(left, 0, all[i], height());
        left += all[i] + spacing_px;
    }
}

void QuestionBar::retranslate()
{
    setAccessibleName(tr("Questions"));
    for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i]->setTitle(screenText(questions_[i].title));
    arrange();
}

void QuestionBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void QuestionBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
    if (event->type() != QEvent::FontChange && event->type() != QEvent::ApplicationFontChange) return;
    updateGeometry();
    arrange();
}

}  // namespace lathelier
