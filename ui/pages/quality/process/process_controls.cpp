// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/process/process_controls.h"

#include "ui/format/reference_words.h"
#include "ui/pages/quality/process/process_names.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/narrow_choice.h"

#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QSpinBox>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int largestSize = 25; // of a subgroup

QComboBox* makeChoice(const QString& name, const char* objectName)
{
    auto* box = new NarrowChoice(9);
    box->setObjectName(QLatin1StringView(objectName));
    box->setAccessibleName(name);
    box->setToolTip(name);
    return box;
}

/// The first entry lets all through.
QComboBox* makeFilter(const QString& all, const QString& name, const char* objectName)
{
    QComboBox* box = makeChoice(name, objectName);
    box->addItem(all);
    return box;
}

void refillChoice(QComboBox* box, const QStringList& values, int kept)
{
    const QString chosen = box->currentData().toString();
    const QSignalBlocker quiet(box);
    while (box->count() > kept)
        box->removeItem(kept);
    for (const QString& value : values)
        if (!value.isEmpty())
            box->addItem(value, value);
    if (!chosen.isEmpty() && box->findData(chosen) < 0)
        box->addItem(chosen, chosen); // it is asked for still
    if (box->count() > 0)
        box->setCurrentIndex(std::max(0, box->findData(chosen)));
}

QStringList sortedNames(QStringList names)
{
    names.sort(Qt::CaseInsensitive);
    return names;
}

} // namespace

ProcessControls::ProcessControls(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    column->addWidget(makeFirst());
    m_second = makeSecond();
    m_second->hide();
    column->addWidget(m_second);
    connectAll();
    refresh();
}

QWidget* ProcessControls::makeFirst()
{
    auto* bar = new QWidget(this);
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    m_type = makeChoice(tr("Type"), "processType");
    m_kind = makeChoice(tr("Chart"), "processKind");
    for (const ProcessKind kind :
         {ProcessKind::Individuals, ProcessKind::MeanRange, ProcessKind::MeanDeviation, ProcessKind::Ewma,
          ProcessKind::Cusum, ProcessKind::Hotelling})
        m_kind->addItem(ProcessNames::kind(kind), int(kind));
    m_quantity = makeChoice(tr("Quantity"), "processQuantity");
    m_quantity->addItem(tr("m, b and k"), int(ProcessNames::allQuantities));
    for (const int i : {2, 0, 1})
        m_quantity->addItem(ReferenceWords::quantity(std::size_t(i)), i);
    m_rules = makeChoice(tr("Rules"), "processRules");
    for (const RunRules rules : {RunRules::WesternElectric, RunRules::Nelson, RunRules::None})
        m_rules->addItem(ProcessNames::rules(rules), int(rules));
    m_size = new QSpinBox;
    m_size->setObjectName("processSize");
    m_size->setRange(2, largestSize);
    m_size->setValue(5);
    m_size->setPrefix(tr("n = ", "size of a subgroup"));
    m_size->setAccessibleName(tr("Inspections in a subgroup"));
    m_size->setToolTip(tr("Inspections in a subgroup"));
    m_more = makeButton(tr("Filters"), u"view-filter"_s);
    m_more->setObjectName("processFilters");
    m_more->setCheckable(true);
    line->addWidget(m_type, 2);
    line->addWidget(m_kind, 3);
    line->addWidget(m_size);
    line->addWidget(m_quantity, 2);
    line->addWidget(m_rules, 2);
    line->addWidget(m_more);
    return bar;
}

QWidget* ProcessControls::makeSecond()
{
    auto* bar = new QWidget(this);
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    m_station = makeFilter(tr("All stations"), tr("Station"), "processStation");
    m_gripper = makeFilter(tr("All grippers"), tr("Gripper"), "processGripper");
    m_operator = makeFilter(tr("All operators"), tr("Operator"), "processOperator");
    m_batch = makeFilter(tr("All batches"), tr("Batch"), "processBatch");
    m_period = makeFilter(tr("Any time"), tr("When"), "processPeriod");
    m_period->addItem(tr("From … to …"), u"days"_s);
    const QDate today = QDate::currentDate();
    m_from = new QDateEdit(today.addDays(-7));
    m_to = new QDateEdit(today);
    m_from->setObjectName("processFrom");
    m_to->setObjectName("processTo");
    m_from->setAccessibleName(tr("First day"));
    m_to->setAccessibleName(tr("Last day"));
    for (QComboBox* box : {m_station, m_gripper, m_operator, m_batch, m_period})
        line->addWidget(box, 1);
    for (QDateEdit* edit : {m_from, m_to}) {
        edit->setCalendarPopup(true);
        line->addWidget(edit);
    }
    return bar;
}

