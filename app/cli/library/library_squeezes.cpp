// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/library_squeezes.h"

#include "core/recognition/types/squeeze_values.h"
#include "core/session/squeeze/comparable_units.h"
#include "core/signal/recording/units.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Inspections read at once.
constexpr int pageSize = 1000;

TypeSqueeze inCommonUnits(const InspectionRecord& inspection, const QString& type,
                          const std::optional<Eigen::Matrix3d>& covariance)
{
    const double factor = siFactor(inspection.forceUnit, inspection.positionUnit).value_or(1.0);
    return scaledSqueeze(type, *inspection.parameters, covariance, factor);
}

} // namespace

Expected<QString> existingLibraryFile(const QString& file)
{
    if (!QFileInfo::exists(file)) // opening would make an empty one
        return failure(ErrorCode::StorageOpen, {file, u"there is no such file; enrol types first"_qs});
    return file;
}

Expected<std::unique_ptr<Library>> openExistingLibrary(const QString& file)
{
    return existingLibraryFile(file).and_then([](const QString& path) { return Library::open(path); });
}

Expected<TypeModels> approvedModels(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, library.approvedSqueezes());
    return ComparableTypes(types, squeezes).main();
}

Expected<InspectedSqueezes> inspectedSqueezes(Library& library)
{
    InspectedSqueezes found;
    HistoryFilter filter;
    filter.limit = pageSize;
    while (true) {
        ASSIGN_OR_RETURN(const std::vector<InspectionRecord> page, library.inspections(filter));
        for (const InspectionRecord& inspection : page) {
            const QString type =
                inspection.expectedType.isEmpty() ? inspection.type : inspection.expectedType;
            if (type.isEmpty() || !inspection.parameters || inspection.verdict == VerdictKind::Invalid) {
                found.leftOut += 1;
                continue;
            }
            ASSIGN_OR_RETURN(const std::optional<GraspRecord> grasp, library.grasp(inspection.graspId));
            found.squeezes.push_back(
                inCommonUnits(inspection, type, grasp ? grasp->covariance : std::nullopt));
        }
        if (page.size() < std::size_t(pageSize))
            break;
        filter.offset += pageSize;
    }
    std::reverse(found.squeezes.begin(), found.squeezes.end());
    return found;
}

} // namespace gripscope::cli
