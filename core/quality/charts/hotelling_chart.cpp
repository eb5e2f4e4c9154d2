// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/hotelling_chart.h"

#include "core/base/words.h"
#include "core/math/distributions.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace gripscope {

namespace {

constexpr double leastEigenvalue = 1e-10; // of a correlation matrix: less is one column in terms of others

std::optional<Error> checkReference(const HotellingReference& reference)
{
    const Eigen::Index columns = reference.mean.size();
    if (columns < 1 || reference.covariance.rows() != columns || reference.covariance.cols() != columns)
        return Error{ErrorCode::Usage, {Words::say("Mean and covariance of a T^2 chart do not fit.")}};
    if (!(reference.falseAlarm > 0 && reference.falseAlarm <= 0.5))
        return Error{ErrorCode::Usage,
                     {Words::say("The share of false alarms must be above 0 and at most 0.5.")}};
    const bool known = reference.degreesOfFreedom == 0;
    if (!known && reference.degreesOfFreedom < double(columns) + 1)
        return Error{
            ErrorCode::BadInput,
            {Words::say("The table"),
             Words::say("%1 degrees of freedom for %2 columns").arg(reference.degreesOfFreedom).arg(columns),
             Words::say("at least two more rows than columns, within subgroups where there are any, "
                        "were expected")}};
    return {};
}

/// Absent where a column is constant or follows from the others.
std::optional<Eigen::MatrixXd> inverseCovariance(const Eigen::MatrixXd& covariance)
{
    if (!(covariance.diagonal().array() > 0).all() || !covariance.allFinite())
        return {};
    const Eigen::VectorXd scale = covariance.diagonal().array().sqrt().inverse();
    const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
    if (solver.info() != Eigen::Success || !(solver.eigenvalues()(0) > leastEigenvalue))
        return {};
    const Eigen::MatrixXd inverse = solver.eigenvectors() * solver.eigenvalues().cwiseInverse().asDiagonal() *
                                    solver.eigenvectors().transpose();
    return Eigen::MatrixXd(scale.asDiagonal() * inverse * scale.asDiagonal());
}

struct RowsOfSubgroups {
    Eigen::MatrixXd rows; ///< columns x rows, subgroup by subgroup
    SubgroupLayout layout;

    [[nodiscard]] Eigen::VectorXd mean(std::size_t subgroup) const
    {
        return block(subgroup).rowwise().mean();
    }
    [[nodiscard]] auto block(std::size_t subgroup) const -> decltype(rows.middleCols(0, 0))
    {
        return rows.middleCols(Eigen::Index(layout.begin(subgroup)), Eigen::Index(layout.size(subgroup)));
    }
};

Expected<RowsOfSubgroups> gatherRows(const SubgroupLayout& layout,
                                     const std::vector<std::vector<double>>& columns)
{
    RowsOfSubgroups gathered{Eigen::MatrixXd(columns.size(), layout.rows()), layout};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        ASSIGN_OR_RETURN(const Subgroups groups, Subgroups::of(layout, columns[i]));
        gathered.rows.row(Eigen::Index(i)) =
            Eigen::Map<const Eigen::RowVectorXd>(groups.values.data(), Eigen::Index(groups.values.size()));
    }
    return gathered;
}

HotellingReference referenceOf(const RowsOfSubgroups& all, std::size_t phaseOne, double falseAlarm)
{
    HotellingReference reference;
    reference.falseAlarm = falseAlarm;
    const SubgroupLayout layout = all.layout.first(phaseOne);
    const Eigen::Index rows = Eigen::Index(layout.rows());
    reference.mean = all.rows.leftCols(rows).rowwise().mean();
    reference.rows = double(rows);
    reference.subgrouped = layout.largest() > 1;
    reference.degreesOfFreedom = double(rows) - (reference.subgrouped ? double(phaseOne) : 1);
    Eigen::MatrixXd residuals = all.rows.leftCols(rows);
    if (reference.subgrouped) {
        for (std::size_t i = 0; i < phaseOne; ++i)
            residuals.middleCols(Eigen::Index(layout.begin(i)), Eigen::Index(layout.size(i))).colwise() -=
                all.mean(i);
    } else {
        residuals.colwise() -= reference.mean;
    }
    reference.covariance = residuals * residuals.transpose() / std::max(1.0, reference.degreesOfFreedom);
    return reference;
}

} // namespace

