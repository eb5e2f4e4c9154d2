// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/units.h"

#include "core/base/display_units.h"

#include <array>
#include <utility>

namespace gripscope {

namespace {

using Factor = std::pair<const char16_t*, double>;

// The micro sign and the Greek letter look alike and are both in use.
constexpr std::array<Factor, 9> forceTable{{{u"uN", 1e-6},
                                            {u"\u00b5N", 1e-6},
                                            {u"\u03bcN", 1e-6},
                                            {u"mN", 1e-3},
                                            {u"N", 1.0},
                                            {u"kN", 1e3},
                                            {u"gf", 1e-3 * newtonsPerKilogramForce},
                                            {u"kgf", newtonsPerKilogramForce},
                                            {u"lbf", newtonsPerPoundForce}}};
constexpr std::array<Factor, 8> positionTable{{{u"nm", 1e-9},
                                               {u"um", 1e-6},
                                               {u"\u00b5m", 1e-6},
                                               {u"\u03bcm", 1e-6},
                                               {u"mm", 1e-3},
                                               {u"cm", 1e-2},
                                               {u"m", 1.0},
                                               {u"in", metresPerInch}}};

template <std::size_t N>
std::optional<double> lookUp(const std::array<Factor, N>& table, const QString& unit)
{
    for (const Factor& entry : table) {
        if (unit == QStringView(entry.first))
            return entry.second;
    }
    return std::nullopt;
}

template <std::size_t N>
QStringList namesOf(const std::array<Factor, N>& table)
{
    QStringList names;
    for (const Factor& entry : table)
        names << QString::fromUtf16(entry.first);
    return names;
}

/// force * s^power / position, leaving out what is "1".
QString derivedUnit(const QString& force, const QString& position, const QString& seconds)
{
    QStringList above;
    if (force != QLatin1String("1"))
        above << force;
    if (!seconds.isEmpty())
        above << seconds;
    const QString numerator = above.isEmpty() ? QStringLiteral("1") : above.join(QLatin1Char(' '));
    return position == QLatin1String("1") ? numerator : numerator + QLatin1Char('/') + position;
}

} // namespace

ParameterUnits parameterUnits(const QString& forceUnit, const QString& positionUnit)
{
    const QString one = QStringLiteral("1");
    if (forceUnit == one && positionUnit == one)
        return {one, one, one}; // a source without units: no seconds either
    ParameterUnits units{derivedUnit(forceUnit, positionUnit, QStringLiteral("s^2")),
                         derivedUnit(forceUnit, positionUnit, QStringLiteral("s")),
                         derivedUnit(forceUnit, positionUnit, QString())};
    if (forceUnit == QLatin1String("N") && positionUnit == QLatin1String("m"))
        units.m = QStringLiteral("kg");
    return units;
}

ParameterUnits siParameterUnits()
{
    return parameterUnits(QStringLiteral("N"), QStringLiteral("m"));
}

ParameterUnits comparableUnits(const QString& forceUnit, const QString& positionUnit)
{
    return siFactor(forceUnit, positionUnit) ? siParameterUnits() : parameterUnits(forceUnit, positionUnit);
}

QStringList forceUnits()
{
    return namesOf(forceTable);
}

QStringList positionUnits()
{
    return namesOf(positionTable);
}

std::optional<double> newtonsPer(const QString& unit)
{
    return lookUp(forceTable, unit);
}

std::optional<double> metresPer(const QString& unit)
{
    return lookUp(positionTable, unit);
}

std::optional<double> siFactor(const QString& forceUnit, const QString& positionUnit)
{
    const std::optional<double> force = newtonsPer(forceUnit);
    const std::optional<double> position = metresPer(positionUnit);
    if (!force || !position)
        return std::nullopt;
    return *force / *position;
}

std::optional<double> cubicSiFactor(const QString& forceUnit, const QString& positionUnit)
{
    const std::optional<double> force = newtonsPer(forceUnit);
    const std::optional<double> position = metresPer(positionUnit);
    if (!force || !position)
        return std::nullopt;
    return *force / (*position * *position * *position);
}

QString cubicStiffnessUnit(const QString& forceUnit, const QString& positionUnit)
{
    const QString unit = comparableUnits(forceUnit, positionUnit).k;
    return unit.contains(QLatin1Char('/')) ? unit + QChar(0x00B3) : unit;
}

} // namespace gripscope
