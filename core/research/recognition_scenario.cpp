// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/recognition_scenario.h"

#include "core/base/parallel_runs.h"
#include "core/math/distributions.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int types = 4;
constexpr double scatter = 0.039;
constexpr double neighbourDeviations = 3.5;
constexpr int promisePoints = 20'000;
constexpr double rangeMargin = 5; ///< standard deviations beyond the types, StrangersInRange

QString typeName(int type)
{
    return QString(QChar(u'A' + type));
}

/// Draws squeezes; everything in standard deviations about the types' means.
class Source {
public:
    Source(const RecognitionScenario& scenario, std::uint64_t seed)
        : m_kind(scenario.kind), m_squeezes(scenario.squeezes), m_space(scenario.space), m_noise(seed),
          m_toLogs(scatter * LogMatrix::Identity(m_space.dimensions(), m_space.dimensions()))
    {
        if (scenario.unlikeScatter && m_space == QuantitySpace{}) {
            const Eigen::Vector3d shape(1, 1.5, 2);
            const Eigen::Matrix3d axes = rotation(), directions = rotation();
            m_toLogs = scatter * std::sqrt(3.0) * axes * shape.normalized().asDiagonal() * directions;
        }
    }

    LogVector normals()
    {
        LogVector z(m_space.dimensions());
        for (double& value : z)
            value = m_noise();
        return z;
    }

    [[nodiscard]] LogVector mean(int type) const
    {
        LogVector at = LogVector::Zero(m_space.dimensions());
        if (m_kind == ScenarioKind::Neighbours && type == 1)
            at(0) = neighbourDeviations;
        else
            at(axisOfTypes()) = apart() * type;
        return at;
    }

    LogVector squeeze(int type)
    {
        const LogVector z = normals();
        if (m_kind == ScenarioKind::HeavyTails) {
            constexpr int tail = 5; // of unit covariance: variance 5/3 of the t taken out
            double chiSquared = 0;
            for (int i = 0; i < tail; ++i)
                chiSquared += std::pow(m_noise(), 2);
            return mean(type) + std::sqrt((tail - 2) / chiSquared) * z;
        }
        return mean(type) + (m_kind == ScenarioKind::TwiceTheSpread && type == 0 ? 2 : 1) * z;
    }

    [[nodiscard]] LogVector logs(const LogVector& deviations) const { return m_toLogs * deviations; }

    [[nodiscard]] TypeSqueeze squeezeOf(const QString& type, const LogVector& deviations) const
    {
        if (m_space != QuantitySpace{})
            return squeezeAt(type, m_space, logs(deviations));
        const Eigen::Vector3d p = logs(deviations).array().exp();
        return {type, {p(0), p(1), p(2)}};
    }

    /// Evenly over range(), in standard deviations.
    LogVector stranger()
    {
        LogVector at(m_space.dimensions());
        for (Eigen::Index i = 0; i < at.size(); ++i)
            at(i) = m_noise.uniform() * widthOf(i) - rangeMargin;
        return at;
    }

    [[nodiscard]] InstrumentRange range() const
    {
        const auto bounds = [&](TypeQuantity quantity) {
            const Eigen::Index place = m_space.placeOf(quantity).value_or(0);
            return QuantityRange{std::exp(-scatter * rangeMargin),
                                 std::exp(scatter * (widthOf(place) - rangeMargin))};
        };
        const QuantityRange m = bounds(TypeQuantity::Mass), b = bounds(TypeQuantity::Damping),
                            k = bounds(TypeQuantity::Stiffness);
        return {{m.lowest, b.lowest, k.lowest},
                {m.highest, b.highest, k.highest},
                bounds(TypeQuantity::RelaxingShare),
                bounds(TypeQuantity::RelaxationTime),
                bounds(TypeQuantity::Friction)};
    }

