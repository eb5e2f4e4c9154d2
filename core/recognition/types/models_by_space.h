// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/types/type_model.h"

#include <QMap>
#include <QStringList>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gripscope {

/// What the squeezes of each type determine: many squeezes, few kinds of them. A type determines what more
/// than half of its squeezes do, so that one poor squeeze takes no quantity from all. Squeezes without any
/// usable quantity do not count.
class DeterminedByType {
public:
    explicit DeterminedByType(const std::vector<TypeSqueeze>& squeezes = {});

    /// The largest space that each type determines; of equally large ones that which comes first in order of
    /// TypeQuantity. m, b, k where there is no type; empty where they have nothing in common.
    [[nodiscard]] QuantitySpace space() const { return space(m_kinds.keys()); }
    /// The same of these alone; of those that are none nothing is asked.
    [[nodiscard]] QuantitySpace space(const QStringList& types) const;
    /// The types that determine all of the space, sorted.
    [[nodiscard]] QStringList typesWith(const QuantitySpace& space) const;
    /// Of each type by itself, each space once.
    [[nodiscard]] std::vector<QuantitySpace> ownSpaces() const;

private:
    using Kinds = std::map<Determines, int>; ///< how many squeezes determine what
    [[nodiscard]] static bool mostDetermine(const Kinds& kinds, QuantitySet set);
    QMap<QString, Kinds> m_kinds;
};

/// Types in the space that their squeezes determine (spaceOf()), in parts of it for squeezes that determine
/// less, and in larger ones those that determine more: both are fitted when they are first asked for. May be
/// asked from several threads.
class ModelsBySpace {
public:
    using Models = std::shared_ptr<const TypeModels>;
    explicit ModelsBySpace(std::vector<TypeSqueeze> squeezes = {});

    /// In spaceOf(squeezes).
    [[nodiscard]] Models whole() const { return m_whole; }
    /// In m, b and k, which charts and maps show; types without them are not among these.
    [[nodiscard]] Models linear() const { return m_linear; }
    /// In as much of the space as the squeeze determines; the whole where that is none of it.
    [[nodiscard]] Models modelsFor(const TypeSqueeze& squeeze) const;

    /// Each type determines what all do, and no more.
    [[nodiscard]] bool allDetermineTheSame() const;
    /// Whether some type and the squeeze determine more than `space` together.
    [[nodiscard]] bool mayGoBeyond(const QuantitySpace& space, const TypeSqueeze& squeeze) const;
    /// In what these types and the squeeze determine together: they, and what other types determine it too.
    /// Nothing where that is no more than `space`, or where too few squeezes are enrolled for a gate that
    /// keeps anything out there.
    [[nodiscard]] Models beyond(const QuantitySpace& space, const QStringList& types,
                                const TypeSqueeze& squeeze) const;
    /// In all that these types determine together; the whole where that is no more, or no more is judged by.
    [[nodiscard]] Models modelsAmong(const QStringList& types) const;

    /// Mahalanobis distance in standard deviations between the means of two types, in all that both
    /// determine. Nothing where one is none of the types, or nothing is known of the scatter.
    [[nodiscard]] std::optional<double> distance(const QString& one, const QString& other) const;

private:
    [[nodiscard]] Models fittedOnce(const QuantitySpace& space, TypeModels::Reach reach) const;
    std::vector<TypeSqueeze> m_squeezes;
    DeterminedByType m_determined;
    std::vector<QuantitySpace> m_ownSpaces;
    Models m_whole, m_linear;
    mutable std::mutex m_mutex;             ///< of m_fitted
    mutable QMap<QString, Models> m_fitted; ///< by space: a part of the whole, or what not all determine
};

} // namespace gripscope
