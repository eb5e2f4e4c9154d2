// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "core/calibration/calibration_figures.h"
#include "core/clustering/feature_table.h"

#include <QLocale>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Readings from the curve's one end to its other, where none are asked for.
std::vector<double> evenReadings(const CalibrationCurve& curve)
{
    const double first = curve.readingAt(curve.leastLoad()), last = curve.readingAt(curve.largestLoad());
    constexpr int steps = 10;
    std::vector<double> readings(steps + 1);
    for (int i = 0; i <= steps; ++i)
        readings[static_cast<std::size_t>(i)] = first + (last - first) * i / steps;
    return readings;
}

std::vector<double> askedReadings(CommandLine& line)
{
    std::vector<double> readings;
    for (const QString& text : line.list(u"readings"_qs)) {
        bool ok = false;
        readings.push_back(QLocale::c().toDouble(text, &ok));
        if (!ok)
            line.reject(u"--readings holds \"%1\"; numbers separated by commas were expected."_qs.arg(text));
    }
    return readings;
}

QString percent(const std::optional<double>& value)
{
    return value ? QString::number(*value, 'g', 3) + u" %"_qs : u"not told by these points"_qs;
}

QString text(const CalibrationCurve& curve, const std::vector<CalibrationPoint>& points,
             const std::vector<double>& readings)
{
    QStringList lines{
        u"reading = sum of c[i] load^i, from load %1 to %2; residual deviation %3 (%4 degrees of freedom)"_qs
            .arg(curve.leastLoad())
            .arg(curve.largestLoad())
            .arg(curve.residualDeviation(), 0, 'g', 6)
            .arg(curve.degreesOfFreedom())};
    const Eigen::VectorXd coefficients = curve.coefficients(), deviations = curve.standardDeviations();
    for (Eigen::Index i = 0; i < coefficients.size(); ++i)
        lines << u"  c[%1] = %2 +- %3"_qs.arg(QString::number(i), QString::number(coefficients(i), 'g', 12),
                                              QString::number(deviations(i), 'g', 3));
    const CalibrationFigures figures = calibrationFigures(curve, points);
    lines << u"of full scale: linearity %1, repeatability %2, reversibility %3, zero return %4"_qs.arg(
        percent(figures.linearityPercent), percent(figures.repeatabilityPercent),
        percent(figures.reversibilityPercent), percent(figures.zeroReturnPercent));
    if (figures.lackOfFitProbability && *figures.lackOfFitProbability < 0.01)
        lines << u"the points lie off the curve by more than they scatter (p = %1): try --degree %2"_qs
                     .arg(*figures.lackOfFitProbability, 0, 'g', 2)
                     .arg(curve.degree() + 1);
    lines << u"reading        load           standard uncertainty"_qs;
    for (const double reading : readings) {
        const std::optional<LoadEstimate> found = curve.loadAt(reading);
        lines << QString::number(reading, 'g', 8).leftJustified(15) +
                     (found ? QString::number(found->load, 'g', 8).leftJustified(15) +
                                  QString::number(found->standardUncertainty, 'g', 3)
                            : u"outside the range"_qs);
    }
    return lines.join(u'\n');
}

} // namespace

int runCalibrate(const QStringList& arguments)
{
    CommandLine line(
        u"calibrate"_qs,
        u"Fits reading(load) to calibration points, and inverts it: from columns load, reading."_qs,
        u"POINTS.csv"_qs);
    line.option(u"degree"_qs, u"N"_qs, u"Of the polynomial."_qs, u"2"_qs);
    line.option(u"readings"_qs, u"LIST"_qs,
                u"Readings to turn into loads; without it, 11 over the range."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const int degree = line.integer(u"degree"_qs, 1, highestCalibrationDegree);
    std::vector<double> readings = askedReadings(line);
    if (line.files().size() != 1)
        line.reject(u"one table at a time, please."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;

    const bool json = line.isSet(u"json"_qs);
    const Expected<FeatureTable> table = readFeatureTable(line.files().first(), {u"load"_qs, u"reading"_qs});
    if (!table)
        return fail(table.error(), json);
    std::vector<CalibrationPoint> points(static_cast<std::size_t>(table->values.rows()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = table->values.row(static_cast<Eigen::Index>(i));
        points[i] = {row(0), row(1)};
    }
    const Expected<CalibrationCurve> curve = CalibrationCurve::fit(points, degree);
    if (!curve) {
        Error error = curve.error();
        error.arguments[0] = line.files().first();
        return fail(error, json);
    }
    if (readings.empty())
        readings = evenReadings(*curve);
    if (json)
        printJson(calibrationJson(*curve, points, readings));
    else
        print(text(*curve, points, readings));
    return 0;
}

} // namespace gripscope::cli
