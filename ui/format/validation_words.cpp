// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/validation_words.h"

#include "core/math/normal_interval.h"
#include "ui/format/channel_scale.h"
#include "ui/format/number_format.h"
#include "ui/format/residual_words.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct ValidationWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::ValidationWords)
};

QString percentText(const std::optional<double>& percent)
{
    return percent ? formatPercent(*percent) : QString(QChar(0x2013));
}

QString samplesText(const Validation& validation)
{
    const QString count = formatCount(qint64(validation.validatedOn.count));
    if (validation.source == ValidationSource::OtherRecording)
        return ValidationWords::tr("%1, %2 samples").arg(validation.name, count);
    return ValidationWords::tr("the last %1 samples, found from the first %2")
        .arg(count, formatCount(qint64(validation.estimatedOn.count)));
}

QString testText(const std::optional<double>& p, const QString& good, const QString& bad)
{
    return u"%1, %2"_s.arg(*p < validationLimit ? bad : good, pValueText(*p));
}

/// "+1.2 ± 3.4 %": by how much, with the 95 % half-width to be expected.
QString changeText(double change, double error)
{
    QString number = formatNumber(100 * change, 100 * error * normal95, {}).number();
    if (change > 0)
        number.prepend(u'+');
    return number + u" %"_s;
}

/// In a unit that reads well, "5.2 µm".
QString inUnit(double value, const QString& unit)
{
    const ChannelScale shown = channelScale(unit, std::abs(value));
    return formatNumber(value * shown.factor, std::nullopt, shown.unit, 2).valueWithUnit();
}

/// The correlation of unrelated noises scatters by some tenths over few lines.
constexpr double noticeableCorrelation = 0.3;
constexpr double rarely = 0.01;

} // namespace

std::vector<Fact> validationFacts(const Validation& validation)
{
    if (!validation.available())
        return {};
    std::vector<Fact> facts{{ValidationWords::tr("Held against"), samplesText(validation), false}};
    QString simulation = percentText(validation.fit.simulationPercent);
    if (validation.expectedPercent)
        simulation =
            ValidationWords::tr("%1, expected %2").arg(simulation, percentText(validation.expectedPercent));
    facts.push_back({ValidationWords::tr("Simulation fit"), simulation});
    facts.push_back({ValidationWords::tr("Prediction fit"), percentText(validation.fit.predictionPercent)});
    if (validation.whitenessP)
        facts.push_back(
            {ValidationWords::tr("Residuals"), testText(validation.whitenessP, ValidationWords::tr("white"),
                                                        ValidationWords::tr("not white"))});
    if (validation.inputIndependenceP)
        facts.push_back({ValidationWords::tr("Against force"),
                         testText(validation.inputIndependenceP, ValidationWords::tr("independent"),
                                  ValidationWords::tr("dependent"))});
    if (validation.misfitP)
        facts.push_back(
            {ValidationWords::tr("m, b and k"),
             testText(validation.misfitP, ValidationWords::tr("hold"), ValidationWords::tr("do not hold"))});
    static constexpr std::array names{QT_TRANSLATE_NOOP("gripscope::ValidationWords", "Change of m"),
                                      QT_TRANSLATE_NOOP("gripscope::ValidationWords", "Change of b"),
                                      QT_TRANSLATE_NOOP("gripscope::ValidationWords", "Change of k")};
    for (Eigen::Index i = 0; validation.change && i < 3; ++i)
        facts.push_back({ValidationWords::tr(names[std::size_t(i)]),
                         changeText((*validation.change)(i), (*validation.changeErrors)(i))});
    return facts;
}

QString periodSentence(const PeriodicDiagnostics& periods)
{
    QStringList parts;
    parts << (periods.noiseCorrelation > noticeableCorrelation
                  ? ValidationWords::tr(
                        "the force answers to disturbances of the position, which periodic allows for and "
                        "output error does not")
                  : ValidationWords::tr("the force does not answer to the position"));
    if (periods.distortionP)
        parts
            << (*periods.distortionP < rarely
                    ? ValidationWords::tr(
                          "harmonics that the force does not have show a spring or damper that is not linear")
                    : ValidationWords::tr("no harmonic shows more than a linear object"));
    if (periods.costP < rarely)
        parts << ValidationWords::tr(
            "the misfit is larger than what changes from period to period explains, and the errors "
            "were enlarged to match");
    return asSentence(parts.join(u"; "_s));
}

std::vector<Fact> periodFacts(const PeriodicDiagnostics& periods, const QString& forceUnit,
                              const QString& positionUnit)
{
    std::vector<Fact> facts{
        {ValidationWords::tr("Periods"),
         ValidationWords::tr("%1 of %2 samples")
             .arg(formatCount(qint64(periods.periods)), formatCount(qint64(periods.periodSamples)))},
        {ValidationWords::tr("Force noise"), inUnit(periods.forceNoise, forceUnit)},
        {ValidationWords::tr("Position noise"), inUnit(periods.positionNoise, positionUnit)},
        {ValidationWords::tr("Their correlation"),
         formatNumber(periods.noiseCorrelation, std::nullopt, {}, 2).value},
        {ValidationWords::tr("Drift of force"), inUnit(periods.forceDrift, forceUnit)},
        {ValidationWords::tr("Drift of position"), inUnit(periods.positionDrift, positionUnit)},
        {ValidationWords::tr("Misfit over noise"),
         ValidationWords::tr("%1, %2").arg(formatNumber(periods.costRatio, std::nullopt, {}, 3).value,
                                           pValueText(periods.costP))}};
    if (periods.distortionPercent && periods.distortionP)
        facts.push_back({ValidationWords::tr("Distortion"),
                         ValidationWords::tr("%1, %2").arg(formatPercent(*periods.distortionPercent, 2),
                                                           pValueText(*periods.distortionP))});
    else
        facts.push_back({ValidationWords::tr("Distortion"),
                         ValidationWords::tr("not told: the force leaves no harmonic empty"), false});
    return facts;
}

} // namespace gripscope
