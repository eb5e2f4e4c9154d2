// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"
#include "ui/charts/category_plot.h"

#include <QCoreApplication>

#include <array>

namespace gripscope {

/// The charts of a study, as they are on the screen and on paper.
class StudyCharts {
    Q_DECLARE_TR_FUNCTIONS(StudyCharts)
public:
    /// "Repeatability", "Operator", ...
    [[nodiscard]] static QString component(GaugeComponent component);
    /// Where m, b, k is among the values of a measurement; 0 for another name.
    [[nodiscard]] static std::size_t placeOf(const QString& quantity);

    /// Components of variation; measurements by part; by operator; ranges by operator and part; interaction.
    static constexpr std::size_t count = 5;
    [[nodiscard]] static std::array<CategoryChart, count> of(const KeptStudy& study,
                                                             const GaugeResult& result, std::size_t quantity);
    /// The one chart of another kind: of a type-1 study its readings in their order beside the reference, of
    /// linearity the bias of each reading by reference, of attributes the parts that each rater judges alike,
    /// and right; empty for a gauge study.
    [[nodiscard]] static CategoryChart single(const KeptStudy& study, const StudyResult& result);
};

} // namespace gripscope
