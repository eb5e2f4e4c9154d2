// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/design/excitation_design.h"

#include "core/base/words.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// The search works on this many runs at most; finer ones gain next to nothing.
constexpr std::size_t mostRuns = 200;
/// A run of this share of the fastest object's 1 / natural frequency is as short as is of use.
constexpr double shortestUsefulRun = 0.25;
constexpr int sweeps = 30;
constexpr std::size_t leastSamples = 20, mostSamples = 200'000;
/// As many as the periodic estimator needs.
constexpr std::size_t inverseRepeatPeriods = 4;
/// Different sequences of a kind; the best is kept.
constexpr std::uint64_t sequences = 6;

double naturalFrequency(const MassDampingStiffness& p)
{
    return std::sqrt(p.k / p.m);
}

/// A signal within +-1 and where it comes from.
struct Shape {
    DesignKind kind;
    double bit_s;
    std::vector<double> values;
};

class Designer {
public:
    explicit Designer(const DesignOptions& options) : m_options(options), m_criterion(options)
    {
        double logarithm = 0;
        for (const DesignObject& object : options.objects) {
            const double frequency = naturalFrequency(object.mean);
            logarithm += std::log(frequency) / static_cast<double>(options.objects.size());
            m_fastest = std::max(m_fastest, frequency);
        }
        m_frequency = std::exp(logarithm);
    }

    ExcitationDesign design()
    {
        for (const double times : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0}) {
            offerKind(DesignKind::Prbs, times / m_frequency);
            offerKind(DesignKind::InverseRepeat, times / m_frequency);
        }
        for (const double times : {0.5, 1.0, 2.0, 4.0}) {
            // Half a period of the highest frequency, `times` natural frequencies.
            offerKind(DesignKind::Multisine, std::numbers::pi / (times * m_frequency));
            offerKind(DesignKind::Chirp, std::numbers::pi / (times * m_frequency));
        }
        offerKind(DesignKind::WhiteBinary, m_options.sampleTime_s);
        offer({DesignKind::Step, 0, std::vector<double>(m_options.samples(), 1.0)});
        searchBinary();
        return finished();
    }

