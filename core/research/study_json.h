// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

#include <vector>

namespace gripscope {

struct DesignOptions;
struct EarlyDecisionStudy;
struct EarlyDecisionStudyOptions;
struct EfficiencyOptions;
struct EfficiencyStudy;
struct ExcitationDesign;
struct RecognitionStudy;
struct RecognitionStudyOptions;
struct ModelEfficiencyOptions;
struct ModelEfficiencyStudy;
struct TruthStudy;
struct TruthStudyOptions;

/// The document of `gripscope-cli design --json`; the force of the best candidate alone, in full.
[[nodiscard]] QJsonObject toJson(const ExcitationDesign& design, const DesignOptions& options);

/// The document of `gripscope-cli study efficiency --json`. Numbers without runs behind them are null.
[[nodiscard]] QJsonObject toJson(const EfficiencyStudy& study, const EfficiencyOptions& options);

/// That of `gripscope-cli study efficiency --models ... --json`.
[[nodiscard]] QJsonObject toJson(const ModelEfficiencyStudy& study, const ModelEfficiencyOptions& options);

/// The document of `gripscope-cli study early --json`.
[[nodiscard]] QJsonObject toJson(const std::vector<EarlyDecisionStudy>& rows,
                                 const EarlyDecisionStudyOptions& options);

/// The document of `gripscope-cli study recognition --json`.
[[nodiscard]] QJsonObject toJson(const RecognitionStudy& study, const RecognitionStudyOptions& options);

/// The document of `gripscope-cli study truth --json`.
[[nodiscard]] QJsonObject toJson(const TruthStudy& study, const TruthStudyOptions& options);

} // namespace gripscope
