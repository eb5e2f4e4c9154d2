// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/excitation/force_levels.h"

#include "core/base/bounded_file.h"
#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// How many rows each level has at least, if each has a whole multiple of that: the last may be cut short.
std::size_t rowsPerLevel(const std::vector<double>& force)
{
    std::size_t rows = 0;
    for (std::size_t i = 1; i < force.size(); ++i)
        if (force[i] != force[i - 1])
            rows = std::gcd(rows, i);
    return std::max<std::size_t>(rows, 1);
}

/// The first row that is not a step behind the one before.
std::optional<std::size_t> irregularRow(const std::vector<double>& time_s, double step_s)
{
    constexpr double tolerance = 0.01;
    for (std::size_t i = 1; i < time_s.size(); ++i)
        if (std::abs(time_s[i] - time_s[i - 1] - step_s) > tolerance * step_s)
            return i;
    return std::nullopt;
}

} // namespace

Expected<ForceLevels> levelsOf(const std::vector<double>& force, double step_s, const QString& unit,
                               const QString& name)
{
    const auto bad = [&](const Finding& found, const Finding& expected) {
        return failure(ErrorCode::BadInput, {name, found, expected});
    };
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (force.empty() || !std::ranges::all_of(force, isFinite))
        return bad(Words::say("found a force that is no number, or none"),
                   Words::say("expected a number a step"));
    if (!isSampleTime(step_s))
        return bad(Words::say("found steps of %1 s").arg(step_s),
                   Words::say("expected %1").arg(sampleTimeExpectation()));
    const auto [least, most] = std::ranges::minmax(force);
    ForceLevels result;
    result.bias = least + (most - least) / 2;
    result.peak = (most - least) / 2;
    result.unit = unit;
    if (!(result.peak > 0) || !std::isfinite(result.bias))
        return bad(Words::say("found the same force throughout"), Words::say("expected one that varies"));
    const std::size_t rows = rowsPerLevel(force);
    result.bit_s = static_cast<double>(rows) * step_s;
    for (std::size_t i = 0; i < force.size(); i += rows)
        result.levels.push_back(std::clamp((force[i] - result.bias) / result.peak, -1.0, 1.0));
    if (result.levels.size() > mostLevels)
        return bad(Words::say("found %1 levels of force").arg(result.levels.size()),
                   Words::say("expected at most %1: cut it, or take longer steps").arg(mostLevels));
    return result;
}

Expected<ForceLevels> parseForceLevels(const QByteArray& text, const QString& name,
                                       std::optional<double> step_s)
{
    CsvReadOptions options;
    options.positionColumn = u"force"_s; // nothing is asked of a position
    Expected<Recording> table = parseRecordingCsv(text, name, options);
    if (!table && step_s) {
        options.sampleTime_s = step_s;
        table = parseRecordingCsv(text, name, options);
    }
    if (!table)
        return tl::make_unexpected(std::move(table).error());
    const std::vector<double>& time_s = table->time_s;
    if (const auto row = irregularRow(time_s, table->sampleTime_s))
        return failure(ErrorCode::BadInput,
                       {name,
                        Words::say("found row %1 of the table %2 s after the one before")
                            .arg(*row + 1)
                            .arg(time_s[*row] - time_s[*row - 1]),
                        Words::say("expected equal steps, of %1 s").arg(table->sampleTime_s)});
    const QString unit = table->forceUnit == u"1"_s ? QString() : table->forceUnit;
    return levelsOf(table->force, table->sampleTime_s, unit, name);
}

Expected<ForceLevels> readForceLevels(const QString& file, std::optional<double> step_s)
{
    ASSIGN_OR_RETURN(const QByteArray text, readBounded(file, largestRecordingFile));
    return parseForceLevels(text, file, step_s);
}

Expected<ForceLevels> inNewtons(ForceLevels force, const QString& name)
{
    if (force.unit.isEmpty())
        return force;
    const std::optional<double> newtons = newtonsPer(force.unit);
    if (!newtons)
        return failure(ErrorCode::BadInput,
                       {name, Words::say("found forces in %1").arg(force.unit),
                        Words::say("expected one of %1").arg(forceUnits().join(u", "_s))});
    force.bias *= *newtons;
    force.peak *= *newtons;
    force.unit = u"N"_s;
    return force;
}

QByteArray toCsv(const ForceLevels& levels)
{
    QStringList lines{u"# sample_time_s: "_s + exactText(levels.bit_s)};
    if (!levels.unit.isEmpty())
        lines << u"# force_unit: "_s + factText(levels.unit);
    lines << u"force"_s;
    for (const double level : levels.levels)
        lines << exactText(levels.bias + levels.peak * level);
    return (lines.join(u'\n') + u'\n').toUtf8();
}

} // namespace gripscope