private:
    /// The best of each kind, with the information it gives.
    struct Entry {
        Shape shape;
        std::vector<Eigen::Matrix3d> information;
        double logDeterminant;
        DesignCriterion::Separation separation;
    };

    [[nodiscard]] std::vector<double> made(ExcitationKind kind, double bit_s, std::size_t samples,
                                           std::uint64_t seed) const
    {
        ExcitationOptions options;
        options.kind = kind;
        options.peak = 1;
        options.bias = 0;
        options.bit_s = bit_s;
        options.sampleTime_s = m_options.sampleTime_s;
        options.samples = samples;
        options.seed = seed;
        options.oneSided = false;
        return makeExcitation(options).value_or(std::vector<double>(samples, 0.0));
    }

    [[nodiscard]] std::vector<double> values(DesignKind kind, double bit_s, std::uint64_t seed) const
    {
        const std::size_t samples = m_options.samples();
        switch (kind) {
        case DesignKind::Multisine:
            return made(ExcitationKind::Multisine, bit_s, samples, seed);
        case DesignKind::Chirp:
            return made(ExcitationKind::Chirp, bit_s, samples, seed);
        case DesignKind::InverseRepeat: {
            // Each period a sequence and its negative: even harmonics are empty.
            const std::size_t half = std::max<std::size_t>(samples / (2 * inverseRepeatPeriods), 1);
            const std::vector<double> sequence = made(ExcitationKind::Prbs, bit_s, half, seed);
            std::vector<double> all(samples);
            for (std::size_t i = 0; i < samples; ++i)
                all[i] = (i / half) % 2 == 0 ? sequence[i % half] : -sequence[i % half];
            return all;
        }
        default:
            return made(ExcitationKind::Prbs, bit_s, samples, seed);
        }
    }

    void offerKind(DesignKind kind, double bit_s)
    {
        const double duration = static_cast<double>(m_options.samples()) * m_options.sampleTime_s;
        bit_s = std::clamp(bit_s, std::max(m_options.shortestRun_s, m_options.sampleTime_s), duration / 2);
        const std::uint64_t tries = kind == DesignKind::Chirp ? 1 : sequences;
        for (std::uint64_t i = 0; i < tries; ++i)
            offer({kind, bit_s, values(kind, bit_s, m_options.seed * 1000 + i)});
    }

    [[nodiscard]] std::vector<Eigen::Matrix3d> informationOf(const Shape& shape) const
    {
        std::vector<double> force = shape.values;
        for (double& value : force)
            value *= m_options.amplitude();
        SensitivityOptions options;
        options.sampleTime_s = m_options.sampleTime_s;
        options.hold = m_options.hold;
        std::vector<Eigen::Matrix3d> information;
        for (const DesignObject& object : m_options.objects)
            information.push_back(fisherInformation(responseSensitivities(object.mean, force, options)));
        return information;
    }

    [[nodiscard]] bool isBetter(const Entry& a, const Entry& b) const
    {
        return m_options.objects.size() > 1 && a.separation.distance != b.separation.distance
                   ? a.separation.distance > b.separation.distance
                   : a.logDeterminant > b.logDeterminant;
    }

    void offer(const Shape& shape)
    {
        Entry entry{shape, informationOf(shape), 0, {}};
        entry.logDeterminant = DesignCriterion::meanLogDeterminant(entry.information);
        entry.separation = m_criterion.separation(entry.information);
        const auto same = std::find_if(m_entries.begin(), m_entries.end(),
                                       [&](const Entry& other) { return other.shape.kind == shape.kind; });
        if (shape.kind == DesignKind::OptimizedBinary)
            m_bestLogDeterminant = std::max(m_bestLogDeterminant, entry.logDeterminant);
        if (same == m_entries.end())
            m_entries.push_back(std::move(entry));
        else if (isBetter(entry, *same))
            *same = std::move(entry);
    }

    [[nodiscard]] std::size_t runSamples() const
    {
        const double useful = shortestUsefulRun / m_fastest;
        const double run = std::max(useful, m_options.shortestRun_s) / m_options.sampleTime_s;
        const auto samples = static_cast<std::size_t>(std::clamp(std::ceil(run - 1e-9), 1.0, 1e6));
        return std::max(samples, (m_options.samples() + mostRuns - 1) / mostRuns);
    }

    /// First for the determinant, which is the yardstick, then for the separation.
    void searchBinary()
    {
        const std::size_t run = std::min(runSamples(), m_options.samples());
        const BinaryExchange exchange(m_options, run);
        std::vector<Shape> starts;
        for (const Entry& entry : m_entries) {
            if (entry.shape.kind == DesignKind::Prbs || entry.shape.kind == DesignKind::InverseRepeat)
                starts.push_back(entry.shape);
        }
        for (const double times : {1.5, 3.0})
            starts.push_back({DesignKind::Prbs, times / m_frequency,
                              values(DesignKind::Prbs, times / m_frequency, m_options.seed * 1000 + 77)});
        for (const Shape& start : starts) {
            std::vector<int> signs(exchange.runs());
            for (std::size_t i = 0; i < signs.size(); ++i) {
                const std::size_t middle = std::min(i * run + run / 2, start.values.size() - 1);
                signs[i] = start.values[middle] < 0 ? -1 : 1;
            }
            signs = exchange.improve(signs, DesignCriterion::meanLogDeterminant, sweeps);
            offer(binary(signs, run));
            if (m_options.objects.size() < 2)
                continue;
            signs = exchange.improve(
                signs,
                [this](const std::vector<Eigen::Matrix3d>& m) { return m_criterion.separation(m).distance; },
                sweeps);
            offer(binary(signs, run));
        }
    }

    [[nodiscard]] Shape binary(const std::vector<int>& signs, std::size_t run) const
    {
        Shape shape{DesignKind::OptimizedBinary, static_cast<double>(run) * m_options.sampleTime_s, {}};
        for (std::size_t i = 0; i < m_options.samples(); ++i)
            shape.values.push_back(signs[i / run]);
        return shape;
    }

    [[nodiscard]] ExcitationDesign finished()
    {
        std::stable_sort(m_entries.begin(), m_entries.end(),
                         [this](const Entry& a, const Entry& b) { return isBetter(a, b); });
        ExcitationDesign design;
        design.amplitude = m_options.amplitude();
        for (const Entry& entry : m_entries)
            design.candidates.push_back(candidate(entry));
        return design;
    }

    [[nodiscard]] DesignCandidate candidate(const Entry& entry) const
    {
        DesignCandidate result;
        result.kind = entry.shape.kind;
        result.bit_s = entry.shape.bit_s;
        const double lowest = m_options.oneSided ? 0 : -m_options.limit;
        for (const double value : entry.shape.values)
            result.force.push_back(
                std::clamp(m_options.bias + m_options.amplitude() * value, lowest, m_options.limit));
        result.dEfficiency = std::exp(entry.logDeterminant - m_bestLogDeterminant);
        for (std::size_t i = 0; i < entry.information.size(); ++i) {
            const std::optional<Eigen::Matrix3d> inverse = inverseInformation(entry.information[i]);
            if (!inverse) {
                result.standardErrors.emplace_back();
                continue;
            }
            const Eigen::Vector3d relative = m_options.noiseDeviation * inverse->diagonal().cwiseSqrt();
            result.standardErrors.emplace_back(relative.cwiseProduct(m_options.objects[i].mean.vector()));
        }
        result.separation = entry.separation.distance;
        result.nearestFirst = entry.separation.first;
        result.nearestSecond = entry.separation.second;
        return result;
    }

    const DesignOptions& m_options;
    DesignCriterion m_criterion;
    double m_frequency = 1, m_fastest = 0; ///< natural frequencies: geometric mean, highest
    std::vector<Entry> m_entries;
    double m_bestLogDeterminant = -1e300;
};

