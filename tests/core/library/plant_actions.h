// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/verification/library_verification.h"
#include "tests/core/library/library_fixture.h"

#include <random>

namespace gripscope::test {

inline const ChangeNote why{u"Ada"_s, u"one plant"_s};

[[nodiscard]] inline QString enrol(Library& library, const QString& name, int squeezes = 1)
{
    const QString id = valueOf(library.addType(name, {}, u"N"_s, u"m"_s, u"Ada"_s)).id;
    for (int i = 0; i < squeezes; ++i)
        valueOf(library.addGrasp(aGrasp(id, 9000 + i)));
    return id;
}

[[nodiscard]] inline bool isWhole(const QString& place)
{
    const LibraryVerification found = valueOf(verifyLibrary(place));
    for (const LibraryDifference& difference : found.differences)
        qWarning("%s", qPrintable(inWords(difference)));
    return found.whole();
}

/// What the program works with, by names: types in use and retired with all that is in force, and their
/// squeezes.
inline QStringList inForce(const Library& library)
{
    QStringList lines;
    for (const auto& types : {valueOf(library.types()), valueOf(library.retiredTypes())})
        for (const TypeRecord& type : types) {
            QStringList squeezes;
            for (const GraspRecord& grasp : valueOf(library.grasps(type.id)))
                squeezes += grasp.id + (grasp.accepted ? u""_s : u" dropped"_s);
            squeezes.sort();
            lines += u"%1 %2 %3 %4 %5 %6 %7: %8"_s
                         .arg(type.id, type.name, toString(type.status), type.code, toText(type.limits))
                         .arg(type.recipe.peak_N)
                         .arg(type.squeezes)
                         .arg(squeezes.join(u' '));
        }
    lines.sort();
    return lines;
}

/// One change of types or squeezes, or none.
inline void changeSomething(Library& library, std::mt19937& random)
{
    const auto below = [&](std::size_t end) { return std::size_t(random() % end); };
    const QString word = u"name %1"_s.arg(below(5));
    std::vector<TypeRecord> types = valueOf(library.types());
    if (types.empty() || below(6) == 0) {
        if (!valueOf(library.findType(word)))
            static_cast<void>(enrol(library, word));
        return;
    }
    const TypeRecord type = types[below(types.size())];
    Recipe recipe = type.recipe;
    PartLimits limits;
    limits.quantities[2] = toleranceLimitsFromText(u"%1:20000"_s.arg(1000 + below(100)));
    const auto squeezes = valueOf(library.grasps(type.id));
    // What is refused, such as a name that is taken, changes nothing.
    switch (below(10)) {
    case 0:
        static_cast<void>(library.renameType(type.id, word, why));
        break;
    case 1:
        static_cast<void>(library.approveType(type.id, u"Ada"_s));
        break;
    case 2:
        static_cast<void>(library.retireType(type.id, why));
        break;
    case 3:
        recipe.peak_N = 1.0 + double(below(9));
        static_cast<void>(library.reviseType(type.id, recipe, why));
        break;
    case 4:
        static_cast<void>(library.setTypeLimits(type.id, limits, why));
        break;
    case 5:
        static_cast<void>(library.setTypeCode(type.id, u"code %1"_s.arg(below(3)), why));
        break;
    case 6:
        if (!squeezes.empty())
            static_cast<void>(library.dropGrasp(squeezes[below(squeezes.size())].id, u"slipped"_s, u"Ada"_s));
        break;
    case 7:
        static_cast<void>(library.mergeTypes(type.id, types[below(types.size())].id, why));
        break;
    case 8:
        static_cast<void>(
            library.restoreVersion(qint64(below(std::size_t(valueOf(library.version()) + 1))), why));
        break;
    default:
        static_cast<void>(library.addGrasp(aGrasp(type.id, 8000 + double(below(2000)))));
        break;
    }
}

} // namespace gripscope::test
