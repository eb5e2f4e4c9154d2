// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "core/quality/plan/plan_json.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/study_due_words.h"
#include "ui/pages/quality/study_views.h"
#include "ui/pages/quality/study_words.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int mostListed = 200;
constexpr int numberWidth = 24, buttonWidth = 128; // logical pixels

std::pair<QWidget*, QVBoxLayout*> makeStudyCard(const QString& heading, QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(heading, "heading", card));
    auto* rows = new QVBoxLayout;
    rows->setSpacing(8);
    column->addLayout(rows);
    return {card, rows};
}

void clearRows(QVBoxLayout* rows)
{
    while (QLayoutItem* item = rows->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

std::size_t plannedRows(const StudyRecord& study)
{
    const Expected<StudyPlan> plan = planFromJson(study.study.plan);
    return plan ? plan->rows.size() : 0;
}

} // namespace

StudyList::StudyList(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_advice(makeLabel({}, "second", this))
{
    auto* content = new QWidget(this);
    std::tie(m_open, m_openRows) = makeStudyCard(tr("Begun and not finished"), content);
    std::tie(m_kinds, m_kindRows) = makeStudyCard(tr("Studies, in the order of practice"), content);
    std::tie(m_done, m_doneRows) = makeStudyCard(tr("Studies so far"), content);
    m_open->setObjectName("openStudies");
    m_done->setObjectName("pastStudies");
    m_advice->setObjectName("studyAdvice");
    m_advice->setWordWrap(true);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 16);
    column->addWidget(m_advice);
    column->addWidget(m_open);
    column->addWidget(m_kinds);
    column->addWidget(m_done);
    column->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 0);
    outer->addWidget(makeScroll(content, this));
    connect(&workbench, &Workbench::connectionChanged, this, [this] {
        const ConnectSession& connection = m_workbench->connection();
        const bool connected = connection.state() == ConnectSession::State::Connected;
        if (m_serial != (connected ? connection.identity().serial : QString()))
            fillKinds(); // another gripper stands elsewhere
    });
    show({});
}

void StudyList::load()
{
    using Studies = std::vector<StudyRecord>;
    m_workbench->background().ask<Studies>(
        this, [](Library& library) { return library.studies(mostListed); },
        [this](Expected<Studies> studies) {
            if (studies)
                show(std::move(*studies));
            else
                m_workbench->messages().report(studies.error().describe());
        });
}

void StudyList::show(std::vector<StudyRecord> studies)
{
    m_studies = std::move(studies);
    m_advice->setText(advice());
    m_advice->setVisible(!m_advice->text().isEmpty());
    fillKinds();
    fillStudies();
}

QString StudyList::advice() const
{
    return m_studies.empty()
               ? tr("No study yet. Begin with a type-1 study if you have a part whose m, b or k "
                    "is known, else with gauge repeatability and reproducibility: ten parts, "
                    "three people, three squeezes each.")
               : QString();
}

QString StudyList::standing(const StudyStanding& standing) const
{
    const QString status =
        StudyDueWords::status(standing, QDate::currentDate(),
                              m_workbench->settings().get(StudyWords::repeatMonths(standing.kind)) > 0);
    if (!standing.last)
        return status;
    return status + u'\n' + finished(*standing.last, standing.kind);
}

QString StudyList::finished(const StudyRecord& last, StudyKind kind)
{
    const QString by = last.study.operatorName.isEmpty() ? tr("somebody not named") : last.study.operatorName;
    return kind == StudyKind::Attributes
               ? tr("finished %1 by %2").arg(dateText(last.ended.value_or(last.begun)), by)
               : tr("finished %1 by %2, gripper %3")
                     .arg(dateText(last.ended.value_or(last.begun)), by,
                          last.study.gripperSerial.isEmpty() ? u"–"_s : last.study.gripperSerial);
}

QString StudyList::transferStanding() const
{
    const auto last = std::ranges::find_if(m_studies, [](const StudyRecord& study) {
        return study.study.kind == toString(StudyKind::Transfer) && study.state == StudyState::Finished;
    });
    return last == m_studies.end() ? tr("with a second gripper") : finished(*last, StudyKind::Transfer);
}

QWidget* StudyList::makeKind(int number, const QString& name, const QString& answer, const QString& state,
                             QWidget* button)
{
    auto* box = new QWidget(m_kinds);
    auto* place = makeLabel(QString::number(number), "number", box);
    place->setFixedWidth(numberWidth);
    auto* title = makeLabel(name, "strong", box);
    auto* question = makeLabel(answer, "second", box);
    question->setWordWrap(true);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(title);
    words->addWidget(question);
    auto* standing = makeLabel(state, "caption", box);
    standing->setObjectName("studyStanding");
    standing->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    button->setParent(box);
    button->setFixedWidth(buttonWidth);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 16);
    row->addWidget(place);
    row->addLayout(words, 1);
    row->addWidget(standing);
    row->addWidget(button);
    return box;
}

