// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "core/identification/result/determined_parameters.h"
#include "core/identification/uncertainty/derived_quantities.h"
#include "ui/format/estimate_words.h"
#include "ui/format/number_format.h"
#include "ui/format/parameter_text.h"
#include "ui/format/shown_budget.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct ResultWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::ResultText)
};

/// Difference of the parts above and below the value, as a share of half the interval, up to which ± tells
/// the truth.
constexpr double askewForPaper = 0.1;

struct Symbol {
    const char16_t *id, *symbol, *latex;
};
constexpr std::array symbols{Symbol{u"natural_frequency", u"f0", u"f_0"},
                             Symbol{u"damping_ratio", u"zeta", u"\\zeta"},
                             Symbol{u"damped_frequency", u"fd", u"f_\\mathrm{d}"},
                             Symbol{u"decay_time", u"tau", u"\\tau"},
                             Symbol{u"time_constant", u"tau", u"\\tau"},
                             Symbol{u"time_constant_slow", u"tau_slow", u"\\tau_\\mathrm{slow}"},
                             Symbol{u"time_constant_fast", u"tau_fast", u"\\tau_\\mathrm{fast}"}};

/// In the order of MotionParameter. (tau is a decay time among what follows from m, b and k.)
constexpr std::array<Symbol, motionParameters> parameterNames{
    Symbol{u"mass", u"m", u"m"},
    Symbol{u"damping", u"b", u"b"},
    Symbol{u"stiffness", u"k", u"k"},
    Symbol{u"friction", u"Fc", u"F_\\mathrm{c}"},
    Symbol{u"yielding stiffness", u"k1", u"k_1"},
    Symbol{u"relaxation time", u"tau_relaxation", u"\\tau_\\mathrm{r}"},
    Symbol{u"cubic stiffness", u"k3", u"k_3"},
    Symbol{u"damping back", u"b_back", u"b_\\mathrm{back}"},
    Symbol{u"friction back", u"Fc_back", u"F_\\mathrm{c,back}"},
    Symbol{u"force offset", u"force_offset", u"F_0"}};

void addDerived(std::vector<ReportedResult>& results, const UncertaintyBudget& budget)
{
    for (const DerivedQuantity& one : derivedFrom(budget)) {
        if (!one.value)
            continue;
        ReportedResult result{one.name.english(),
                              one.id,
                              u"\\mathrm{?}"_s,
                              *one.value,
                              one.interval.lower,
                              one.interval.upper,
                              one.interval.onlyUpperBound,
                              false,
                              one.unit};
        for (const Symbol& symbol : symbols)
            if (one.id == QStringView(symbol.id)) {
                result.symbol = QString::fromUtf16(symbol.symbol);
                result.latex = QString::fromUtf16(symbol.latex);
            }
        results.push_back(std::move(result));
    }
}

bool hasInterval(const ReportedResult& result)
{
    return std::isfinite(result.upper - result.lower) && result.upper > result.lower;
}

bool isAskew(const ReportedResult& result)
{
    const double above = result.upper - result.value;
    const double below = result.value - result.lower;
    return std::abs(above - below) > askewForPaper * (above + below) / 2;
}

/// A number of roundedForReport() as it is read in this language.
QString localNumber(QString number)
{
    return number.replace(u'.', QLocale().decimalPoint()).replace(u'-', QChar(0x2212));
}

QString reportedText(const ReportedResult& result)
{
    const RoundedNumber number = roundedForReport(result.value, result.lower, result.upper, result.unit);
    const QString unit = number.unit.isEmpty() ? QString() : QChar(QChar::Nbsp) + number.unit;
    const QString name = result.symbol;
    if (result.onlyLowerBound)
        return ResultWords::tr("%1: at least %2").arg(name, localNumber(number.value) + unit);
    if (!hasInterval(result))
        return ResultWords::tr("%1 = %2 (no interval)").arg(name, localNumber(number.value) + unit);
    if (result.onlyUpperBound)
        return ResultWords::tr("%1: at most %2").arg(name, localNumber(number.upper) + unit);
    if (isAskew(result))
        return ResultWords::tr("%1 = %2 (%3 to %4)")
            .arg(name, localNumber(number.value) + unit, localNumber(number.lower),
                 localNumber(number.upper));
    return u"%1 = %2 ± %3%4"_s.arg(name, localNumber(number.value), localNumber(number.half), unit);
}

/// A unit within \mathrm: "N s^2/mm" is N\,s^{2}/mm. What means something to LaTeX is none in a unit.
QString latexUnit(const QString& unit)
{
    QString text;
    for (qsizetype i = 0; i < unit.size(); ++i) {
        const QChar letter = unit[i];
        if (letter == u' ' || letter == QChar(0x00B7) || letter == QChar(QChar::Nbsp))
            text += u"\\,"_s;
        else if (letter == QChar(0x00B5) || letter == QChar(0x03BC))
            text += u"\\mu "_s;
        else if (letter == QChar(0x00B2) || letter == QChar(0x00B3))
            text += letter == QChar(0x00B2) ? u"^{2}"_s : u"^{3}"_s;
        else if (letter == u'^' && i + 1 < unit.size() && unit[i + 1].isDigit())
            text += u"^{%1}"_s.arg(unit[++i]);
        else if (letter.isLetterOrNumber() || letter == u'/' || letter == u'-')
            text += letter;
        else if (letter == QChar(0x00B0))
            text += u"^\\circ "_s;
    }
    return text;
}

