#include "widgets/training/exercise_pane.h"

#include <QGridLayout>
#include <cmath>

#include "widgets/core/language.h"

namespace lathelier::training_panel {
namespace {

constexpr double largestAnswer = 1e9;  ///< number that may be answered

void fillChoices(QComboBox& box, const std::vector<QString>& words)
{
    const QSignalBlocker quiet(&box);
    const int chosen = std::max(0, box.currentIndex());
    box.clear();
    for (const QString& word : words) box.addItem(word);
    box.setCurrentIndex(std::min(chosen, box.count() - 1));
}

}  // namespace

ExercisePane::ExercisePane(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox),
      seed_(new QSpinBox),
      begin_(new QPushButton),
      pupil_(new QLineEdit),
      question_(new QLabel),
      speed_(new NumberEdit(1, 1e6)),
      listen_(new QPushButton),
      answer_(new NumberEdit(-largestAnswer, largestAnswer)),
      choice_(new QComboBox),
      submit_(new QPushButton),
      result_(new QTextBrowser),
      total_(new QLabel),
      sheet_(new QPushButton),
      kindLabel_(new QLabel),
      seedLabel_(new QLabel),
      pupilLabel_(new QLabel),
      speedLabel_(new QLabel),
      answerLabel_(new QLabel)
{
    setObjectName("exercises");
    kind_->setObjectName("exerciseKind");
    seed_->setObjectName("exerciseSeed");
    begin_->setObjectName("exerciseBegin");
    pupil_->setObjectName("exercisePupil");
    question_->setObjectName("exerciseQuestion");
    speed_->setObjectName("exerciseSpeed");
    listen_->setObjectName("exerciseListen");
    answer_->setObjectName("exerciseAnswer");
    choice_->setObjectName("exerciseChoice");
    submit_->setObjectName("exerciseGive");
    result_->setObjectName("exerciseResult");
    sheet_->setObjectName("exerciseSheet");
    seed_->setRange(0, 999999);
    answer_->setOptional({});
    speed_->setOptional({});
    for (QLabel* label : {question_, total_}) label->setWordWrap(true);
    result_->setFrameShape(QFrame::NoFrame);
    QSizePolicy keepsRoom = result_->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);  // what stands below does not move when it appears
    result_->setSizePolicy(keepsRoom);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    int row = 0;
    const auto addRow = [&](QLabel* label, QWidget* field) {
        layout->addWidget(label, row, 0);
        layout->addWidget(field, row++, 1);
        label->setBuddy(field);
    };
    addRow(pupilLabel_, pupil_);
    addRow(kindLabel_, kind_);
    addRow(seedLabel_, seed_);
    layout->addWidget(begin_, row++, 0, 1, 2);
    layout->addWidget(question_, row++, 0, 1, 2);
    addRow(speedLabel_, speed_);
    layout->addWidget(listen_, row++, 0, 1, 2);
    addRow(answerLabel_, answer_);
    layout->addWidget(choice_, row - 1, 1);
    layout->addWidget(submit_, row++, 0, 1, 2);
    layout->addWidget(result_, row, 0, 1, 2);
    layout->setRowStretch(row++, 1);
    layout->setRowStretch(row++, 0);
    layout->addWidget(total_, row++, 0, 1, 2);
    layout->addWidget(sheet_, row, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    connect(begin_, &QPushButton::clicked, this, [this] {
        begin(static_cast<training::ExerciseKind>(kind_->currentIndex()), static_cast<std::uint32_t>(seed_->value()));
    });
    connect(listen_, &QPushButton::clicked, this, [this] {
        speed_->takeOver();
        listen(speed_->number().value_or(0));
    });
    connect(submit_, &QPushButton::clicked, this, [this] {
        answer_->takeOver();
        const bool chooses = exercise_ && !exercise_->choices.empty();
        submitAnswer(chooses ? choice_->currentIndex() : answer_->number().value_or(NAN));
    });
    connect(sheet_, &QPushButton::clicked, this, &ExercisePane::sheetRequested);
    retranslate();
}

void ExercisePane::begin(training::ExerciseKind kind, std::uint32_t seed)
{
    exercise_ = training::makeExercise(kind, seed);
    grade_.reset();
    cutsLeft_ = exercise_->cuts;
    kind_->setCurrentIndex(static_cast<int>(kind));
    seed_->setValue(static_cast<int>(std::min<std::uint32_t>(seed, 999999)));
    answer_->setNumber({});
    const Interval& speeds = exercise_->speed_rpm;
    speed_->setNumber(std::round((speeds.from + speeds.to) / 2));
    since_.start();
    emit begun();
    if (kind == training::ExerciseKind::Damping) emit blowHeard(training::listenToBlow(*exercise_));
    show();
}

void ExercisePane::listen(double speed_rpm)
{
    if (!exercise_ || cutsLeft_ <= 0) return;
    try {
        auto cut = std::make_shared<const stability::SimulationResult>(
            training::listen(*exercise_, speed_rpm, exercise_->depth_mm));
        --cutsLeft_;
        emit cutHeard(std::move(cut));
    } catch (const Error& error) {
        emit refused(error);
    }
    show();
}

void ExercisePane::submitAnswer(double answer)
{
    if (!exercise_ || grade_ || !std::isfinite(answer)) return;
    grade_ = training::grade(*exercise_, answer);
    answers_.push_back({pupil_->text().toStdString(), exercise_->kind, exercise_->seed, answer,
                        1e-3 * static_cast<double>(since_.elapsed())});
    points_ += grade_->points;
    emit graded(grade_->points);
    show();
}

QString ExercisePane::explained(Text pattern, const std::vector<training::NamedNumber>& numbers) const
{
    const Language language = screenLanguage();
    return QString::fromStdString(fill(text(pattern, language), training::valuesOf(numbers), language));
}

QString ExercisePane::expected() const
{
    QStringList ranges;
    for (const Interval& range : grade_->expected) {
        if (!exercise_->choices.empty()) {
            ranges << screenText(exercise_->choices[static_cast<std::size_t>(std::lround(range.from))]);
            continue;
        }
        const QString from = screenNumber(range.from, exercise_->decimals);
        const QString to = screenNumber(range.to, exercise_->decimals);
        ranges << (from == to ? from : from + " – " + to);
    }
    return ranges.join(", ");
}

void ExercisePane::show()
{
    const bool asked = exercise_.has_value();
    const bool chooses = asked && !exercise_->choices.empty();
    const bool listens = asked && exercise_->cuts > 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{answerLabel_, submit_}) widget->setVisible(asked);
    answer_->setVisible(asked && !chooses);
    choice_->setVisible(chooses);
    for (QWidget* widget : std::initializer_list<QWidget*>{speedLabel_, speed_, listen_}) widget->setVisible(listens);
    question_->setVisible(asked);
    result_->setVisible(grade_.has_value());
    sheet_->setEnabled(!answers_.empty());
    total_->setText(answers_.empty()
                        ? QString()
                        : tr("%n answer(s)", nullptr, static_cast<int>(answers_.size())) + " · " +
                              tr("%1 of %2 points").arg(screenNumber(points_, 0)).arg(10 * answers_.size()));
    if (!asked) return;
    question_->setText(explained(training::questionOf(exercise_->kind), exercise_->givens));
    if (chooses) {
        std::vector<QString> words;
        for (const Text choice : exercise_->choices) words.push_back(screenText(choice));
        fillChoices(*choice_, words);
    }
    const bool one_speed = exercise_->speed_rpm.from == exercise_->speed_rpm.to;
    speed_->setEnabled(!one_speed);
    listen_->setEnabled(cutsLeft_ > 0 && !grade_);
    listen_->setText(tr("Listen (%n left)", nullptr, cutsLeft_));
    answerLabel_->setText(screenText(exercise_->answer) +
                          (exercise_->unit.empty() ? QString() : " (" + screenText(exercise_->unit) + ")"));
    submit_->setEnabled(!grade_);
    if (grade_)
        result_->setHtml("<b>" + (grade_->correct ? tr("✓ Right.") : tr("✗ Not right.")) + "</b> " +
                         tr("%1 of 10 points. Right: %2.").arg(screenNumber(grade_->points, 0), expected()) + "<br/>" +
                         explained(training::explanationOf(exercise_->kind), grade_->numbers).toHtmlEscaped());
}

void ExercisePane::retranslate()
{
    std::vector<QString> words;
    for (const FieldChoice& choice : training::exerciseChoices()) words.push_back(screenText(choice.label));
    fillChoices(*kind_, words);
    pupilLabel_->setText(tr("Name"));
    kindLabel_->setText(tr("Exercise"));
    seedLabel_->setText(tr("Number"));
    seed_->setToolTip(tr("The same number gives the same exercise to everyone"));
    begin_->setText(tr("Begin the exercise"));
    speedLabel_->setText(tr("Speed (1/min)"));
    submit_->setText(tr("Answer"));
    sheet_->setText(tr("Sheet of results…"));
    kind_->setAccessibleName(tr("Exercise"));
    choice_->setAccessibleName(tr("Answer"));
    result_->setAccessibleName(tr("Answer"));
    answer_->setAccessibleName(tr("Answer"));
    show();
}

}  // namespace lathelier::training_panel
