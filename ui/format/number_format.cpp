// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"

#include "core/base/words.h"
#include "ui/format/shown_unit.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

struct Scaled {
    double factor = 1; ///< multiply the number by this
    QString unit;
};

int decade(double value)
{
    return static_cast<int>(std::floor(std::log10(value)));
}

/// Kilograms go to grams and milligrams; the units of stiffness, damping, force and length take k, m and µ.
Scaled scaleFor(double magnitude, const QString& unit)
{
    const bool prefixed = unit == "N"_L1 || unit == "m"_L1 || unit == "s"_L1 || unit == "N/m"_L1 ||
                          unit == "N s/m"_L1 || unit == "N·s/m"_L1;
    if (!(magnitude > 0) || (!prefixed && unit != "kg"_L1))
        return {1, unit};
    if (unit == "kg"_L1) {
        if (magnitude >= 1)
            return {1, unit};
        return magnitude >= 1e-3 ? Scaled{1e3, u"g"_s} : Scaled{1e6, u"mg"_s};
    }
    if (magnitude >= 1e6 && unit != "s"_L1)
        return {1e-6, "M"_L1 + unit};
    if (magnitude >= 1e3 && unit != "s"_L1)
        return {1e-3, "k"_L1 + unit};
    if (magnitude >= 1)
        return {1, unit};
    return magnitude >= 1e-3 ? Scaled{1e3, "m"_L1 + unit} : Scaled{1e6, u"µ"_s + unit};
}

/// The place (power of ten) of the last digit that an error of this size allows.
int lastPlace(double error)
{
    const int first = decade(error);
    const double leading = error / std::pow(10.0, first);
    // 0.0951 rounds to 0.10: judge the digits after rounding to two.
    const double rounded = std::round(leading * 10) / 10;
    if (rounded >= 10)
        return first; // becomes 10: two digits, one decade up
    return rounded < 2 ? first - 1 : first;
}

/// `value` rounded at the place 10^`place`, with the digits that this leaves.
QString atPlace(double value, int place)
{
    const double step = std::pow(10.0, place);
    const double rounded = std::round(value / step) * step;
    QString text = Words::number(rounded, 'f', std::max(0, -place));
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

double toSignificant(double value, int digits)
{
    if (value == 0)
        return 0;
    const double step = std::pow(10.0, decade(std::abs(value)) - (digits - 1));
    return std::round(value / step) * step;
}

} // namespace

QString FormattedNumber::valueWithUnit() const
{
    return unit.isEmpty() ? value : value + QChar(0x00A0) + unit;
}

QString FormattedNumber::number() const
{
    return error.isEmpty() ? value : u"%1 ± %2"_s.arg(value, error);
}

QString FormattedNumber::text() const
{
    return unit.isEmpty() ? number() : number() + QChar(0x00A0) + unit;
}

FormattedNumber formatNumber(double value, std::optional<double> error, const QString& unit, int digits)
{
    const ShownUnit read = readUnit(unit == "1"_L1 ? QString() : unit);
    if (!std::isfinite(value))
        return {u"–"_s, {}, read.unit};
    value *= read.factor;
    if (error)
        *error *= read.factor;
    const bool hasError = error && std::isfinite(*error) && *error > 0;
    // Rounded first: 999.7 N/m becomes 1.00 kN/m, not 1000 N/m.
    if (!hasError)
        value = toSignificant(value, digits);
    const double magnitude = std::abs(value);
    const Scaled scaled = scaleFor(hasError ? std::max(magnitude, *error) : magnitude, read.unit);
    const double number = value * scaled.factor;
    FormattedNumber out;
    out.unit = scaled.unit;
    if (hasError) {
        const double width = *error * scaled.factor;
        // An error far below the value still leaves at most six digits: nobody reads more.
        const int finest = number == 0 ? -12 : decade(std::abs(number)) - 5;
        const int place = std::max(lastPlace(width), finest);
        out.value = atPlace(number, place);
        out.error = atPlace(std::max(width, std::pow(10.0, place)), place);
        return out;
    }
    const int place = number == 0 ? 0 : decade(std::abs(number)) - (digits - 1);
    out.value = atPlace(number, place);
    return out;
}

RoundedNumber roundedForReport(double value, double lower, double upper, const QString& unit)
{
    const ShownUnit read = readUnit(unit == "1"_L1 ? QString() : unit);
    if (!std::isfinite(value))
        return {{}, {}, {}, {}, read.unit};
    const double half = (upper - lower) / 2 * read.factor;
    const bool hasInterval = std::isfinite(half) && half > 0;
    const double magnitude = std::abs(value * read.factor);
    const Scaled scaled = scaleFor(hasInterval ? std::max(magnitude, half) : magnitude, read.unit);
    const double factor = read.factor * scaled.factor;
    if (!hasInterval)
        return {QString::number(value * factor, 'g', 6), {}, {}, {}, scaled.unit};
    const double width = half * scaled.factor;
    int place = decade(width) - 1;
    if (std::round(width / std::pow(10.0, place)) >= 100)
        ++place; // 0.0996 becomes 0.10
    const auto rounded = [&](double number) {
        const double step = std::pow(10.0, place);
        const double nearest = std::round(number / step) * step;
        return QString::number(nearest == 0 ? 0 : nearest, 'f', std::clamp(-place, 0, 17));
    };
    return {rounded(value * factor), rounded(width), rounded(lower * factor), rounded(upper * factor),
            scaled.unit};
}

QString formatPercent(double percent, int decimals)
{
    if (!std::isfinite(percent))
        return u"–"_s;
    // "100.0 %" is said of the whole only.
    if (percent < 100 && QString::number(percent, 'f', decimals).toDouble() >= 100)
        percent = 100 - std::pow(10.0, -decimals);
    QString text = Words::number(percent, 'f', decimals);
    return text.replace(QLatin1Char('-'), QChar(0x2212)) + QChar(0x00A0) + QLatin1Char('%');
}

QString formatRate(double rate)
{
    return Words::number(100 * rate, 'g', 4) + QChar(0x00A0) + QLatin1Char('%');
}

QString formatProbability(double probability)
{
    if (!std::isfinite(probability))
        return u"–"_s;
    if (probability > 0.9999)
        return u"> "_s + Words::number(0.9999, 'f', 4);
    if (probability < 0.0001)
        return u"< "_s + Words::number(0.0001, 'f', 4);
    return Words::number(probability, 'f', 4);
}

QString formatLength(double seconds)
{
    return Words::number(seconds, 'f', 2) + QChar::Nbsp + u's';
}

QString formatCount(qint64 count)
{
    QString text = QString::number(count);
    const qsizetype first = text.startsWith(QLatin1Char('-')) ? 1 : 0;
    for (qsizetype i = text.size() - 3; i > first; i -= 3)
        text.insert(i, QChar(0x202F));
    return text;
}

QString keptTogether(QString sentence)
{
    static const QRegularExpression withinNumber(u"(?<=[0-9]) (?=[±%])|(?<=±) (?=[0-9])"_s);
    return sentence.replace(withinNumber, QString(QChar::Nbsp));
}

} // namespace gripscope
