// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace gripscope {

/// A number taken apart for the screen: only the digits that its uncertainty allows, in a handy multiple of
/// its unit.
struct FormattedNumber {
    QString value;                               ///< "9.98"
    QString error;                               ///< "0.05"; empty when there is none
    QString unit;                                ///< "kN/m"; empty for a bare number
    [[nodiscard]] QString text() const;          ///< "9.98 ± 0.05 kN/m"
    [[nodiscard]] QString valueWithUnit() const; ///< "9.98 kN/m"
    [[nodiscard]] QString number() const;        ///< "9.98 ± 0.05"
    friend bool operator==(const FormattedNumber&, const FormattedNumber&) = default;
};

/// `value` in `unit`, with the half width `error` of its interval. The error is rounded to two significant
/// digits when it starts with 1, else to one, and the value to the same place. Without an error (or when it
/// is not positive and finite): `digits` significant ones. The unit gets an SI prefix where that is
/// customary: kg -> g, mg; N, m, N/m, N s/m and s with k, m and µ; others stay as they are. A value that is
/// not finite reads "–". A unit that the person reads in another is converted (readUnit()).
[[nodiscard]] FormattedNumber formatNumber(double value, std::optional<double> error, const QString& unit,
                                           int digits = 3);

/// A number with its interval as a report states it (JCGM 100, 7.2.6): half the width of the interval to two
/// significant digits, everything else to the same place. For documents: with a decimal point in every
/// language and a plain minus. Units as in formatNumber(). Without an interval (not finite, or no width)
/// `half` is empty, and the value has six digits.
struct RoundedNumber {
    QString value, half, lower, upper, unit;
    friend bool operator==(const RoundedNumber&, const RoundedNumber&) = default;
};
[[nodiscard]] RoundedNumber roundedForReport(double value, double lower, double upper, const QString& unit);

/// 99.8 % from 99.8; one decimal unless it would hide that it is not 100.
[[nodiscard]] QString formatPercent(double percent, int decimals = 1);
/// A stated rate as it was set: 0.01 is "1 %", 0.0005 "0.05 %".
[[nodiscard]] QString formatRate(double rate);
/// A posterior, which is never quite certain: 0.9998, "> 0.9999", "< 0.0001".
[[nodiscard]] QString formatProbability(double probability);
/// The length of a squeeze (lengthSeconds()), the same wherever it stands: "0.17 s".
[[nodiscard]] QString formatLength(double seconds);
/// A count with thin spaces between thousands.
[[nodiscard]] QString formatCount(qint64 count);

/// A sentence of the core's for a label that breaks lines: no number is parted from its error or its percent
/// sign.
[[nodiscard]] QString keptTogether(QString sentence);

} // namespace gripscope
