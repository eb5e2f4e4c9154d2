// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/imports/foreign_table_dialog.h"

#include "core/base/words.h"
#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/narrow_choice.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double millisecondsInOne = 1e3; ///< second
constexpr int mostLinesAround = 10'000;
constexpr int noColumn = -1;

const RegisteredDialog<ForeignTableDialog> foreignTableRow("foreign table", [](Workbench&, QWidget* over) {
    const QByteArray head("t;F;x\n0;1,5;2\n1;2,5;3\n");
    CsvReadOptions proposal;
    if (const Expected<ForeignTable> table = examineTable(head, u"table.csv"_s))
        proposal = proposedReading(*table);
    return new ForeignTableDialog(u"table.csv"_s, head, proposal, over);
});

QComboBox* makeChoiceBox(const QString& name)
{
    auto* box = new NarrowChoice(9); // columns may have long names
    box->setObjectName(name);
    box->setMinimumHeight(metrics::touchTarget);
    return box;
}

QSpinBox* makeCountBox(const QString& name, std::size_t value)
{
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setMinimumHeight(metrics::touchTarget);
    box->setRange(0, mostLinesAround);
    box->setValue(static_cast<int>(std::min<std::size_t>(value, mostLinesAround)));
    return box;
}

/// Each unit in one spelling, the one given among them.
QComboBox* makeUnitBox(const QString& name, const QStringList& units, const QString& chosen,
                       const std::function<std::optional<double>(const QString&)>& factor)
{
    QComboBox* box = makeChoiceBox(name);
    box->addItem(ForeignTableDialog::tr("not known"), QString());
    for (const QString& unit : units)
        if (!unit.startsWith(u'u') && !unit.startsWith(QChar(0x03BC))) // µ has three spellings
            box->addItem(unit, unit);
    for (int i = 1; i < box->count(); ++i)
        if (!chosen.isEmpty() && factor(box->itemData(i).toString()) == factor(chosen))
            box->setCurrentIndex(i);
    return box;
}

void chooseData(QComboBox* box, const QVariant& data)
{
    box->setCurrentIndex(std::max(0, box->findData(data)));
}

QString importReading(double value, const QString& unit)
{
    return unit.isEmpty() ? Words::number(value) : Words::number(value) + QChar(QChar::Nbsp) + unit;
}

} // namespace

ForeignTableDialog::ForeignTableDialog(const QString& name, QByteArray head, const CsvReadOptions& proposal,
                                       QWidget* parent)
    : Dialog(parent), m_name(name), m_head(std::move(head))
{
    setObjectName("foreignTableDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import a table"));
    setManualPage(u"fit"_s);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 2 * metrics::step, metrics::step);
    auto* heading = makeLabel(
        tr("%1 was written by another program. Say what in it is what; for tables of this layout it is "
           "remembered.")
            .arg(name));
    heading->setWordWrap(true);
    column->addWidget(heading);
    column->addWidget(buildFormat(proposal.format));
    column->addWidget(buildColumns(proposal));
    column->addWidget(buildPreview(), 1);
    m_words = makeLabel({}, "second");
    m_words->setObjectName("importWords");
    m_words->setWordWrap(true);
    column->addWidget(m_words);
    column->addWidget(buildButtons());
    m_columns = proposal.columns.value_or(CsvColumns{0, 1, std::nullopt});
    examine();
    resize(900, 540);
}

void ForeignTableDialog::ask(QGridLayout* grid, int row, int column, const QString& words, QWidget* control)
{
    auto* label = makeLabel(words, "second");
    label->setWordWrap(true);
    label->setBuddy(control);
    control->setAccessibleName(words);
    grid->addWidget(label, row, column, Qt::AlignBottom);
    grid->addWidget(control, row + 1, column);
    grid->setColumnStretch(column, 1);
}

