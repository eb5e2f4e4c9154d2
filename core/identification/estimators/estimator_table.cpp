// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/estimators/estimator_table.h"

#include "core/identification/arx/arx.h"
#include "core/identification/duffing/duffing.h"
#include "core/identification/instrumental/instrumental_variables.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

using Repetition = std::optional<PeriodicDiagnostics>;

Estimate runArx(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task, Repetition*)
{
    return estimateArx(record.force, record.position,
                       {estimator, record.sampleTime_s, record.forceLag_s, task.freeOffset});
}

Estimate runInstrumentalVariables(Estimator, const PreparedRecord& record, const EstimatorTask& task,
                                  Repetition*)
{
    auto options = continuousOptions<InstrumentalVariablesOptions>(record, task);
    options.lost = record.lost;
    return estimateInstrumentalVariables(record.force, record.position, options);
}

Estimate runOutputError(Estimator, const PreparedRecord& record, const EstimatorTask& task, Repetition*)
{
    return estimateOutputError(record.force, record.position, outputErrorOptions(record, task));
}

Estimate runDuffing(Estimator, const PreparedRecord& record, const EstimatorTask& task, Repetition*)
{
    auto options = continuousOptions<DuffingOptions>(record, task);
    options.lost = record.lost;
    return estimateDuffing(record.force, record.position, options);
}

Estimate runPeriodic(Estimator, const PreparedRecord& record, const EstimatorTask& task,
                     Repetition* repetition)
{
    PeriodicOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = task.hold;
    options.lag_s = record.forceLag_s;
    options.period = task.period;
    PeriodicResult result = analysePeriodic(record.force, record.position, options);
    if (repetition != nullptr)
        *repetition = std::move(result.diagnostics);
    return result.estimate;
}

constexpr double up = -std::numbers::pi / 2;

constexpr std::array<EstimatorFacts, 7> table{{{Estimator::Arx,
                                                "arx",
                                                QT_TRANSLATE_NOOP("Words", "ARX(2,1,1)"),
                                                "ARX(2,1,1), the paper's",
                                                false,
                                                true,
                                                {3, 1.15, up},
                                                runArx},
                                               {Estimator::ArxMeanForce,
                                                "arx-mean-force",
                                                QT_TRANSLATE_NOOP("Words", "ARX, mean force"),
                                                "ARX(2,1,1) on the mean of successive forces",
                                                false,
                                                true,
                                                {4, 1.15, std::numbers::pi / 4},
                                                runArx},
                                               {Estimator::Arx221,
                                                "arx221",
                                                QT_TRANSLATE_NOOP("Words", "ARX(2,2,1)"),
                                                "ARX(2,2,1), mapped by its poles",
                                                false,
                                                true,
                                                {4, 1.15, 0},
                                                runArx},
                                               {Estimator::InstrumentalVariables,
                                                "iv",
                                                QT_TRANSLATE_NOOP("Words", "instrumental var."),
                                                "instrumental variables",
                                                true,
                                                true,
                                                {3, 1.15, -up},
                                                runInstrumentalVariables},
                                               {Estimator::OutputError,
                                                "oe",
                                                QT_TRANSLATE_NOOP("Words", "output error"),
                                                "output error",
                                                true,
                                                true,
                                                {},
                                                runOutputError},
                                               {Estimator::Duffing,
                                                "duffing",
                                                QT_TRANSLATE_NOOP("Words", "cubic spring"),
                                                "output error with a cubic spring",
                                                true,
                                                false,
                                                {5, 1.1, up},
                                                runDuffing},
                                               {Estimator::Periodic,
                                                "periodic",
                                                QT_TRANSLATE_NOOP("Words", "periodic"),
                                                "frequency domain, periodic",
                                                false,
                                                false,
                                                {6, 1.1, 0},
                                                runPeriodic}}};

constexpr bool inOrder()
{
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].estimator) != i)
            return false;
    return true;
}
static_assert(inOrder(), "a line for each enumerator, in their order");

} // namespace

std::span<const EstimatorFacts> estimatorTable()
{
    return table;
}

std::vector<Estimator> allEstimators()
{
    std::vector<Estimator> all;
    all.reserve(table.size());
    for (const EstimatorFacts& facts : table)
        all.push_back(facts.estimator);
    return all;
}

const EstimatorFacts& factsOf(Estimator estimator)
{
    return table[std::min(static_cast<std::size_t>(estimator), table.size() - 1)];
}

QString toString(Estimator estimator)
{
    return QString::fromLatin1(factsOf(estimator).id);
}

std::optional<Estimator> estimatorFromString(const QString& text)
{
    for (const EstimatorFacts& facts : table)
        if (text == QLatin1String(facts.id))
            return facts.estimator;
    return std::nullopt;
}

} // namespace gripscope
