// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of `types` that judge an enrolment.
#include "app/cli/library/type_commands.h"
#include "app/cli/library/type_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/library/records/type_squeeze.h"
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/signal/recording/units.h"

#include <QJsonArray>

#include <algorithm>
#include <iterator>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// All squeezes of types in use, and whether they are in SI.
struct Squeezes {
    std::vector<TypeSqueeze> all;
    VerdictOptions options;
};

Expected<Squeezes> readSqueezes(const Library& library, const VerdictOptions& rates)
{
    if (std::optional<Error> error = rates.validate())
        return tl::unexpected<Error>(std::move(*error));
    ASSIGN_OR_RETURN(auto all, library.enrolledSqueezes());
    ASSIGN_OR_RETURN(const auto types, library.types());
    Squeezes squeezes{std::move(all), rates};
    for (const TypeRecord& type : types) // they are all alike
        squeezes.options.siUnits = siFactor(type.forceUnit, type.positionUnit).has_value();
    return squeezes;
}

/// An outlier as `types squeezes` lists it.
struct StoredOutlier {
    SqueezeOutlier outlier;
    int number = 0;
    QString key;
    [[nodiscard]] QJsonObject json() const
    {
        QJsonObject document = toJson(outlier);
        document.insert(u"number"_qs, number);
        document.insert(u"key"_qs, key);
        return document;
    }
};

Expected<std::vector<StoredOutlier>> outliersOf(const Library& library, const TypeRecord& type,
                                                const std::vector<TypeSqueeze>& all)
{
    ASSIGN_OR_RETURN(const auto grasps, library.grasps(type.id));
    std::vector<TypeSqueeze> squeezes; // the type's own first, with their numbers
    std::vector<int> numbers;
    for (std::size_t i = 0; i < grasps.size(); ++i) {
        const auto own = typeSqueeze(grasps[i]);
        if (!own || !grasps[i].accepted)
            continue;
        squeezes.push_back(*own);
        numbers.push_back(int(i) + 1);
    }
    std::copy_if(all.begin(), all.end(), std::back_inserter(squeezes),
                 [&](const TypeSqueeze& squeeze) { return squeeze.type != type.name; });
    const std::vector<SqueezeOutlier> outliers = findOutliers(squeezes, type.name);
    std::vector<StoredOutlier> found;
    found.reserve(outliers.size());
    for (const SqueezeOutlier& outlier : outliers) {
        const int number = numbers[outlier.index];
        found.push_back({outlier, number, grasps[std::size_t(number) - 1].id});
    }
    return found;
}

QString confusionText(const HeldOutConfusion& confusion, const VerdictOptions& rates)
{
    QStringList lines;
    for (qsizetype row = 0; row < confusion.types.size(); ++row) {
        QStringList found;
        for (qsizetype column = 0; column < confusion.counts.cols(); ++column) {
            const int count = confusion.counts(row, column);
            const QString name = column < confusion.types.size()    ? confusion.types[column]
                                 : column == confusion.types.size() ? u"unknown"_qs
                                                                    : u"inconclusive"_qs;
            if (count > 0)
                found << u"%1 %2"_qs.arg(count).arg(name);
        }
        lines << u"%1: %2"_qs.arg(confusion.types[row],
                                  found.isEmpty() ? u"not tested"_qs : found.join(u", "_qs));
    }
    lines << u"Another type: "_qs + inWords(confusion.wrongType, rates.wrongType).describe();
    lines << u"Unknown: "_qs + inWords(confusion.unknown, rates.falseReject).describe();
    return lines.join(u'\n');
}

void tell(const EnrollmentProgress& progress, const std::vector<StoredOutlier>& away,
          const std::optional<TypeOverlap>& overlap, bool json)
{
    if (json) {
        QJsonObject document = toJson(progress);
        document.insert(u"type"_qs, progress.type);
        QJsonArray outliers;
        for (const StoredOutlier& outlier : away)
            outliers.append(outlier.json());
        document.insert(u"outliers"_qs, outliers);
        document.insert(u"overlap"_qs, overlap ? QJsonValue(toJson(*overlap)) : QJsonValue());
        printJson(document);
        return;
    }
    print(described(inWords(progress)).join(u'\n'));
    for (const StoredOutlier& outlier : away)
        print(u"Squeeze %1 is an outlier. %2"_qs.arg(outlier.number).arg(outlier.outlier.reason.describe()));
    print(overlap ? inWords(*overlap).describe() : u"No other type overlaps it."_qs);
}

} // namespace

int guideEnrollment(const QStringList& arguments)
{
    CommandLine line(u"types guide"_qs,
                     u"Says whether a type has enough squeezes, which of them lies away from the others and "
                     "why, and which other type it overlaps."_qs);
    addTypeOption(line);
    addRateOptions(line);
    if (const auto exit = parseWith(line, arguments, {u"type"_qs}))
        return *exit;
    const VerdictOptions rates = verdictRates(line);
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](const Library& library) -> Expected<void> {
        ASSIGN_OR_RETURN(const auto type, requireNamed(library, line.text(u"type"_qs)));
        ASSIGN_OR_RETURN(const auto squeezes, readSqueezes(library, rates));
        ASSIGN_OR_RETURN(const auto away, outliersOf(library, type, squeezes.all));
        const ModelsBySpace types(squeezes.all);
        tell(enrollmentProgress(*types.whole(), type.name, squeezes.options), away,
             worstOverlap(types, type.name, squeezes.options), line.isSet(u"json"_qs));
        return {};
    });
}

int showConfusion(const QStringList& arguments)
{
    CommandLine line(
        u"types confusion"_qs,
        u"Leaves enrolled squeezes out and asks what the others call them, with exact bounds."_qs);
    addRateOptions(line);
    if (const auto exit = parseWith(line, arguments))
        return *exit;
    const VerdictOptions rates = verdictRates(line);
    if (const auto exit = line.finish())
        return *exit;
    return withLibrary(line, [&](const Library& library) {
        return readSqueezes(library, rates).map([&](const Squeezes& squeezes) {
            const HeldOutConfusion confusion = heldOutConfusion(squeezes.all, squeezes.options);
            if (line.isSet(u"json"_qs))
                printJson(toJson(confusion));
            else
                print(confusionText(confusion, squeezes.options));
        });
    });
}

} // namespace gripscope::cli
