// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"

#include "core/clustering/feature_table.h"

#include <QFile>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

PaperAppendix loadAppendix()
{
    const auto table =
        readFeatureTable(u":/paper/appendix.csv"_s, {u"m"_s, u"b"_s, u"k"_s, u"best_fit"_s}, u"object"_s);
    if (!table) // it is compiled in: only a broken build comes here
        qFatal("%s", qPrintable(table.error().name()));
    PaperAppendix appendix;
    appendix.object = table->truth;
    appendix.parameters = table->values.leftCols(3);
    const Eigen::VectorXd fits = table->values.col(3);
    appendix.bestFitPercent.assign(fits.begin(), fits.end());
    return appendix;
}

/// The squeezes with a unit of time of that many seconds.
std::vector<TypeSqueeze> appendixSqueezes(double timeUnit_s)
{
    const PaperAppendix& appendix = paperAppendix();
    std::vector<TypeSqueeze> result;
    for (Eigen::Index i = 0; i < appendix.parameters.rows(); ++i) {
        const Eigen::RowVector3d p = appendix.parameters.row(i);
        result.push_back({appendix.object[i], {p(0), p(1) / timeUnit_s, p(2) / (timeUnit_s * timeUnit_s)}});
    }
    return result;
}

} // namespace

const PaperAppendix& paperAppendix()
{
    static const PaperAppendix appendix = loadAppendix();
    return appendix;
}

std::vector<TypeSqueeze> paperSqueezesAsPrinted()
{
    return appendixSqueezes(1);
}

std::vector<TypeSqueeze> paperSqueezesInSi()
{
    return appendixSqueezes(paperTimeUnit_s);
}

} // namespace gripscope
