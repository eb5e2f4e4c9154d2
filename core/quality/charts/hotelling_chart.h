// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/subgroups.h"

#include <Eigen/Core>

#include <optional>

namespace gripscope {

/// What a T^2 chart is held against: `columns` quantities measured together.
struct HotellingReference {
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance; ///< of one row
    /// Behind mean and covariance: rows, and degrees of freedom; 0 where both are known.
    double rows = 0, degreesOfFreedom = 0;
    bool subgrouped = false;    ///< the covariance is that within subgroups
    double falseAlarm = 0.0027; ///< share of points beyond the limit where nothing has changed
};

struct HotellingPoint {
    double tSquared = 0, upper = 0;
    /// What T^2 would lose without the column that it would lose most by (Runger, Alt and Montgomery,
    /// Contributors to a multivariate SPC chart signal, 1996), and which that is.
    double contribution = 0;
    int column = 0;
    [[nodiscard]] bool signal() const { return tSquared > upper; }
};

/// T^2 = n (x - mean)' S^-1 (x - mean) of subgroup means x, one at a time, against a reference that these
/// points had no part in (phase 2). With N rows and nu degrees of freedom behind it the limit is
///     (1 + n/N) p nu/(nu - p + 1) F_alpha(p, nu - p + 1);   chi^2_alpha(p) where both are known.
/// Assumes normal rows, independent of each other. Source: Montgomery, Introduction to Statistical Quality
/// Control, 11.3; Mason and Young, Multivariate Statistical Process Control, 2002.
class HotellingChart {
public:
    /// Usage: sizes that do not fit, a share outside (0, 0.5]. BadInput: columns of which one follows from
    /// the others; too few rows (nu < p).
    [[nodiscard]] static Expected<HotellingChart> of(const HotellingReference& reference);

    /// One row, or the mean of `size` of them. BadInput for another number of columns, or what is not finite.
    [[nodiscard]] Expected<HotellingPoint> at(const Eigen::VectorXd& mean, double size = 1) const;
    /// The limit of a point that is part of the reference (phase 1): of single rows
    ///     (N - 1)^2/N Beta_alpha(p/2, (N - p - 1)/2)   (Tracy, Young and Mason 1992),
    /// of subgroups (1 - n/N) p nu/(nu - p + 1) F_alpha(p, nu - p + 1).
    [[nodiscard]] double phaseOneLimit(double size) const;
    [[nodiscard]] double phaseTwoLimit(double size) const;

    [[nodiscard]] const HotellingReference& reference() const { return m_reference; }

private:
    HotellingReference m_reference;
    Eigen::MatrixXd m_inverse;
    double m_fisher = 0; ///< p nu/(nu - p + 1) F_alpha, or chi^2_alpha
    double m_beta = 0;   ///< (N - 1)^2/N Beta_alpha
};

struct HotellingOptions {
    double falseAlarm = 0.0027;
    std::optional<std::size_t> estimateFrom; ///< points that the reference is made of; absent: all
};

struct HotellingStudy {
    HotellingReference reference;
    std::vector<HotellingPoint> points;
    std::size_t phaseOne = 0; ///< so many of them made the reference
    Findings messages;
};

/// `columns`: of equal length, each as long as the layout has rows. The covariance is that of all rows where
/// they stand alone, else pooled within subgroups. Errors as of HotellingChart and Subgroups.
[[nodiscard]] Expected<HotellingStudy> studyHotelling(const SubgroupLayout& layout,
                                                      const std::vector<std::vector<double>>& columns,
                                                      const HotellingOptions& options);

/// In control 1/alpha, and after a shift of Mahalanobis length `shift` (in standard deviations of one row) by
/// the non-central chi^2; both for a reference that is known.
[[nodiscard]] double hotellingRunLength(int columns, double falseAlarm, double shift, double size = 1);

/// "Point 4: T^2 is above its limit, mostly by %column"
[[nodiscard]] Finding hotellingInWords(std::size_t point, const QString& column);

} // namespace gripscope
