// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/design/excitation_design.h"
#include "core/identification/model/response_sensitivities.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

/// ln det of an information matrix that is singular.
constexpr double singular = -3000;

double determinant(const Eigen::Matrix3d& a)
{
    return a.row(0).dot(a.row(1).cross(a.row(2)));
}

/// Scaled first, so that parameters known to very different accuracy do not pass for dependent.
double logDeterminant(const Eigen::Matrix3d& information)
{
    const Eigen::Vector3d diagonal = information.diagonal();
    if (!information.allFinite() || !(diagonal.minCoeff() > 0))
        return singular;
    const Eigen::Vector3d scale = diagonal.cwiseSqrt().cwiseInverse();
    const double scaled = determinant(scale.asDiagonal() * information * scale.asDiagonal());
    constexpr double smallest = 1e-13; // rounding
    return scaled > smallest ? std::max(std::log(scaled) + diagonal.array().log().sum(), singular) : singular;
}

} // namespace

DesignCriterion::DesignCriterion(const DesignOptions& options)
    : m_noiseVariance(options.noiseDeviation * options.noiseDeviation)
{
    for (const DesignObject& object : options.objects) {
        const Eigen::Vector3d p = object.mean.vector();
        m_logarithms.emplace_back(p.array().log().matrix());
        const Eigen::Vector3d inverse = p.cwiseInverse();
        m_scatter.emplace_back(inverse.asDiagonal() * object.covariance * inverse.asDiagonal());
    }
}

double DesignCriterion::meanLogDeterminant(const std::vector<Eigen::Matrix3d>& information)
{
    double sum = 0;
    for (const Eigen::Matrix3d& one : information)
        sum += logDeterminant(one) / 3;
    return information.empty() ? singular : sum / static_cast<double>(information.size());
}

DesignCriterion::Separation DesignCriterion::separation(const std::vector<Eigen::Matrix3d>& information) const
{
    std::vector<Eigen::Matrix3d> covariances;
    for (std::size_t i = 0; i < information.size(); ++i) {
        const std::optional<Eigen::Matrix3d> inverse = inverseInformation(information[i]);
        if (!inverse)
            return {};
        covariances.emplace_back(m_scatter[i] + m_noiseVariance * *inverse);
    }
    Separation nearest;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < covariances.size(); ++i) {
        for (std::size_t j = i + 1; j < covariances.size(); ++j) {
            const std::optional<Eigen::Matrix3d> metric =
                inverseInformation((covariances[i] + covariances[j]) / 2);
            const Eigen::Vector3d apart = m_logarithms[i] - m_logarithms[j];
            const double squared = metric ? apart.dot(*metric * apart) : 0;
            if (!(squared < smallest))
                continue;
            smallest = squared;
            nearest = {std::sqrt(std::max(squared, 0.0)), static_cast<int>(i), static_cast<int>(j)};
        }
    }
    return nearest;
}

BinaryExchange::BinaryExchange(const DesignOptions& options, std::size_t runSamples)
    : m_runs((options.samples() + runSamples - 1) / runSamples)
{
    std::vector<double> pulse(options.samples(), 0.0);
    std::fill_n(pulse.begin(), std::min(runSamples, pulse.size()), options.amplitude());
    SensitivityOptions sensitivity;
    sensitivity.sampleTime_s = options.sampleTime_s;
    for (const DesignObject& object : options.objects)
        m_products.push_back(productsFor(responseSensitivities(object.mean, pulse, sensitivity), runSamples));
}

BinaryExchange::Products BinaryExchange::productsFor(const ResponseSensitivities& pulse,
                                                     std::size_t runSamples) const
{
    const Eigen::MatrixX3d& r = pulse.parameters;
    const Eigen::Index samples = r.rows();
    const auto run = static_cast<Eigen::Index>(runSamples);
    const auto runs = static_cast<Eigen::Index>(m_runs);
    Products products(m_runs * m_runs, Eigen::Matrix3d::Zero());
    // Run k's response is that of the first, k runs later and cut at the end: for runs d apart the sum over
    // the common samples grows from the last run to the first.
    for (Eigen::Index d = 0; d < runs; ++d) {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        Eigen::Index done = 0;
        for (Eigen::Index k = runs - 1; k >= d; --k) {
            const Eigen::Index length = samples - k * run - done;
            sum.noalias() += r.middleRows(done + d * run, length).transpose() * r.middleRows(done, length);
            done += length;
            products[static_cast<std::size_t>((k - d) * runs + k)] = sum;
            products[static_cast<std::size_t>(k * runs + k - d)] = sum.transpose();
        }
    }
    // What the nuisances explain goes: R_j' Q Q' R_k.
    std::vector<Eigen::MatrixX3d> explained;
    for (Eigen::Index j = 0; j < runs; ++j)
        explained.emplace_back(pulse.nuisances.bottomRows(samples - j * run).transpose() *
                               r.topRows(samples - j * run));
    for (std::size_t j = 0; j < m_runs; ++j) {
        for (std::size_t k = 0; k < m_runs; ++k)
            products[j * m_runs + k].noalias() -= explained[j].transpose() * explained[k];
    }
    return products;
}

std::vector<Eigen::Matrix3d> BinaryExchange::information(const std::vector<int>& signs) const
{
    std::vector<Eigen::Matrix3d> result(m_products.size(), Eigen::Matrix3d::Zero());
    for (std::size_t object = 0; object < m_products.size(); ++object) {
        for (std::size_t j = 0; j < m_runs; ++j) {
            for (std::size_t k = 0; k < m_runs; ++k)
                result[object] += (signs[j] * signs[k]) * product(object, j, k);
        }
    }
    return result;
}

std::vector<int> BinaryExchange::improve(std::vector<int> signs, const Score& score, int sweeps) const
{
    const std::size_t objects = m_products.size();
    // sum_k s_k R_j' R_k, kept up to date.
    std::vector<std::vector<Eigen::Matrix3d>> sums(objects);
    for (std::size_t object = 0; object < objects; ++object) {
        for (std::size_t j = 0; j < m_runs; ++j) {
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            for (std::size_t k = 0; k < m_runs; ++k)
                sum += signs[k] * product(object, j, k);
            sums[object].push_back(sum);
        }
    }
    std::vector<Eigen::Matrix3d> now = information(signs);
    double best = score(now);
    std::vector<Eigen::Matrix3d> trial(objects);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        bool improved = false;
        for (std::size_t j = 0; j < m_runs; ++j) {
            for (std::size_t object = 0; object < objects; ++object) {
                const Eigen::Matrix3d& sum = sums[object][j];
                trial[object] =
                    now[object] - (2 * signs[j]) * (sum + sum.transpose()) + 4 * product(object, j, j);
            }
            const double found = score(trial);
            // Rounding must not flip for ever.
            if (!(found > best + 1e-9 * std::abs(best)))
                continue;
            for (std::size_t object = 0; object < objects; ++object) {
                for (std::size_t k = 0; k < m_runs; ++k)
                    sums[object][k] -= (2 * signs[j]) * product(object, k, j);
            }
            signs[j] = -signs[j];
            now = trial;
            best = found;
            improved = true;
        }
        if (!improved)
            break;
    }
    return signs;
}

} // namespace gripscope
