// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "core/session/library/history_document.h"
#include "core/signal/recording/units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr QChar betweenFields(u'\x14'), betweenCharacteristics(u'\x0F');
constexpr int counts = 0, countsNot = 255; // K0002

// Letters of a field, as the K-field table of the format has them.
constexpr int longestPart = 30, longestBatch = 14, longestMachine = 40, longestGauge = 40,
              longestOperator = 50;

/// Whatever a person named, on one line and without the signs that part the fields.
QString aqdefText(QString text)
{
    for (QChar& letter : text)
        if (letter.unicode() < 32 || letter.unicode() == 127)
            letter = u' ';
    return text.simplified();
}

QByteArray aqdefBytes(const QString& text)
{
    return text.toLatin1();
}

QString gaugeOf(const HistoryEntry& entry)
{
    return aqdefText(entry.device + u' ' + entry.serial);
}

void addOnce(QStringList& names, const QString& name)
{
    if (!name.isEmpty() && !names.contains(name))
        names << name;
}

QString numberIn(const QStringList& names, const QString& name)
{
    return QString::number(names.indexOf(name) + 1);
}

bool countsIn(const HistoryEntry& entry)
{
    return entry.parameters && entry.voided.isEmpty() && entry.accepted &&
           entry.validity != ValidityVerdict::Invalid &&
           siFactor(entry.forceUnit, entry.positionUnit).has_value();
}

QString characteristicHead(std::size_t place, const ToleranceLimits& limits, double toSi)
{
    static const std::array<QString, 3> names{u"mass m"_s, u"damping b"_s, u"stiffness k"_s};
    const ParameterUnits units = siParameterUnits();
    const std::array<QString, 3> unit{units.m, units.b, units.k};
    const QString at = u"/%1 "_s.arg(place + 1);
    QString text = u"K2001"_s + at + QString::number(place + 1) + u"\r\n"_s;
    text += u"K2002"_s + at + names[place] + u"\r\n"_s;
    if (limits.lower && limits.upper)
        text += u"K2101"_s + at + QString::number((*limits.lower + *limits.upper) / 2 * toSi, 'g', 12) +
                u"\r\n"_s;
    if (limits.lower)
        text += u"K2110"_s + at + exactText(*limits.lower * toSi) + u"\r\n"_s;
    if (limits.upper)
        text += u"K2111"_s + at + exactText(*limits.upper * toSi) + u"\r\n"_s;
    return text + u"K2142"_s + at + unit[place] + u"\r\n"_s;
}

QString catalogueHead(const QString& field, const QStringList& names, int longest)
{
    QString text;
    for (qsizetype i = 0; i < names.size(); ++i)
        text += u"%1/%2 %3\r\n"_s.arg(field, QString::number(i + 1), names[i].left(longest));
    return text;
}

} // namespace

void AqdefCatalogue::add(const std::vector<HistoryEntry>& entries)
{
    for (const HistoryEntry& entry : entries) {
        if (!m_begun)
            m_type = entry.type;
        else if (m_type != entry.type)
            m_type.reset();
        m_begun = true;
        addOnce(m_operators, aqdefText(entry.operatorName));
        addOnce(m_stations, aqdefText(entry.station));
        addOnce(m_gauges, gaugeOf(entry));
    }
}

QByteArray AqdefCatalogue::head(const TypeRecord* type) const
{
    const QString part = m_type && !m_type->isEmpty() ? aqdefText(*m_type).left(longestPart) : u"various"_s;
    QString text = u"K0100 3\r\nK1001 %1\r\nK1002 %1\r\n"_s.arg(part);
    const std::optional<double> toSi =
        type != nullptr ? siFactor(type->forceUnit, type->positionUnit) : std::nullopt;
    for (std::size_t place = 0; place < 3; ++place)
        text += characteristicHead(
            place, toSi ? type->limits.quantities[place].value_or(ToleranceLimits()) : ToleranceLimits(),
            toSi.value_or(1));
    text += catalogueHead(u"K4062"_s, m_stations, longestMachine);
    text += catalogueHead(u"K4072"_s, m_gauges, longestGauge);
    return aqdefBytes(text + catalogueHead(u"K4092"_s, m_operators, longestOperator));
}

QString AqdefCatalogue::line(const HistoryEntry& entry) const
{
    const bool known = countsIn(entry);
    const double toSi = siFactor(entry.forceUnit, entry.positionUnit).value_or(0);
    QStringList characteristics;
    for (int i = 0; i < 3; ++i) {
        const double value = entry.parameters ? entry.parameters->vector()(i) * toSi : 0;
        const QStringList fields{exactText(value),
                                 QString::number(known ? counts : countsNot),
                                 entry.time.toUTC().toString(u"dd.MM.yyyy/HH:mm:ss"_s),
                                 QString(), // events
                                 entry.batch.isEmpty() ? QString()
                                                       : (u'#' + aqdefText(entry.batch)).left(longestBatch),
                                 u"0"_s, // nest: a number, which readers want to be there
                                 numberIn(m_operators, aqdefText(entry.operatorName)),
                                 numberIn(m_stations, aqdefText(entry.station)),
                                 QString(), // process parameter
                                 numberIn(m_gauges, gaugeOf(entry))};
        characteristics << fields.join(betweenFields);
    }
    return characteristics.join(betweenCharacteristics) + u"\r\n"_s;
}

QByteArray AqdefCatalogue::lines(const std::vector<HistoryEntry>& entries) const
{
    QString text;
    for (const HistoryEntry& entry : entries)
        text += line(entry);
    return aqdefBytes(text);
}

} // namespace gripscope
