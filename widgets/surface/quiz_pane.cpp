#include "widgets/surface/quiz_pane.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "engine/core/units.h"
#include "widgets/core/language.h"

namespace lathelier::surface_panel {

QuizPane::QuizPane(QWidget* parent)
    : QWidget(parent),
      ask_(new QCheckBox),
      body_(new QWidget),
      words_(new QLabel),
      name_(new QLabel),
      answer_(new NumberEdit(0.1, 100000)),
      check_(new QPushButton),
      next_(new QPushButton)
{
    ask_->setObjectName("quizAsk");
    answer_->setObjectName("quizAnswer");
    check_->setObjectName("quizCheck");
    next_->setObjectName("quizNext");
    answer_->setOptional({});
    name_->setBuddy(answer_);
    words_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout;
    row->addWidget(name_);
    row->addWidget(answer_, 1);
    row->addWidget(check_);
    auto* inner = new QVBoxLayout(body_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->addWidget(words_);
    inner->addLayout(row);
    inner->addWidget(next_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(ask_);
    column->addWidget(body_);
    connect(ask_, &QCheckBox::clicked, this, &QuizPane::quizRequested);
    const auto answered = [this] {
        if (answer_->number()) emit answerRequested(*answer_->number());
    };
    connect(check_, &QPushButton::clicked, this, answered);
    connect(answer_, &QLineEdit::returnPressed, this, answered);
    connect(next_, &QPushButton::clicked, this, [this] { emit questionRequested(question_.quiz_number + 1); });
    retranslate();
}

void QuizPane::setQuestion(const surface::SurfaceQuestion& question)
{
    const bool another =
        question.quiz_number != question_.quiz_number || question.quiz_answer_hz != question_.quiz_answer_hz;
    question_ = question;
    const QSignalBlocker quiet(ask_);
    ask_->setChecked(question.quiz);
    body_->setVisible(question.quiz);
    if (another) answer_->setNumber(question.quiz_answer_hz);
    answer_->setEnabled(isAsking(question));
    check_->setEnabled(isAsking(question));
    showWords();
}

void QuizPane::showWords()
{
    const surface::SyntheticParameters made = pictureOf(question_);
    QString words = tr("Question %1").arg(question_.quiz_number) + "\n";
    words += tr("D = %1, f = %2, N = %3, n = N / 60 = %4")
                 .arg(screenQuantity(made.diameter_mm, unit::mm, 0), screenQuantity(made.feed_mm_rev, unit::mm, 2),
                      screenQuantity(made.speed_rpm, LT_TEXT("Engine", "rpm"), 0),
                      screenQuantity(made.speed_rpm / 60, unit::hz, 2)) +
             "\n";
    words += tr("Measure in the view Marks, where the circumference is laid flat:") + "\n";
    words += tr("period of the bands along the axis p: |ν| = f / p") + "\n";
    words += tr("pitch of the bands round the part u: m = πD / u, a whole number") + "\n";
    words += tr("bands that lean like \\ : ν < 0, like / : ν > 0") + "\n";
    words += tr("f_c = n (m + ν)");
    words_->setText(words);
}

void QuizPane::retranslate()
{
    ask_->setText(tr("Ask me"));
    ask_->setToolTip(tr("A picture whose frequency is to be found with ruler and formula"));
    name_->setText(tr("Your f_c (%1)").arg(screenUnit(unit::hz)));
    answer_->setAccessibleName(tr("Frequency that was read off the picture"));
    check_->setText(tr("Check"));
    check_->setToolTip(tr("Compare the answer with the picture, and show everything"));
    next_->setText(tr("Next question"));
    next_->setToolTip(tr("Another picture"));
    showWords();
}

}  // namespace lathelier::surface_panel