void ProcessControls::connectAll()
{
    connect(m_more, &QPushButton::toggled, this, [this](bool on) { m_second->setVisible(on); });
    for (QComboBox* box : {m_type, m_gripper})
        connect(box, &QComboBox::currentIndexChanged, this, &ProcessControls::queryChanged);
    for (QComboBox* box : {m_station, m_operator, m_batch, m_period})
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            refresh();
            emit filterChanged();
        });
    for (QDateEdit* edit : {m_from, m_to})
        connect(edit, &QDateEdit::dateChanged, this, &ProcessControls::filterChanged);
    for (QComboBox* box : {m_kind, m_rules})
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            refresh();
            emit optionsChanged();
        });
    connect(m_size, &QSpinBox::valueChanged, this, &ProcessControls::optionsChanged);
    connect(m_quantity, &QComboBox::currentIndexChanged, this, &ProcessControls::quantityChanged);
}

/// What says nothing of this chart is not offered.
void ProcessControls::refresh()
{
    const auto kind = ProcessKind(m_kind->currentData().toInt());
    m_size->setVisible(takesSubgroups(kind));
    m_rules->setEnabled(takesRules(kind));
    m_quantity->setEnabled(kind != ProcessKind::Hotelling);
    const bool days = m_period->currentIndex() > 0;
    m_from->setVisible(days);
    m_to->setVisible(days);
    int active = 0;
    for (const QComboBox* box : {m_station, m_gripper, m_operator, m_batch, m_period})
        active += box->currentIndex() > 0 ? 1 : 0;
    m_more->setText(active > 0 ? tr("Filters (%1)").arg(active) : tr("Filters"));
}

ProcessQuery ProcessControls::query() const
{
    ProcessQuery query;
    query.type = m_type->currentData().toString();
    query.gripper = m_gripper->currentData().toString();
    return query;
}

ProcessFilter ProcessControls::filter() const
{
    ProcessFilter filter;
    filter.station = m_station->currentData().toString();
    filter.operatorName = m_operator->currentData().toString();
    filter.batch = m_batch->currentData().toString();
    if (m_period->currentIndex() > 0) {
        filter.from = std::min(m_from->date(), m_to->date()).startOfDay().toUTC();
        filter.to = std::max(m_from->date(), m_to->date()).addDays(1).startOfDay().toUTC();
    }
    return filter;
}

ProcessOptions ProcessControls::options() const
{
    ProcessOptions options;
    options.kind = ProcessKind(m_kind->currentData().toInt());
    options.rules = RunRules(m_rules->currentData().toInt());
    options.subgroup = m_size->value();
    return options;
}

std::size_t ProcessControls::quantity() const
{
    return std::size_t(m_quantity->currentData().toInt());
}

bool ProcessControls::hasType() const
{
    return m_type->count() > 0;
}

void ProcessControls::setTypes(const QStringList& types)
{
    const QString before = m_type->currentData().toString();
    refillChoice(m_type, types, 0);
    if (m_type->currentData().toString() != before)
        emit queryChanged();
}

void ProcessControls::setGrippers(const QStringList& grippers)
{
    refillChoice(m_gripper, grippers, 1);
}

void ProcessControls::setChoices(const ProcessValues& values)
{
    refillChoice(m_station, sortedNames(values.stationNames), 1);
    refillChoice(m_operator, sortedNames(values.operatorNames), 1);
    refillChoice(m_batch, sortedNames(values.batchNames), 1);
}

void ProcessControls::focusType()
{
    m_type->setFocus();
}

} // namespace gripscope