QWidget* ForeignTableDialog::buildFormat(const CsvFormat& format)
{
    auto* part = new QWidget;
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::step);
    m_delimiter = makeChoiceBox(u"importDelimiter"_s);
    m_delimiter->addItem(tr("comma"), u","_s);
    m_delimiter->addItem(tr("semicolon"), u";"_s);
    m_delimiter->addItem(tr("tab"), u"\t"_s);
    chooseData(m_delimiter, QString(QLatin1Char(format.delimiter)));
    m_mark = makeChoiceBox(u"importDecimalMark"_s);
    m_mark->addItem(tr("point: 1.5"), u"."_s);
    m_mark->addItem(tr("comma: 1,5"), u","_s);
    chooseData(m_mark, QString(QLatin1Char(format.decimalMark)));
    m_skipped = makeCountBox(u"importSkippedLines"_s, format.skippedLines);
    m_header = new QCheckBox(tr("a line of names"));
    m_header->setObjectName("importHeader");
    m_header->setMinimumHeight(metrics::touchTarget);
    m_header->setChecked(format.header);
    m_below = makeCountBox(u"importLinesBelow"_s, format.linesBelow);
    ask(grid, 0, 0, tr("Between fields"), m_delimiter);
    ask(grid, 0, 1, tr("Decimal mark"), m_mark);
    ask(grid, 0, 2, tr("Lines to skip before"), m_skipped);
    ask(grid, 0, 3, tr("The table has"), m_header);
    ask(grid, 0, 4, tr("Lines below the names"), m_below);
    for (QComboBox* box : {m_delimiter, m_mark})
        connect(box, &QComboBox::currentIndexChanged, this, &ForeignTableDialog::examine);
    for (QSpinBox* box : {m_skipped, m_below})
        connect(box, &QSpinBox::valueChanged, this, &ForeignTableDialog::examine);
    connect(m_header, &QCheckBox::toggled, this, &ForeignTableDialog::examine);
    return part;
}

QWidget* ForeignTableDialog::buildColumns(const CsvReadOptions& proposal)
{
    auto* part = new QWidget;
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::step);
    m_time = makeChoiceBox(u"importTime"_s);
    m_force = makeChoiceBox(u"importForce"_s);
    m_position = makeChoiceBox(u"importPosition"_s);
    m_timeUnit = makeChoiceBox(u"importTimeUnit"_s);
    for (const QString& unit : timeUnits())
        m_timeUnit->addItem(unit, *secondsPer(unit));
    chooseData(m_timeUnit, proposal.timeUnit_s);
    m_forceUnit = makeUnitBox(u"importForceUnit"_s, forceUnits(), proposal.forceUnit, newtonsPer);
    m_positionUnit = makeUnitBox(u"importPositionUnit"_s, positionUnits(), proposal.positionUnit, metresPer);
    m_hold = makeChoiceBox(u"importHold"_s);
    m_hold->addItem(tr("not known"), -1);
    m_hold->addItem(tr("held (zoh)"), int(ForceHold::Zero));
    m_hold->addItem(tr("straight line (foh)"), int(ForceHold::First));
    chooseData(m_hold, proposal.hold ? int(*proposal.hold) : -1);
    m_sampleTime = new QDoubleSpinBox;
    m_sampleTime->setObjectName("importSampleTime");
    m_sampleTime->setMinimumHeight(metrics::touchTarget);
    m_sampleTime->setDecimals(6);
    m_sampleTime->setRange(shortestSampleTime_s * millisecondsInOne, longestSampleTime_s * millisecondsInOne);
    m_sampleTime->setValue(proposal.sampleTime_s.value_or(1e-3) * millisecondsInOne);
    ask(grid, 0, 0, tr("Time"), m_time);
    ask(grid, 0, 1, tr("Force"), m_force);
    ask(grid, 0, 2, tr("Position"), m_position);
    ask(grid, 0, 3, tr("Force between samples"), m_hold);
    ask(grid, 2, 0, tr("Unit of time"), m_timeUnit);
    ask(grid, 2, 1, tr("Unit of force"), m_forceUnit);
    ask(grid, 2, 2, tr("Unit of position"), m_positionUnit);
    ask(grid, 2, 3, tr("Sample time (ms)"), m_sampleTime);
    for (QComboBox* box : {m_time, m_force, m_position, m_timeUnit, m_forceUnit, m_positionUnit, m_hold})
        connect(box, &QComboBox::currentIndexChanged, this, &ForeignTableDialog::refresh);
    connect(m_sampleTime, &QDoubleSpinBox::valueChanged, this, &ForeignTableDialog::refresh);
    return part;
}

QWidget* ForeignTableDialog::buildPreview()
{
    m_preview = new QTableWidget;
    m_preview->setObjectName("importPreview");
    m_preview->setAccessibleName(tr("First rows"));
    m_preview->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_preview->setSelectionMode(QAbstractItemView::NoSelection);
    m_preview->verticalHeader()->hide();
    m_preview->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_preview->setMinimumHeight(96);
    return m_preview;
}

QWidget* ForeignTableDialog::buildButtons()
{
    auto* bar = new QWidget;
    auto* line = new QHBoxLayout(bar);
    setSpacing(line, 0, metrics::step);
    auto* cancel = makeButton(tr("Cancel"));
    m_import = makeButton(tr("Import"), {}, "primary");
    m_import->setObjectName("importTable");
    m_import->setDefault(true);
    line->addStretch();
    line->addWidget(cancel);
    line->addWidget(m_import);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_import, &QPushButton::clicked, this, [this] { emit wanted(options()); });
    return bar;
}

