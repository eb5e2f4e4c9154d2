// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/report_table_model.h"

#include "devices/protocol/report_words.h"

#include <QStringList>

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
        return protocol::inWords(report.view()).kind;
    case Words:
        return fieldsInLine(protocol::inWords(report.view()));
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

} // namespace gripscope
