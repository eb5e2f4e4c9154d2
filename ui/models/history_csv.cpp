// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_csv.h"

#include "core/signal/units.h"
#include "ui/models/history_model.h"

#include <QLocale>
#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString quoted(QString text)
{
    const bool plain =
        !text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r');
    return plain ? text : u'"' + text.replace(u'"', u"\"\""_s) + u'"';
}

QString number(const std::optional<double>& value)
{
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
}

QStringList cells(const InspectionRecord& record)
{
    const ParameterUnits units = parameterUnits(record.forceUnit, record.positionUnit);
    const auto& p = record.parameters;
    const auto part = [&p](double MassDampingStiffness::*member) {
        return p ? std::optional((*p).*member) : std::nullopt;
    };
    return {QString::number(record.number),
            record.inspected.toUTC().toString(Qt::ISODateWithMs),
            record.expectedType,
            toString(outcomeOf(record)),
            toString(record.verdict),
            record.type,
            record.nearest,
            number(record.posterior),
            number(part(&MassDampingStiffness::m)),
            p ? units.m : QString(),
            number(part(&MassDampingStiffness::b)),
            p ? units.b : QString(),
            number(part(&MassDampingStiffness::k)),
            p ? units.k : QString(),
            number(record.seconds),
            record.operatorName,
            record.reason};
}

} // namespace

QByteArray toCsv(const std::vector<InspectionRecord>& inspections)
{
    QString text =
        u"number,time_utc,expected,outcome,verdict,type,nearest,posterior,m,m_unit,b,b_unit,k,k_unit,"
        "squeeze_s,operator,reason\n"_s;
    for (const InspectionRecord& record : inspections) {
        QStringList line;
        for (const QString& cell : cells(record))
            line << quoted(cell);
        text += line.join(u',') + u'\n';
    }
    return text.toUtf8();
}

Expected<QByteArray> historyCsv(Library& library, HistoryFilter filter)
{
    filter.limit = 1000;
    std::vector<InspectionRecord> all;
    while (true) {
        filter.offset = int(all.size());
        const auto page = library.inspections(filter);
        if (!page)
            return tl::unexpected<Error>(page.error());
        all.insert(all.end(), page->begin(), page->end());
        if (int(page->size()) < filter.limit)
            return toCsv(all);
    }
}

} // namespace gripscope
