// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report_words.h"
#include "ui/inspector/inspector_tabs.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QStringList>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString fieldsInLine(const protocol::ReportWords& words)
{
    if (!words.problem.isEmpty())
        return words.problem;
    QStringList parts;
    for (const protocol::FieldWords& field : words.fields)
        parts << u"%1 %2"_s.arg(field.name, field.value);
    return parts.join(u"; "_s);
}

} // namespace

void ReportTableModel::setReports(std::vector<LoggedReport> reports)
{
    m_all = std::move(reports);
    choose();
}

void ReportTableModel::setKind(Kind kind)
{
    m_kind = kind;
    choose();
}

void ReportTableModel::choose()
{
    beginResetModel();
    m_shown.clear();
    std::copy_if(m_all.rbegin(), m_all.rend(), std::back_inserter(m_shown),
                 [this](const LoggedReport& report) { return wanted(report); });
    endResetModel();
}

bool ReportTableModel::wanted(const LoggedReport& report) const
{
    const auto is = [&](protocol::ReportId id) {
        return report.size > 0 && report.bytes[0] == static_cast<std::uint8_t>(id);
    };
    switch (m_kind) {
    case Kind::All:
        return true;
    case Kind::Stream:
        return is(protocol::ReportId::Stream);
    case Kind::Answers:
        return is(protocol::ReportId::Acknowledgement);
    case Kind::Commands:
        return report.direction == ReportDirection::Out;
    case Kind::Features:
        return report.direction == ReportDirection::Feature;
    case Kind::Damaged:
        return protocol::checkReport(report.view()).has_value();
    }
    return false;
}

QString ReportTableModel::cell(const LoggedReport& report, int column) const
{
    switch (column) {
    case Time: {
        const std::chrono::duration<double, std::milli> before = m_all.back().time - report.time;
        return (before.count() > 0 ? u"−%L1 ms"_s : u"%L1 ms"_s).arg(before.count(), 0, 'f', 1);
    }
    case Direction:
        return report.direction == ReportDirection::In    ? tr("in")
               : report.direction == ReportDirection::Out ? (report.taken ? tr("out") : tr("not taken"))
                                                          : tr("feature");
    case Report:
        return protocol::reportInWords(report.view()).kind;
    case Words:
        return fieldsInLine(protocol::reportInWords(report.view()));
    default:
        return {};
    }
}

QString ReportTableModel::asText() const
{
    QStringList lines;
    for (const LoggedReport& report : m_shown)
        lines << QStringList{cell(report, Time), cell(report, Direction), cell(report, Report),
                             protocol::hexDump(report.view()).replace(u'\n', u' '), cell(report, Words)}
                     .join(u'\t');
    return lines.join(u'\n');
}

QVariant ReportTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || role != Qt::DisplayRole)
        return {};
    return cell(at(index.row()), index.column());
}

QVariant ReportTableModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[] = {tr("Time"), tr("Way"), tr("Report"), tr("In words")};
    return names[column];
}

namespace {

QPlainTextEdit* makeText(const QString& name, QWidget* parent)
{
    auto* text = new QPlainTextEdit(parent);
    text->setReadOnly(true);
    text->setAccessibleName(name);
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setFixedHeight(136);
    return text;
}

} // namespace

ReportsTab::ReportsTab(QWidget* parent) : QWidget(parent)
{
    m_model = new ReportTableModel(this);
    auto* kinds = new QComboBox(this);
    kinds->setAccessibleName(tr("Which reports"));
    kinds->addItems(
        {tr("All reports"), tr("Stream"), tr("Answers"), tr("Commands"), tr("Features"), tr("Damaged")});
    connect(kinds, &QComboBox::currentIndexChanged, m_model,
            [this](int index) { m_model->setKind(static_cast<ReportTableModel::Kind>(index)); });
    m_freeze = makeButton(tr("Freeze"), u"media-playback-pause"_s, "", this);
    m_freeze->setObjectName("freezeReports");
    m_freeze->setCheckable(true);
    auto* copy = makeButton(tr("Copy"), {}, "", this);
    connect(copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(m_model->asText()); });
    m_note = makeLabel({}, "second", this);

    m_table = new QTableView(this);
    m_table->setObjectName("reports");
    m_table->setAccessibleName(tr("The last reports"));
    m_table->setModel(m_model);
    setUpRowList(m_table, 28);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setColumnWidth(ReportTableModel::Time, 96);
    m_table->setColumnWidth(ReportTableModel::Direction, 80);
    m_table->setColumnWidth(ReportTableModel::Report, 144);
    // Whoever picks a report wants to read it.
    connect(m_table, &QTableView::clicked, this, [this] {
        m_freeze->setChecked(true);
        showChosen();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ReportsTab::showChosen);

    m_bytes = makeText(tr("The report's bytes"), this);
    m_bytes->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_bytes->setPlaceholderText(tr("Choose a report to read its bytes and fields"));
    m_fields = makeText(tr("The report's fields"), this);

    auto* tools = new QHBoxLayout;
    tools->setSpacing(8);
    tools->addWidget(kinds);
    tools->addWidget(m_freeze);
    tools->addWidget(copy);
    tools->addStretch(1);
    tools->addWidget(m_note);
    auto* chosen = new QHBoxLayout;
    chosen->setSpacing(8);
    chosen->addWidget(m_bytes, 1);
    chosen->addWidget(m_fields, 1);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    column->addLayout(tools);
    column->addWidget(m_table, 1);
    column->addLayout(chosen);
}

void ReportsTab::show(std::vector<LoggedReport> reports, std::uint64_t missed)
{
    if (m_freeze->isChecked())
        return;
    m_note->setText(missed > 0 ? tr("%n passed while this list was read", nullptr, static_cast<int>(missed))
                               : QString());
    m_model->setReports(std::move(reports));
}

void ReportsTab::showChosen()
{
    const QModelIndex index = m_table->currentIndex();
    if (!index.isValid())
        return;
    const LoggedReport& report = m_model->at(index.row());
    m_bytes->setPlainText(protocol::hexDump(report.view()));
    const protocol::ReportWords words = protocol::reportInWords(report.view());
    QStringList lines{words.kind};
    if (!words.problem.isEmpty())
        lines << words.problem;
    for (const protocol::FieldWords& field : words.fields)
        lines << u"%1: %2"_s.arg(field.name, field.value);
    m_fields->setPlainText(lines.join(u'\n'));
}

} // namespace gripscope
