// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/paper_appendix.h"

#include "core/recognition/feature_table.h"
#include "core/recognition/verdict.h"

#include <QFile>
#include <QJsonArray>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

PaperAppendix loadAppendix()
{
    const auto table =
        readFeatureTable(u":/paper/appendix.csv"_s, {u"m"_s, u"b"_s, u"k"_s, u"best_fit"_s}, u"object"_s);
    if (!table) // it is compiled in: only a broken build comes here
        qFatal("%s", qPrintable(table.error().describe()));
    PaperAppendix appendix;
    appendix.object = table->truth;
    appendix.parameters = table->values.leftCols(3);
    const Eigen::VectorXd fits = table->values.col(3);
    appendix.bestFitPercent.assign(fits.begin(), fits.end());
    return appendix;
}

/// The squeezes with a unit of time of that many seconds.
std::vector<TypeSqueeze> squeezes(double timeUnit_s)
{
    const PaperAppendix& appendix = paperAppendix();
    std::vector<TypeSqueeze> result;
    for (Eigen::Index i = 0; i < appendix.parameters.rows(); ++i) {
        const Eigen::RowVector3d p = appendix.parameters.row(i);
        result.push_back({appendix.object[i], {p(0), p(1) / timeUnit_s, p(2) / (timeUnit_s * timeUnit_s)}});
    }
    return result;
}

QJsonArray toJson(const std::vector<std::vector<int>>& table)
{
    QJsonArray rows;
    for (const std::vector<int>& row : table) {
        QJsonArray numbers;
        for (int number : row)
            numbers.append(number);
        rows.append(numbers);
    }
    return rows;
}

} // namespace

const PaperAppendix& paperAppendix()
{
    static const PaperAppendix appendix = loadAppendix();
    return appendix;
}

std::vector<TypeSqueeze> paperSqueezesAsPrinted()
{
    return squeezes(1);
}

std::vector<TypeSqueeze> paperSqueezesInSi()
{
    return squeezes(paperTimeUnit_s);
}

PaperClustering clusterPaperAppendix(FeatureScaling scaling, std::uint64_t seed)
{
    const PaperAppendix& appendix = paperAppendix();
    PaperClustering clustering;
    clustering.scaling = scaling;
    KMeansOptions options;
    options.seed = seed;
    // Neither call can fail on the appendix: 40 rows of positive numbers.
    clustering.transform = featureTransform(appendix.parameters, scaling).value();
    clustering.result = kMeans(clustering.transform.apply(appendix.parameters), options).value();
    clustering.agreement = clusterAgreement(appendix.object, clustering.result.labels, options.clusters);
    clustering.table1 = clusterTable(appendix.object, clustering.result.labels);
    return clustering;
}

QJsonObject reproducePaper()
{
    QJsonObject scalings;
    for (FeatureScaling scaling :
         {FeatureScaling::None, FeatureScaling::ZScore, FeatureScaling::Log, FeatureScaling::ZLog}) {
        const PaperClustering clustering = clusterPaperAppendix(scaling);
        scalings.insert(toString(scaling),
                        QJsonObject{{u"inertia"_s, clustering.result.inertia},
                                    {u"adjusted_rand_index"_s, clustering.agreement.adjustedRandIndex},
                                    {u"table1"_s, toJson(clustering.table1)}});
    }
    const std::vector<double>& fits = paperAppendix().bestFitPercent;
    const auto [lowest, highest] = std::minmax_element(fits.begin(), fits.end());
    return {{u"scalings"_s, scalings},
            {u"best_fit"_s, QJsonObject{{u"min"_s, *lowest}, {u"max"_s, *highest}}},
            {u"leave_one_out_correct"_s, leaveOneOutCorrect(paperSqueezesAsPrinted())}};
}

} // namespace gripscope
