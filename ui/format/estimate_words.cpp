// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/estimate_words.h"

#include "core/base/words.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/result/determined_parameters.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString estimateWord(const char* text)
{
    return QCoreApplication::translate("gripscope::EstimateWords", text);
}

QString statusWords(EstimateStatus status)
{
    switch (status) {
    case EstimateStatus::Converged:
        return {};
    case EstimateStatus::NotConverged:
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "did not converge"));
    case EstimateStatus::NotIdentifiable:
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "not identifiable"));
    case EstimateStatus::NoPhysicalMapping:
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "no physical m, b, k"));
    case EstimateStatus::TooFewSamples:
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "too few samples"));
    case EstimateStatus::NotApplicable:
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "not applicable"));
    }
    return {};
}

} // namespace

QString deviationText(double share)
{
    const QString sign = share < 0 ? QString(QChar(0x2212)) : u"+"_s;
    const double percent = std::abs(share) * 100;
    return percent > 999 ? sign + u">999 %"_s : sign + u"%L1 %"_s.arg(percent, 0, 'f', percent < 1 ? 1 : 0);
}

QString estimateVerdict(const Identification& identification, const Estimate& estimate)
{
    const QString status = statusWords(estimate.status);
    if (!status.isEmpty())
        return status;
    const Estimate* best = identification.best();
    if (isRecommended(identification, estimate))
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "recommended"));
    if (!best || !best->parameters || !estimate.parameters)
        return estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "no comparison"));
    const Eigen::Vector3d mine = estimate.parameters->vector();
    const Eigen::Vector3d other = best->parameters->vector();
    const Eigen::Vector3d error = best->standardErrors().value_or(Eigen::Vector3d::Zero());
    QStringList off;
    for (int i = 0; i < 3; ++i) {
        // What three standard errors of the recommended estimate, or 2 %, cannot tell apart is called the
        // same.
        const double difference = mine[i] - other[i];
        if (std::abs(difference) > std::max(3 * error[i], 0.02 * std::abs(other[i])))
            off << u"%1 %2"_s.arg(QString(u"mbk"_s[i]), deviationText(difference / other[i]));
    }
    return off.isEmpty() ? estimateWord(QT_TRANSLATE_NOOP("gripscope::EstimateWords", "agrees"))
                         : off.join(u", "_s);
}

QString checkName(const QString& id)
{
    static const QHash<QString, const char*> names{
        {u"samples_lost"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Lost samples")},
        {u"saturation"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Saturation")},
        {u"stuck"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Stuck channel")},
        {u"device_fault"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Gripper's own fault")},
        {u"clock"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Gripper's clock")},
        {u"sample_time"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Sample time")},
        {u"excitation"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Excitation")},
        {u"residual_whiteness"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "White residuals")},
        {u"input_independence"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Residuals and force")},
        {u"hold"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Force between samples")},
        {u"convergence"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Convergence")},
        {u"physical_range"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Physical range")},
        {u"fit"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Fit")},
        {u"calibration"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Calibration")},
        {u"linearity"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Straight spring")},
        {u"feedback"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Force feedback")},
        {u"relaxation"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Yielding")},
        {u"preparation"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Recording as such")},
        {u"position_held"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Position renewed slowly")},
    };
    const char* name = names.value(id, nullptr);
    return name ? estimateWord(name) : id;
}

QString preparationName(const QString& id)
{
    static const QHash<QString, const char*> names{
        {u"unusable"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Not usable")},
        {u"contact"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Contact")},
        {u"clock_drift"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Clock drift")},
        {u"clock_jitter"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Clock jitter")},
        {u"clock_break"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Clock jumps")},
        {u"samples_lost"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Lost samples")},
        {u"window_cut"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Window")},
        {u"contact_loss"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Contact lost")},
        {u"saturation"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Saturation")},
        {u"quantization"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Steps of the channels")},
        {u"force_noise"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Noise of the force")},
        {u"frame_compliance"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Give of the frame")},
        {u"opening"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Opening")},
        {u"force_spikes"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Spikes of the force")},
        {u"position_held"_s, QT_TRANSLATE_NOOP("gripscope::EstimateWords", "Position renewed slowly")},
    };
    const char* name = names.value(id, nullptr);
    return name ? estimateWord(name) : id;
}

QString estimatorName(Estimator estimator)
{
    return Words::say(factsOf(estimator).name).describe();
}

} // namespace gripscope
