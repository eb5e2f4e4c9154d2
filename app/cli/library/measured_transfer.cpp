// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/measured_transfer.h"

#include "app/cli/library/existing_library.h"
#include "core/session/inspect/inspected_squeezes.h"
#include "core/session/squeeze/comparable_units.h"

namespace gripscope::cli {

namespace {

/// What of a library's units the other's squeezes cannot be held against.
std::optional<Error> unitsProblem(Library& home, Library& other)
{
    const Expected<std::vector<TypeRecord>> types = home.types(), others = other.types();
    if (!types)
        return types.error();
    if (!others)
        return others.error();
    if (types->empty() || others->empty())
        return {};
    const TypeRecord& one = types->front();
    const TypeRecord& two = others->front(); // all types of a library are comparable
    const Expected<double> factor =
        parameterFactor(two.forceUnit, two.positionUnit, one.forceUnit, one.positionUnit);
    return factor ? std::nullopt : std::optional(factor.error());
}

} // namespace

Expected<TransferReport> measuredTransfer(const QString& homeFile, const QString& otherFile)
{
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> home, openExistingLibrary(homeFile));
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> other, openExistingLibrary(otherFile));
    RETURN_IF_ERROR(unitsProblem(*home, *other));
    ASSIGN_OR_RETURN(const TypeModels models, approvedModels(*home));
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, other->enrolledSqueezes());
    return measureTransfer(models, squeezes);
}

} // namespace gripscope::cli
