// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/research/paper_reproduction.h"

#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/verdict/verdict.h"

#include <QJsonArray>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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
