// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/estimators/estimator_table.h"

#include "core/identification/arx/arx.h"
#include "core/identification/instrumental/instrumental_variables.h"
#include "core/identification/motion/motion.h"

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

Estimate runMotion(Estimator estimator, const PreparedRecord& record, const EstimatorTask& task, Repetition*)
{
    return estimateMotion(record.force, record.position, motionOptions(estimator, record, task));
}

constexpr double up = -std::numbers::pi / 2;

constexpr std::array<EstimatorFacts, 16> table{
    {{Estimator::Arx,
      "arx",
      QT_TRANSLATE_NOOP("Words", "ARX(2,1,1)"),
      "ARX(2,1,1), the paper's",
      false,
      true,
      true,
      {3, 1.15, up},
      runArx},
     {Estimator::ArxMeanForce,
      "arx-mean-force",
      QT_TRANSLATE_NOOP("Words", "ARX, mean force"),
      "ARX(2,1,1) on the mean of successive forces",
      false,
      true,
      true,
      {4, 1.15, std::numbers::pi / 4},
      runArx},
     {Estimator::Arx221,
      "arx221",
      QT_TRANSLATE_NOOP("Words", "ARX(2,2,1)"),
      "ARX(2,2,1), mapped by its poles",
      false,
      true,
      true,
      {4, 1.15, 0},
      runArx},
     {Estimator::InstrumentalVariables,
      "iv",
      QT_TRANSLATE_NOOP("Words", "instrumental var."),
      "instrumental variables",
      true,
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
      true,
      {},
      runOutputError},
     {Estimator::Duffing,
      "duffing",
      QT_TRANSLATE_NOOP("Words", "cubic spring"),
      "output error with a cubic spring",
      true,
      false,
      true,
      {5, 1.1, up},
      runMotion},
     {Estimator::Periodic,
      "periodic",
      QT_TRANSLATE_NOOP("Words", "periodic"),
      "frequency domain, periodic",
      false,
      false,
      true,
      {6, 1.1, 0},
      runPeriodic},
     {Estimator::Friction,
      "friction",
      QT_TRANSLATE_NOOP("Words", "friction"),
      "output error with Coulomb friction",
      true,
      false,
      true,
      {8, 1.1, 0},
      runMotion},
     {Estimator::Zener,
      "zener",
      QT_TRANSLATE_NOOP("Words", "viscoelastic"),
      "output error with a viscoelastic part (standard linear solid)",
      true,
      false,
      true,
      {7, 1.1, up},
      runMotion},
     {Estimator::FrictionZener,
      "friction+zener",
      QT_TRANSLATE_NOOP("Words", "friction, viscoelastic"),
      "output error with friction and a viscoelastic part",
      true,
      false,
      false,
      {8, 1.1, up / 4},
      runMotion},
     {Estimator::FrictionDuffing,
      "friction+duffing",
      QT_TRANSLATE_NOOP("Words", "friction, cubic spring"),
      "output error with friction and a cubic spring",
      true,
      false,
      false,
      {5, 1.1, -up},
      runMotion},
     {Estimator::ZenerDuffing,
      "zener+duffing",
      QT_TRANSLATE_NOOP("Words", "viscoelastic, cubic spring"),
      "output error with a viscoelastic part and a cubic spring",
      true,
      false,
      false,
      {7, 1.1, -up},
      runMotion},
     {Estimator::Static,
      "static",
      QT_TRANSLATE_NOOP("Words", "without mass"),
      "damper and spring, the mass left out",
      true,
      false,
      false,
      {6, 1.1, up},
      runMotion},
     {Estimator::StaticZener,
      "static+zener",
      QT_TRANSLATE_NOOP("Words", "viscoelastic without mass"),
      "viscoelastic part, the mass left out",
      true,
      false,
      false,
      {6, 0.9, up},
      runMotion},
     {Estimator::StaticDuffing,
      "static+duffing",
      QT_TRANSLATE_NOOP("Words", "cubic spring without mass"),
      "damper and cubic spring, the mass left out",
      true,
      false,
      false,
      {6, 0.9, 0},
      runMotion},
     {Estimator::Carriage,
      "carriage",
      QT_TRANSLATE_NOOP("Words", "no spring"),
      "mass, damper and friction, nothing gripped",
      true,
      false,
      false,
      {4, 0.9, 0},
      runMotion}}};

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

std::vector<Estimator> estimatorsOnPages()
{
    std::vector<Estimator> some;
    for (const EstimatorFacts& facts : table)
        if (facts.onPages)
            some.push_back(facts.estimator);
    return some;
}

std::vector<Estimator> estimatorsOfTypes()
{
    std::vector<Estimator> some = estimatorsOnPages();
    std::erase_if(some, [](Estimator estimator) {
        const std::optional<MotionTerms> terms = motionTermsOf(estimator);
        return terms && (!terms->mass || !terms->spring);
    });
    return some;
}

std::optional<MotionTerms> motionTermsOf(Estimator estimator)
{
    switch (estimator) {
    case Estimator::Duffing:
        return MotionTerms{.cubic = true};
    case Estimator::Friction:
        return MotionTerms{.friction = true};
    case Estimator::Zener:
        return MotionTerms{.relaxation = true};
    case Estimator::FrictionZener:
        return MotionTerms{.friction = true, .relaxation = true};
    case Estimator::FrictionDuffing:
        return MotionTerms{.friction = true, .cubic = true};
    case Estimator::ZenerDuffing:
        return MotionTerms{.relaxation = true, .cubic = true};
    case Estimator::Static:
        return damperAndSpring;
    case Estimator::StaticZener:
        return MotionTerms{.mass = false, .relaxation = true};
    case Estimator::StaticDuffing:
        return MotionTerms{.mass = false, .cubic = true};
    case Estimator::Carriage:
        return MotionTerms{.spring = false, .friction = true, .forceOffset = true};
    default:
        return std::nullopt;
    }
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
    // The terms of a sum in any order.
    const auto sorted = [](const QString& id) {
        QStringList terms = id.split(u'+');
        terms.sort();
        return terms;
    };
    const QStringList asked = sorted(text);
    for (const EstimatorFacts& facts : table)
        if (asked == sorted(QString::fromLatin1(facts.id)))
            return facts.estimator;
    return std::nullopt;
}

} // namespace gripscope