QString latexOf(const ReportedResult& result)
{
    const RoundedNumber number = roundedForReport(result.value, result.lower, result.upper, result.unit);
    const QString unit = number.unit.isEmpty() ? QString() : u"\\,\\mathrm{%1}"_s.arg(latexUnit(number.unit));
    if (result.onlyLowerBound)
        return u"$%1 \\ge %2%3$"_s.arg(result.latex, number.value, unit);
    if (!hasInterval(result))
        return u"$%1 = %2%3$"_s.arg(result.latex, number.value, unit);
    if (result.onlyUpperBound)
        return u"$%1 \\le %2%3$"_s.arg(result.latex, number.upper, unit);
    if (isAskew(result)) {
        // From the rounded ones, so that who adds them comes to the bounds that are shown elsewhere.
        const double value = number.value.toDouble();
        const qsizetype point = number.half.indexOf(u'.');
        const int places = point < 0 ? 0 : int(number.half.size() - point - 1);
        const QString above = QString::number(number.upper.toDouble() - value, 'f', places);
        const QString below = QString::number(value - number.lower.toDouble(), 'f', places);
        return u"$%1 = %2^{+%3}_{-%4}%5$"_s.arg(result.latex, number.value, above, below, unit);
    }
    const QString range = u"%1 \\pm %2"_s.arg(number.value, number.half);
    return unit.isEmpty() ? u"$%1 = %2$"_s.arg(result.latex, range)
                          : u"$%1 = (%2)%3$"_s.arg(result.latex, range, unit);
}

QString validityText(const Identification& identification)
{
    switch (identification.validity.verdict) {
    case ValidityVerdict::Valid:
        return ResultWords::tr("The measurement is valid.");
    case ValidityVerdict::Suspect:
        return ResultWords::tr("The measurement is suspect.");
    case ValidityVerdict::Invalid:
        break;
    }
    return ResultWords::tr("The measurement is not valid.");
}

} // namespace

std::vector<ReportedResult> reportedResults(const Identification& identification, const QString& forceUnit,
                                            const QString& positionUnit)
{
    std::vector<ReportedResult> results;
    for (const DeterminedParameter& one : determinedParameters(identification, forceUnit, positionUnit)) {
        const auto& [name, symbol, latex] = parameterNames[static_cast<std::size_t>(one.parameter)];
        ReportedResult result{QString::fromUtf16(name),
                              QString::fromUtf16(symbol),
                              QString::fromUtf16(latex),
                              one.value,
                              one.value,
                              one.value,
                              false,
                              one.isLowerBound,
                              one.unit};
        if (one.interval) {
            result.lower = one.interval->lower;
            result.upper = one.interval->upper;
            result.onlyUpperBound = one.interval->onlyUpperBound;
        }
        results.push_back(std::move(result));
    }
    if (const UncertaintyBudget* budget = shownBudget(identification))
        addDerived(results, *budget);
    return results;
}

QString resultsAsText(const Identification& identification, const QString& title, const QString& forceUnit,
                      const QString& positionUnit)
{
    QStringList lines;
    const std::vector<ReportedResult> results = reportedResults(identification, forceUnit, positionUnit);
    if (!results.empty())
        lines << ResultWords::tr("%1, %2, 95 % intervals")
                     .arg(title, estimatorName(identification.recommended));
    for (const ReportedResult& result : results)
        lines << reportedText(result);
    lines << validityText(identification);
    return lines.join(u'\n') + u'\n';
}

QString resultsAsLatex(const Identification& identification, const QString& title, const QString& forceUnit,
                       const QString& positionUnit)
{
    QStringList lines;
    const std::vector<ReportedResult> results = reportedResults(identification, forceUnit, positionUnit);
    if (!results.empty())
        // A line end within the title would end the comment.
        lines << u"% %1, estimator %2, 95 % intervals, measurement %3"_s.arg(
            factText(title), toString(identification.recommended), toString(identification.validity.verdict));
    for (const ReportedResult& result : results)
        lines << latexOf(result) + u" % "_s + result.name;
    return lines.join(u'\n') + u'\n';
}

QString resultsAsCsv(const Identification& identification, const QString& forceUnit,
                     const QString& positionUnit)
{
    QString text = u"quantity,value,half_width_95,lower_95,upper_95,unit,validity\n"_s;
    const QString validity = toString(identification.validity.verdict);
    for (const ReportedResult& result : reportedResults(identification, forceUnit, positionUnit)) {
        const bool interval = hasInterval(result);
        const bool bound = result.onlyLowerBound;
        QStringList cells{result.symbol, bound ? QString() : exactText(result.value)};
        cells << (interval ? exactText((result.upper - result.lower) / 2) : QString())
              << (interval || bound ? exactText(result.lower) : QString())
              << (interval ? exactText(result.upper) : QString()) << result.unit << validity;
        for (QString& cell : cells)
            cell = csvCell(cell);
        text += cells.join(u',') + u'\n';
    }
    return text;
}

} // namespace gripscope