/// Half a natural period too few samples, or too many to be of use: the ratio of frequency and sample rate.
bool isSampledSensibly(const DesignObject& object, const DesignOptions& options)
{
    const double frequency = naturalFrequency(object.mean);
    return std::isfinite(frequency) && frequency * options.sampleTime_s < std::numbers::pi &&
           frequency * options.duration_s > 0.1;
}

bool isPossible(const DesignObject& object)
{
    const Eigen::Vector3d p = object.mean.vector();
    return p.allFinite() && p.minCoeff() > 0 && object.covariance.allFinite() &&
           object.covariance.diagonal().minCoeff() >= 0;
}

} // namespace

QString toString(DesignKind kind)
{
    switch (kind) {
    case DesignKind::OptimizedBinary:
        return u"optimized-binary"_s;
    case DesignKind::Prbs:
        return u"prbs"_s;
    case DesignKind::InverseRepeat:
        return u"inverse-repeat"_s;
    case DesignKind::Multisine:
        return u"multisine"_s;
    case DesignKind::Chirp:
        return u"chirp"_s;
    case DesignKind::WhiteBinary:
        return u"white-binary"_s;
    case DesignKind::Step:
        return u"step"_s;
    }
    return {};
}

std::size_t DesignOptions::samples() const
{
    const double count = std::round(duration_s / sampleTime_s);
    return count >= 0 && count < 1e15 ? static_cast<std::size_t>(count) : 0;
}

double DesignOptions::amplitude() const
{
    const double ground = oneSided ? bias : limit + bias;
    return std::max(std::min({peak, limit - bias, ground}), 0.0);
}

std::optional<Error> DesignOptions::validate() const
{
    const auto usage = [](const Finding& reason) { return Error{ErrorCode::Usage, {reason}}; };
    const auto isPositive = [](double value) { return std::isfinite(value) && value > 0; };
    if (objects.empty())
        return usage(Words::say("at least one object is needed"));
    if (!isPositive(peak) || !isPositive(limit) || !std::isfinite(bias))
        return usage(Words::say("peak and limit must be numbers above 0, the bias a number"));
    if (!isPositive(duration_s) || !isPositive(sampleTime_s) || !isPositive(noiseDeviation))
        return usage(Words::say("duration, sample time and noise must be numbers above 0"));
    if (!std::isfinite(shortestRun_s) || shortestRun_s < 0)
        return usage(Words::say("the shortest run must be a number from 0 up"));
    if (!isPositive(amplitude()))
        return usage((oneSided
                          ? Words::say("bias and limit leave no room: no force may be above %1 nor below 0")
                          : Words::say("bias and limit leave no room: no force may be above %1"))
                         .arg(limit));
    if (samples() < leastSamples || samples() > mostSamples)
        return usage(
            Words::say("the signal must have from %1 to %2 samples").arg(leastSamples).arg(mostSamples));
    for (const DesignObject& object : objects) {
        if (!isPossible(object))
            return usage(Words::say("m, b and k of object %1 must be numbers above 0").arg(object.name));
        if (!isSampledSensibly(object, *this))
            return usage(
                Words::say("object %1 swings too fast or too slowly for this sample time and duration")
                    .arg(object.name));
    }
    return std::nullopt;
}

Expected<ExcitationDesign> designExcitation(const DesignOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    return Designer(options).design();
}

} // namespace gripscope