    TypeModels enrol()
    {
        std::vector<TypeSqueeze> enrolled;
        for (int type = 0; type < types; ++type)
            for (int i = 0; i < m_squeezes; ++i)
                enrolled.push_back(squeezeOf(typeName(type), squeeze(type)));
        return fitTypeModels(enrolled, m_space);
    }

private:
    [[nodiscard]] Eigen::Index axisOfTypes() const { return m_space.dimensions() > 1 ? 1 : 0; }
    /// 4 sd are a gate; at 60 nothing is mistaken.
    [[nodiscard]] double apart() const { return m_kind == ScenarioKind::StrangersInRange ? 10 : 60; }
    [[nodiscard]] double widthOf(Eigen::Index coordinate) const
    {
        return 2 * rangeMargin + (coordinate == axisOfTypes() ? apart() * (types - 1) : 0);
    }

    Eigen::Matrix3d rotation()
    {
        const double w = m_noise(), x = m_noise(), y = m_noise(), z = m_noise();
        return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    }

    ScenarioKind m_kind;
    int m_squeezes;
    QuantitySpace m_space;
    GaussianNoise m_noise;
    LogMatrix m_toLogs;
};

/// Those who know both neighbours' means and covariance, on the same squeeze.
void countOracles(const LogVector& deviations, int type, const VerdictOptions& options, EnrolmentTally& tally)
{
    const double gate = chiSquaredGate(options.falseReject, int(deviations.size()));
    const double other = neighbourDeviations - deviations(0);
    const double radial = deviations.tail(deviations.size() - 1).squaredNorm();
    const double nearest = std::min(std::abs(deviations(0)), std::abs(other));
    if (nearest * nearest + radial > gate)
        return;
    const double fromMiddle = std::abs(deviations(0) - neighbourDeviations / 2);
    const bool isWrong = (deviations(0) > neighbourDeviations / 2) != (type == 1);
    const double posteriorAt = std::log((1 - options.wrongType) / options.wrongType) / neighbourDeviations;
    const double rateAt = normalQuantileAbove(options.wrongType) - neighbourDeviations / 2;
    const auto decide = [&](const QString& name, double least) {
        if (fromMiddle < least)
            return;
        tally.counts[name] += 1;
        tally.counts[name + u"_wrong"_s] += isWrong;
    };
    decide(u"oracle_posterior"_s, posteriorAt);
    decide(u"oracle_rate"_s, rateAt);
}

/// Whether this enrolment keeps the rate, by its gate and what it thinks of the first type.
bool keepsPromise(const TypeModels& models, Source& source, const VerdictOptions& options)
{
    const Verdict verdict = judge(models, source.squeezeOf({}, source.mean(0)), options);
    if (!verdict.gate)
        return true; // it says that it cannot tell, and refuses nobody
    const std::vector<TypePrediction> predictions =
        predictTypes(models, source.logs(source.mean(0)), {}, {options.robust});
    const Eigen::LLT<LogMatrix> cholesky(predictions[0].covariance);
    int outside = 0;
    for (int i = 0; i < promisePoints; ++i) {
        const LogVector difference = source.logs(source.mean(0) + source.normals()) - predictions[0].meanLog;
        outside += cholesky.matrixL().solve(difference).squaredNorm() > *verdict.gate;
    }
    return outside <= options.falseReject * promisePoints;
}

} // namespace

StudyTally pooled(const std::vector<EnrolmentTally>& enrolments)
{
    StudyTally tally;
    tally.enrolments = int(enrolments.size());
    for (const EnrolmentTally& one : enrolments) {
        tally.cases += one.cases;
        for (auto it = one.counts.cbegin(); it != one.counts.cend(); ++it)
            tally.shares[it.key()].count += it.value();
    }
    if (!(tally.cases > 0))
        return tally;
    for (auto it = tally.shares.begin(); it != tally.shares.end(); ++it) {
        it->share = it->count / tally.cases;
        double squares = 0;
        for (const EnrolmentTally& one : enrolments)
            squares += std::pow(one.counts.value(it.key(), 0) - it->share * one.cases, 2);
        it->standardError = std::sqrt(squares) / tally.cases;
    }
    return tally;
}

std::vector<EnrolmentTally> tallyRuns(int runs, int threads, const std::function<EnrolmentTally(int)>& one)
{
    std::vector<EnrolmentTally> tallies(std::size_t(std::max(0, runs)));
    shareAmongThreads(std::int64_t(tallies.size()), threads,
                      [&](std::int64_t run) { tallies[std::size_t(run)] = one(int(run)); });
    return tallies;
}

