// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/types/type_model.h"

#include <QMap>

#include <memory>
#include <mutex>
#include <vector>

namespace gripscope {

/// Types in the space that their squeezes determine (spaceOf()), and in parts of it for squeezes that
/// determine less: those are fitted when the first one comes. May be asked from several threads.
class ModelsBySpace {
public:
    explicit ModelsBySpace(std::vector<TypeSqueeze> squeezes = {});

    /// In spaceOf(squeezes).
    [[nodiscard]] std::shared_ptr<const TypeModels> whole() const { return m_whole; }
    /// In m, b and k, which charts and maps show; types without them are not among these.
    [[nodiscard]] std::shared_ptr<const TypeModels> linear() const { return m_linear; }
    /// In as much of the space as the squeeze determines; the whole where that is none of it.
    [[nodiscard]] std::shared_ptr<const TypeModels> modelsFor(const TypeSqueeze& squeeze) const;

private:
    std::vector<TypeSqueeze> m_squeezes;
    std::shared_ptr<const TypeModels> m_whole, m_linear;
    mutable std::mutex m_mutex; ///< of m_parts
    mutable QMap<QString, std::shared_ptr<const TypeModels>> m_parts;
};

} // namespace gripscope
