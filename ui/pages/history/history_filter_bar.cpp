// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/history_words.h"
#include "ui/format/outcome_words.h"
#include "ui/pages/history/history_parts.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QLineEdit>

namespace gripscope {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

enum class Period { Any, Today, Week, Month, Days };

void refill(QComboBox* box, const QStringList& values)
{
    const QString chosen = box->currentData().toString();
    const QSignalBlocker quiet(box);
    while (box->count() > 1)
        box->removeItem(1);
    for (const QString& value : values)
        box->addItem(value, value);
    if (!chosen.isEmpty() && box->findData(chosen) < 0)
        box->addItem(chosen, chosen); // it filters still
    box->setCurrentIndex(std::max(0, box->findData(chosen)));
}

QDateTime startOf(const QDate& day)
{
    return day.startOfDay().toUTC();
}

} // namespace

HistoryFilterBar::HistoryFilterBar(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    column->addWidget(buildFirst());
    m_second = buildSecond();
    m_second->hide();
    column->addWidget(m_second);
    m_typing.setSingleShot(true);
    m_typing.setInterval(250ms);
    connect(&m_typing, &QTimer::timeout, this, &HistoryFilterBar::changed);
    connect(m_text, &QLineEdit::textChanged, this, [this] { m_typing.start(); });
    for (QComboBox* box :
         {m_kind, m_outcome, m_validity, m_type, m_expected, m_operator, m_device, m_batch, m_period})
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showPeriod();
            refreshMore();
            emit changed();
        });
    for (QDateEdit* edit : {m_from, m_to})
        connect(edit, &QDateEdit::dateChanged, this, &HistoryFilterBar::changed);
    showPeriod();
    refreshMore();
}

QComboBox* HistoryFilterBar::makeBox(const QString& all, const QString& name, const char* objectName)
{
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(objectName));
    box->addItem(all);
    box->setAccessibleName(name);
    box->setToolTip(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    return box;
}

QWidget* HistoryFilterBar::buildFirst()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    m_text = new QLineEdit;
    m_text->setObjectName("historyText");
    m_text->setPlaceholderText(tr("Search"));
    m_text->setToolTip(tr("In number, type, operator, gripper, batch, source or part"));
    m_text->setAccessibleName(tr("Search the history"));
    m_text->setClearButtonEnabled(true);
    m_kind = makeBox(tr("All kinds"), tr("Inspected or enrolled"), "historyKind");
    m_kind->addItem(tr("Inspections"), toString(SqueezeKind::Inspection));
    m_kind->addItem(tr("Enrolments"), toString(SqueezeKind::Enrollment));
    m_outcome = makeBox(tr("All outcomes"), tr("Outcome"), "historyOutcome");
    for (const InspectionOutcome outcome : allInspectionOutcomes)
        m_outcome->addItem(outcomeFilterWord(outcome), int(outcome));
    m_validity = makeBox(tr("Any validity"), tr("Validity of the measurement"), "historyValidity");
    for (const ValidityVerdict validity :
         {ValidityVerdict::Valid, ValidityVerdict::Suspect, ValidityVerdict::Invalid})
        m_validity->addItem(HistoryWords::validity(validity), int(validity));
    m_type = makeBox(tr("All types"), tr("Type named, or enrolled in"), "historyType");
    m_more = makeButton(tr("More filters"), u"view-filter"_s);
    m_more->setObjectName("historyMore");
    m_more->setCheckable(true);
    line->addWidget(m_text, 1);
    for (QWidget* widget :
         {static_cast<QWidget*>(m_kind), static_cast<QWidget*>(m_outcome), static_cast<QWidget*>(m_validity),
          static_cast<QWidget*>(m_type), static_cast<QWidget*>(m_more)})
        line->addWidget(widget);
    connect(m_more, &QPushButton::toggled, this, [this](bool on) { m_second->setVisible(on); });
    return bar;
}