QString toString(ScenarioKind kind)
{
    switch (kind) {
    case ScenarioKind::KnownParts:
        return u"known_parts"_s;
    case ScenarioKind::Promise:
        return u"promise"_s;
    case ScenarioKind::Neighbours:
        return u"neighbours"_s;
    case ScenarioKind::Strangers:
        return u"strangers"_s;
    case ScenarioKind::TwiceTheSpread:
        return u"twice_the_spread"_s;
    case ScenarioKind::HeavyTails:
        return u"heavy_tails"_s;
    case ScenarioKind::StrangersInRange:
        return u"strangers_in_range"_s;
    case ScenarioKind::NoiseMismatch:
        return u"noise_mismatch"_s;
    }
    return {};
}

double RecognitionScenario::statedRate() const
{
    if (kind == ScenarioKind::StrangersInRange)
        return options.strangerAccept;
    return kind == ScenarioKind::Neighbours ? options.wrongType : options.falseReject;
}

QString RecognitionScenario::name() const
{
    QString name = u"%1-%2-%3"_s.arg(toString(kind)).arg(squeezes).arg(statedRate());
    if (kind == ScenarioKind::Strangers)
        name += u"-%1sd"_s.arg(deviations);
    if (unlikeScatter)
        name += u"-unlike"_s;
    if (space != QuantitySpace{})
        name += u"-%1"_s.arg(toString(space));
    return options.robust ? name + u"-robust"_s : name;
}

void count(const Verdict& verdict, const QString& type, EnrolmentTally& tally)
{
    tally.cases += 1;
    const bool isType = verdict.kind == VerdictKind::Type;
    tally.counts[u"type"_s] += isType && verdict.type == type;
    tally.counts[u"wrong_type"_s] += isType && verdict.type != type;
    tally.counts[u"unknown"_s] += verdict.kind == VerdictKind::Unknown;
    tally.counts[u"inconclusive"_s] += verdict.kind == VerdictKind::Inconclusive;
}

EnrolmentTally runScenario(const RecognitionScenario& scenario, std::uint64_t seed)
{
    EnrolmentTally tally;
    Source source(scenario, seed);
    const TypeModels models = source.enrol();
    if (scenario.kind == ScenarioKind::Promise) {
        tally.cases = 1;
        tally.counts[u"kept"_s] = keepsPromise(models, source, scenario.options);
        return tally;
    }
    VerdictOptions options = scenario.options;
    if (scenario.kind == ScenarioKind::StrangersInRange)
        options.range = source.range();
    for (int i = 0; i < scenario.judged; ++i) {
        if (scenario.kind == ScenarioKind::StrangersInRange) {
            const Verdict verdict = judge(models, source.squeezeOf({}, source.stranger()), options);
            tally.cases += 1;
            tally.counts[u"accepted"_s] += verdict.kind == VerdictKind::Type;
            continue;
        }
        if (scenario.kind == ScenarioKind::Strangers) {
            const LogVector off = scenario.deviations * source.normals().normalized() + source.normals();
            const Verdict verdict = judge(models, source.squeezeOf({}, source.mean(0) + off), options);
            tally.cases += 1;
            tally.counts[u"accepted"_s] += verdict.kind == VerdictKind::Type;
            tally.counts[u"oracle_accepted"_s] +=
                off.squaredNorm() <= chiSquaredGate(options.falseReject, int(off.size()));
            continue;
        }
        const int judgedTypes = scenario.kind == ScenarioKind::TwiceTheSpread ? 1
                                : scenario.kind == ScenarioKind::Neighbours   ? 2
                                                                              : types;
        const int type = i % judgedTypes;
        const LogVector at = source.squeeze(type);
        count(judge(models, source.squeezeOf({}, at), options), typeName(type), tally);
        if (scenario.kind == ScenarioKind::Neighbours)
            countOracles(at, type, options, tally);
    }
    return tally;
}

} // namespace gripscope
