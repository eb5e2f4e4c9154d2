// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/predictive.h"
#include "core/recognition/verdict.h"

#include <optional>
#include <vector>

namespace gripscope {

/// One squeeze held against all types, step by step; what judge() does. `models` has a scatter, `parameters`
/// are positive; `noise` is their covariance in logs.
class Judgement {
public:
    Judgement(const TypeModels& models, const MassDampingStiffness& parameters,
              const std::optional<Eigen::Matrix3d>& noise, const VerdictOptions& options);
    [[nodiscard]] Verdict verdict() const;

private:
    void findGates();
    void findNearest();
    [[nodiscard]] std::optional<double> gateOf(const TypePrediction& prediction) const;
    [[nodiscard]] bool inside(std::size_t type) const;
    void describeType(Verdict& verdict) const;
    void decide(Verdict& verdict) const;
    /// Whether the stated share of strangers forbids the nearest type; fills in what is said of strangers.
    bool heldForStranger(Verdict& verdict) const;

    const TypeModels& m_models;
    const MassDampingStiffness& m_parameters;
    const std::optional<Eigen::Matrix3d>& m_noise;
    const VerdictOptions& m_options;
    Eigen::Vector3d m_log;
    std::vector<TypePrediction> m_predictions;
    std::vector<double> m_gates; ///< on d' V^-1 d; empty when some type has none
    std::size_t m_nearest = 0;
};

} // namespace gripscope