void StudyList::fillKinds()
{
    clearRows(m_kindRows);
    int number = 0;
    const ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    m_serial = connected ? connection.identity().serial : QString();
    for (const StudyStanding& standing : studyStandings(m_studies, m_serial)) {
        const StudyKind kind = standing.kind;
        QPushButton* begin = makeButton(tr("Begin…"), {}, "");
        begin->setObjectName(u"begin-"_s + toString(kind));
        begin->setAccessibleName(tr("Begin: %1").arg(StudyWords::name(kind)));
        connect(begin, &QPushButton::clicked, this, [this, kind] { emit beginAsked(kind); });
        m_kindRows->addWidget(makeKind(++number, StudyWords::name(kind), StudyWords::answer(kind),
                                       this->standing(standing), begin));
        m_kindRows->addWidget(makeRule(m_kinds));
    }
    QPushButton* process = makeButton(tr("Open"), {}, "");
    process->setObjectName("openProcess");
    process->setAccessibleName(tr("Open: control charts and capability"));
    connect(process, &QPushButton::clicked, this, &StudyList::processAsked);
    m_kindRows->addWidget(makeKind(++number, tr("Control charts and capability"),
                                   tr("Is what is made steady, and within its limits?"),
                                   tr("from inspections"), process));
    m_kindRows->addWidget(makeRule(m_kinds));
    QPushButton* drift = makeButton(tr("Look"), {}, "");
    drift->setObjectName("openDrift");
    drift->setAccessibleName(tr("Look at what moved"));
    connect(drift, &QPushButton::clicked, this, &StudyList::driftAsked);
    m_kindRows->addWidget(
        makeKind(++number, tr("What moved"),
                 tr("Sensor, fingers or product: what lies elsewhere than when it was enrolled, "
                    "and since when?"),
                 tr("from inspections"), drift));
    m_kindRows->addWidget(makeRule(m_kinds));
    QPushButton* transfer = makeButton(tr("Begin…"), {}, "");
    transfer->setObjectName("beginTransfer");
    transfer->setAccessibleName(tr("Begin: %1").arg(tr("Another gripper")));
    connect(transfer, &QPushButton::clicked, this, &StudyList::transferAsked);
    m_kindRows->addWidget(makeKind(++number, tr("Another gripper"), StudyWords::answer(StudyKind::Transfer),
                                   transferStanding(), transfer));
}

QWidget* StudyList::makeStudy(const StudyRecord& study)
{
    const bool open = study.state == StudyState::Open;
    QWidget* parent = open ? m_open : m_done;
    auto* box = new QWidget(parent);
    auto* name = new ElidedLabel(study.study.name, box);
    name->setObjectName("studyName");
    setRole(name, "strong");
    const std::optional<StudyKind> kind = studyKindFromString(study.study.kind);
    auto* about = new ElidedLabel({}, box);
    setRole(about, "caption");
    about->setParts(
        {StudyWords::state(study, plannedRows(study)), kind ? StudyWords::name(*kind) : study.study.kind,
         study.study.operatorName.isEmpty() ? tr("somebody not named") : study.study.operatorName,
         timeText(study.ended.value_or(study.begun)),
         tr("gripper %1").arg(study.study.gripperSerial.isEmpty() ? u"–"_s : study.study.gripperSerial)},
        u" · "_s);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(name);
    words->addWidget(about);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    row->addLayout(words, 1);
    QPushButton* button = open ? makeButton(tr("Go on"), u"media-playback-start"_s, "primary", box)
                               : makeButton(tr("Open"), {}, "", box);
    button->setObjectName(open ? "goOnWithStudy" : "openStudy");
    button->setAccessibleName((open ? tr("Go on with %1") : tr("Open %1")).arg(study.study.name));
    button->setMinimumWidth(buttonWidth);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, id = study.id] { emit openAsked(id); });
    return box;
}

void StudyList::fillStudies()
{
    clearRows(m_openRows);
    clearRows(m_doneRows);
    bool anyOpen = false, anyDone = false;
    for (const StudyRecord& study : m_studies) {
        const bool open = study.state == StudyState::Open;
        (open ? m_openRows : m_doneRows)->addWidget(makeStudy(study));
        (open ? anyOpen : anyDone) = true;
    }
    m_open->setVisible(anyOpen);
    m_done->setVisible(anyDone);
}

} // namespace gripscope