QWidget* HistoryFilterBar::buildSecond()
{
    auto* bar = new QWidget;
    auto* lines = new QVBoxLayout(bar);
    setSpacing(lines, 0, metrics::step);
    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::step);
    auto* days = new QHBoxLayout; // below: the least window has no room for them beside the others
    days->setSpacing(metrics::step);
    lines->addLayout(line);
    lines->addLayout(days);
    m_expected = makeBox(tr("Any expected"), tr("Expected type"), "historyExpected");
    m_operator = makeBox(tr("All operators"), tr("Operator"), "historyOperator");
    m_device = makeBox(tr("All grippers"), tr("Gripper"), "historyDevice");
    m_batch = makeBox(tr("All batches"), tr("Batch"), "historyBatch");
    m_period = makeBox(tr("Any time"), tr("When"), "historyPeriod");
    m_period->setItemData(0, int(Period::Any));
    m_period->addItem(tr("Today"), int(Period::Today));
    m_period->addItem(tr("Last 7 days"), int(Period::Week));
    m_period->addItem(tr("Last 30 days"), int(Period::Month));
    m_period->addItem(tr("From … to …"), int(Period::Days));
    const QDate today = QDate::currentDate();
    m_from = new QDateEdit(today.addDays(-7));
    m_to = new QDateEdit(today);
    for (QDateEdit* edit : {m_from, m_to})
        edit->setCalendarPopup(true);
    m_from->setAccessibleName(tr("First day"));
    m_to->setAccessibleName(tr("Last day"));
    m_clear = makeButton(tr("Clear"), u"edit-clear"_s, "quiet");
    m_clear->setObjectName("historyClear");
    for (QWidget* widget :
         {static_cast<QWidget*>(m_expected), static_cast<QWidget*>(m_operator),
          static_cast<QWidget*>(m_device), static_cast<QWidget*>(m_batch), static_cast<QWidget*>(m_period)})
        line->addWidget(widget);
    line->addStretch();
    line->addWidget(m_clear);
    days->addStretch();
    days->addWidget(m_from);
    days->addWidget(m_to);
    connect(m_clear, &QPushButton::clicked, this, &HistoryFilterBar::clear);
    return bar;
}

void HistoryFilterBar::showPeriod()
{
    const bool days = Period(m_period->currentData().toInt()) == Period::Days;
    m_from->setVisible(days);
    m_to->setVisible(days);
}

/// What is folded away must not filter unseen.
void HistoryFilterBar::refreshMore()
{
    int active = 0;
    for (const QComboBox* box : {m_expected, m_operator, m_device, m_batch, m_period})
        active += box->currentIndex() > 0 ? 1 : 0;
    m_more->setText(active > 0 ? tr("More filters (%1)").arg(active) : tr("More filters"));
}

HistoryQuery HistoryFilterBar::query() const
{
    HistoryQuery query;
    query.text = m_text->text().trimmed();
    if (m_kind->currentIndex() > 0)
        query.kind = m_kind->currentData().toString() == toString(SqueezeKind::Inspection)
                         ? SqueezeKind::Inspection
                         : SqueezeKind::Enrollment;
    if (m_outcome->currentIndex() > 0)
        query.outcome = InspectionOutcome(m_outcome->currentData().toInt());
    if (m_validity->currentIndex() > 0)
        query.validity = ValidityVerdict(m_validity->currentData().toInt());
    query.type = m_type->currentData().toString();
    query.expected = m_expected->currentData().toString();
    query.operatorName = m_operator->currentData().toString();
    query.device = m_device->currentData().toString();
    query.batch = m_batch->currentData().toString();
    const QDate today = QDate::currentDate();
    switch (Period(m_period->currentData().toInt())) {
    case Period::Any:
        break;
    case Period::Today:
        query.from = startOf(today);
        break;
    case Period::Week:
        query.from = startOf(today.addDays(-6));
        break;
    case Period::Month:
        query.from = startOf(today.addDays(-29));
        break;
    case Period::Days:
        query.from = startOf(std::min(m_from->date(), m_to->date()));
        query.to = startOf(std::max(m_from->date(), m_to->date()).addDays(1));
    }
    return query;
}

void HistoryFilterBar::setChoices(const HistoryChoices& choices)
{
    refill(m_type, choices.types);
    refill(m_expected, choices.expected);
    refill(m_operator, choices.operators);
    refill(m_device, choices.devices);
    refill(m_batch, choices.batches);
}

void HistoryFilterBar::clear()
{
    {
        const QSignalBlocker quiet(this);
        m_text->clear();
        for (QComboBox* box :
             {m_kind, m_outcome, m_validity, m_type, m_expected, m_operator, m_device, m_batch, m_period})
            box->setCurrentIndex(0);
        m_typing.stop();
    }
    emit changed();
}

} // namespace gripscope
