// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/recordings/identification_csv.h"

#include "core/base/csv.h"
#include "core/identification/result/determined_parameters.h"
#include "core/signal/recording/units.h"

#include <QStringList>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

const QStringList& csvColumns()
{
    static const QStringList columns{
        u"file"_qs,     u"estimator"_qs, u"status"_qs, u"recommended"_qs, u"m"_qs,
        u"m_95"_qs,     u"m_unit"_qs,    u"b"_qs,      u"b_95"_qs,        u"b_unit"_qs,
        u"k"_qs,        u"k_95"_qs,      u"k_unit"_qs, u"intervals"_qs,   u"simulation_percent"_qs,
        u"validity"_qs, u"error"_qs};
    return columns;
}

QString csvRow(QStringList cells)
{
    for (QString& cell : cells)
        cell = csvCell(cell);
    return cells.join(u',');
}

/// m, b and k with half their intervals, and what these count.
struct CsvNumbers {
    std::optional<double> values[3], halves[3];
    QString intervals;
};

CsvNumbers csvNumbers(const Identification& identification, const Estimate& estimate)
{
    CsvNumbers numbers;
    const UncertaintyBudget& budget = identification.budget;
    const bool whole =
        isRecommended(identification, estimate) && (budget.parameters || !budget.further.empty());
    const QString asMeasured = u"1"_qs;
    for (const DeterminedParameter& one : whole ? determinedParameters(identification, asMeasured, asMeasured)
                                                : determinedParameters(estimate, asMeasured, asMeasured)) {
        const std::optional<std::size_t> at = linearPlaceOf(one.parameter);
        if (!at || one.isLowerBound)
            continue;
        numbers.values[*at] = one.value;
        if (!one.interval)
            continue;
        numbers.halves[*at] = (one.interval->upper - one.interval->lower) / 2;
        numbers.intervals = whole ? u"budget"_qs : u"noise"_qs;
    }
    return numbers;
}

} // namespace

QString identificationCsvHeader()
{
    return csvColumns().join(u',');
}

QString identificationCsv(const Identification& identification, const Recording& recording,
                          const QString& file)
{
    const ParameterUnits units = parameterUnits(recording.forceUnit, recording.positionUnit);
    const QString unit[] = {units.m, units.b, units.k};
    QStringList rows;
    for (const Estimate& estimate : identification.estimates) {
        const CsvNumbers numbers = csvNumbers(identification, estimate);
        QStringList cells{file, toString(estimate.estimator), toString(estimate.status),
                          isRecommended(identification, estimate) ? u"yes"_qs : u"no"_qs};
        for (std::size_t i = 0; i < 3; ++i)
            cells << exactText(numbers.values[i]) << exactText(numbers.halves[i]) << unit[i];
        cells << numbers.intervals << exactText(estimate.fit.simulationPercent)
              << toString(identification.validity.verdict) << QString();
        rows << csvRow(cells);
    }
    return rows.join(u'\n');
}

QString identificationCsv(const QString& file, const Error& error)
{
    QStringList cells(csvColumns().size(), QString());
    cells.front() = file;
    cells.back() = error.describe();
    return csvRow(cells);
}

} // namespace gripscope::cli