Expected<HotellingChart> HotellingChart::of(const HotellingReference& reference)
{
    RETURN_IF_ERROR(checkReference(reference));
    const std::optional<Eigen::MatrixXd> inverse = inverseCovariance(reference.covariance);
    if (!inverse)
        return failure(ErrorCode::BadInput,
                       {Words::say("The columns"),
                        Words::say("one of them does not vary, or follows from the others"),
                        Words::say("leave that column out")});
    HotellingChart chart;
    chart.m_reference = reference;
    chart.m_inverse = *inverse;
    const double p = double(reference.mean.size());
    const double nu = reference.degreesOfFreedom;
    if (nu == 0) {
        chart.m_fisher = chiSquaredQuantileAbove(reference.falseAlarm, p);
        return chart;
    }
    chart.m_fisher = p * nu / (nu - p + 1) * fisherQuantileAbove(reference.falseAlarm, p, nu - p + 1);
    const double rows = reference.rows;
    if (!reference.subgrouped)
        chart.m_beta = (rows - 1) * (rows - 1) / rows *
                       betaQuantile(1 - reference.falseAlarm, p / 2, (rows - p - 1) / 2);
    return chart;
}

double HotellingChart::phaseOneLimit(double size) const
{
    if (m_reference.degreesOfFreedom == 0)
        return m_fisher;
    return m_reference.subgrouped ? (1 - size / m_reference.rows) * m_fisher : m_beta;
}

double HotellingChart::phaseTwoLimit(double size) const
{
    return m_reference.degreesOfFreedom == 0 ? m_fisher : (1 + size / m_reference.rows) * m_fisher;
}

Expected<HotellingPoint> HotellingChart::at(const Eigen::VectorXd& mean, double size) const
{
    if (mean.size() != m_reference.mean.size() || !mean.allFinite() || !(size >= 1))
        return failure(ErrorCode::BadInput,
                       {Words::say("A row for the chart"), Words::say("it has %1 columns").arg(mean.size()),
                        Words::say("%1 finite numbers were expected").arg(m_reference.mean.size())});
    const Eigen::VectorXd difference = mean - m_reference.mean;
    const Eigen::VectorXd solved = m_inverse * difference;
    HotellingPoint point;
    point.tSquared = std::max(0.0, size * difference.dot(solved));
    point.upper = phaseTwoLimit(size);
    for (Eigen::Index i = 0; i < solved.size(); ++i) {
        const double lost = size * solved(i) * solved(i) / m_inverse(i, i);
        if (lost > point.contribution) {
            point.contribution = lost;
            point.column = int(i);
        }
    }
    return point;
}

Expected<HotellingStudy> studyHotelling(const SubgroupLayout& layout,
                                        const std::vector<std::vector<double>>& columns,
                                        const HotellingOptions& options)
{
    const std::size_t phaseOne = options.estimateFrom.value_or(layout.subgroups());
    if (columns.empty() || phaseOne < 2 || phaseOne > layout.subgroups())
        return failure(
            ErrorCode::Usage,
            {Words::say("The first %1 points cannot settle the limits: there are %2, and at least 2 "
                        "are needed.")
                 .arg(phaseOne)
                 .arg(layout.subgroups())});
    ASSIGN_OR_RETURN(const RowsOfSubgroups all, gatherRows(layout, columns));
    HotellingStudy study;
    study.phaseOne = phaseOne;
    study.reference = referenceOf(all, phaseOne, options.falseAlarm);
    ASSIGN_OR_RETURN(const HotellingChart chart, HotellingChart::of(study.reference));
    study.points.reserve(layout.subgroups());
    for (std::size_t i = 0; i < layout.subgroups(); ++i) {
        const double size = double(layout.size(i));
        ASSIGN_OR_RETURN(HotellingPoint point, chart.at(all.mean(i), size));
        if (i < phaseOne)
            point.upper = chart.phaseOneLimit(size);
        study.points.push_back(point);
    }
    if (study.reference.degreesOfFreedom < 10 * double(columns.size()))
        study.messages.push_back(
            Words::say(
                "The limits come from few rows (%1 degrees of freedom); take more before they are relied on.")
                .arg(study.reference.degreesOfFreedom));
    return study;
}

double hotellingRunLength(int columns, double falseAlarm, double shift, double size)
{
    const double limit = chiSquaredQuantileAbove(falseAlarm, columns);
    const double noncentrality = shift * shift * size;
    const double below =
        noncentrality > 0 ? nonCentralChiSquaredBelow(limit, columns, noncentrality) : 1 - falseAlarm;
    return 1 / (1 - below);
}

Finding hotellingInWords(std::size_t point, const QString& column)
{
    return Words::say("Point %1: T^2 is above its limit, mostly by %2").arg(point + 1).arg(Finding(column));
}

} // namespace gripscope