CsvFormat ForeignTableDialog::format() const
{
    CsvFormat format;
    format.delimiter = m_delimiter->currentData().toString()[0].toLatin1();
    format.decimalMark = m_mark->currentData().toString()[0].toLatin1();
    format.skippedLines = static_cast<std::size_t>(m_skipped->value());
    format.header = m_header->isChecked();
    format.linesBelow = format.header ? static_cast<std::size_t>(m_below->value()) : 0;
    return format;
}

CsvReadOptions ForeignTableDialog::options() const
{
    CsvReadOptions options;
    options.format = format();
    CsvColumns columns;
    columns.force = static_cast<std::size_t>(std::max(0, m_force->currentData().toInt()));
    columns.position = static_cast<std::size_t>(std::max(0, m_position->currentData().toInt()));
    if (const int time = m_time->currentData().toInt(); time != noColumn)
        columns.time = static_cast<std::size_t>(time);
    else
        options.sampleTime_s = m_sampleTime->value() / millisecondsInOne;
    options.columns = columns;
    options.timeUnit_s = m_timeUnit->currentData().toDouble();
    options.forceUnit = m_forceUnit->currentData().toString();
    options.positionUnit = m_positionUnit->currentData().toString();
    if (const int hold = m_hold->currentData().toInt(); hold >= 0)
        options.hold = ForceHold(hold);
    return options;
}

void ForeignTableDialog::setColumns(const CsvColumns& columns)
{
    chooseData(m_time, columns.time ? int(*columns.time) : noColumn);
    chooseData(m_force, int(columns.force));
    chooseData(m_position, int(columns.position));
}

void ForeignTableDialog::examine()
{
    m_below->setEnabled(m_header->isChecked());
    const Expected<ForeignTable> table = examineTable(m_head, m_name, format());
    m_table = table ? *table : ForeignTable{format(), {}, {}, {}};
    const QSignalBlocker noTime(m_time), noForce(m_force), noPosition(m_position);
    for (QComboBox* box : {m_time, m_force, m_position}) {
        box->clear();
        if (box == m_time)
            box->addItem(tr("no column"), noColumn);
        for (qsizetype i = 0; i < m_table.columns.size(); ++i)
            box->addItem(m_table.columns[i].isEmpty() ? QString::number(i + 1) : m_table.columns[i], int(i));
    }
    setColumns(m_columns);
    refresh();
}

void ForeignTableDialog::showRows()
{
    const CsvColumns chosen = *options().columns;
    m_preview->clear();
    m_preview->setColumnCount(static_cast<int>(m_table.columns.size()));
    m_preview->setRowCount(static_cast<int>(m_table.rows.size()));
    QStringList heads;
    for (qsizetype i = 0; i < m_table.columns.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        QString role;
        if (at == chosen.force)
            role = tr("Force");
        else if (at == chosen.position)
            role = tr("Position");
        else if (chosen.time == at)
            role = tr("Time");
        const QString name = m_table.columns[i];
        heads << (role.isEmpty() ? name : u"%1 → %2"_s.arg(name, role));
    }
    m_preview->setHorizontalHeaderLabels(heads);
    for (int row = 0; row < m_preview->rowCount(); ++row) {
        const QStringList& fields = m_table.rows[static_cast<std::size_t>(row)];
        for (int i = 0; i < m_preview->columnCount(); ++i)
            m_preview->setItem(row, i, new QTableWidgetItem(fields.value(i)));
    }
    m_preview->resizeColumnsToContents();
}

void ForeignTableDialog::refresh()
{
    m_sampleTime->setEnabled(m_time->currentData().toInt() == noColumn);
    m_timeUnit->setEnabled(!m_sampleTime->isEnabled());
    m_import->setEnabled(false);
    showRows();
    if (m_table.columns.size() < 2 || m_table.rows.empty()) {
        showProblem(tr("There are no two columns of numbers in it so."));
        return;
    }
    const CsvReadOptions how = options();
    m_columns = *how.columns;
    const Expected<Recording> taken = parseRecordingCsv(m_head, m_name, how);
    if (!taken) {
        showProblem(taken.error().describe());
        return;
    }
    setRole(m_words, "second");
    m_words->setText(tr("The first row is read as force %1, position %2. Sample time %3 ms.")
                         .arg(importReading(taken->force.front(), how.forceUnit),
                              importReading(taken->position.front(), how.positionUnit),
                              Words::number(taken->sampleTime_s * millisecondsInOne)));
    m_import->setEnabled(!m_reading);
}

void ForeignTableDialog::setReading(bool reading)
{
    m_reading = reading;
    m_import->setEnabled(!reading);
    if (reading) {
        setRole(m_words, "second");
        m_words->setText(tr("Reading…"));
    }
}

void ForeignTableDialog::showProblem(const QString& words)
{
    setRole(m_words, "error");
    m_words->setText(words);
}

} // namespace gripscope
