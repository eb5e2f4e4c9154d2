// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/comparable_units.h"

#include "core/base/words.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/recognition/verdict/verdict_by_space.h"
#include "core/signal/recording/units.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString inWords(const QString& forceUnit, const QString& positionUnit)
{
    return Words::tr("%1 and %2").arg(forceUnit, positionUnit);
}

/// Units of the same system can be converted into each other.
QString systemOf(const QString& forceUnit, const QString& positionUnit)
{
    return siFactor(forceUnit, positionUnit) ? u"SI"_qs : forceUnit + u' ' + positionUnit;
}

double factorToSystem(const QString& forceUnit, const QString& positionUnit)
{
    return siFactor(forceUnit, positionUnit).value_or(1.0);
}

} // namespace

Expected<double> parameterFactor(const QString& fromForce, const QString& fromPosition,
                                 const QString& toForce, const QString& toPosition)
{
    if (fromForce == toForce && fromPosition == toPosition)
        return 1.0;
    if (systemOf(fromForce, fromPosition) != systemOf(toForce, toPosition))
        return failure(ErrorCode::UnitsDiffer,
                       {inWords(fromForce, fromPosition), inWords(toForce, toPosition)});
    return factorToSystem(fromForce, fromPosition) / factorToSystem(toForce, toPosition);
}

ComparableTypes::ComparableTypes(const std::vector<TypeRecord>& types,
                                 const std::vector<TypeSqueeze>& squeezes)
{
    QMap<QString, std::vector<TypeSqueeze>> bySystem;
    for (const TypeSqueeze& squeeze : squeezes) {
        const auto type = std::find_if(types.begin(), types.end(),
                                       [&](const TypeRecord& record) { return record.name == squeeze.type; });
        if (type == types.end())
            continue;
        const QString system = systemOf(type->forceUnit, type->positionUnit);
        bySystem[system].push_back(squeeze);
        m_unitsOf[system] = inWords(type->forceUnit, type->positionUnit);
    }
    for (auto it = bySystem.cbegin(); it != bySystem.cend(); ++it)
        m_models[it.key()] = std::make_shared<const ModelsBySpace>(it.value());
    if (m_models.contains(u"SI"_qs))
        m_main = m_models[u"SI"_qs];
    else if (!m_models.isEmpty())
        m_main = m_models.first();
}

Expected<ComparableTypes::Choice> ComparableTypes::modelsFor(const QString& forceUnit,
                                                             const QString& positionUnit) const
{
    const QString system = systemOf(forceUnit, positionUnit);
    if (m_models.isEmpty())
        return Choice{m_main, factorToSystem(forceUnit, positionUnit)};
    const auto found = m_models.constFind(system);
    if (found == m_models.cend())
        return failure(ErrorCode::UnitsDiffer, {inWords(forceUnit, positionUnit), m_unitsOf.first()});
    return Choice{*found, factorToSystem(forceUnit, positionUnit)};
}

Verdict judgeRecording(const ModelsBySpace& types, const Identification& identification,
                       const Recording& recording, const VerdictOptions& rates,
                       const std::optional<CommonShift>& transfer)
{
    const std::optional<TypeSqueeze> found =
        identifiedSqueeze({}, identification, recording.forceUnit, recording.positionUnit);
    return judge(types, identification, found, rates, transfer);
}

} // namespace gripscope
