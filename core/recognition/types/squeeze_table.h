// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/recognition/types/type_model.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <vector>

namespace gripscope {

/// Which columns of a table hold what.
struct SqueezeColumns {
    QStringList parameters{QStringLiteral("m"), QStringLiteral("b"), QStringLiteral("k")};
    QStringList deviations; ///< standard errors of m, b and k: three names, or none
    QString type;           ///< name of the type; empty: all rows are of `typeName`
    QString typeName;
};

/// A row of a table of m, b and k, of any origin.
struct SqueezeRow {
    int line = 0;                      ///< in the file, from 1
    TypeSqueeze squeeze;               ///< covariance: the squares of the deviations on its diagonal
    std::optional<Error> refused = {}; ///< why it is no squeeze, with the place
};

/// Rows in order. A row is refused by itself: fields missing or too many, no type, something that is no
/// number, m, b or k that are not above zero (negative errors too). BadInput for what spoils all rows: no
/// header, columns that are not there, a quote that stays open, no rows. Usage: not three parameters, not
/// three or no deviations, no type.
[[nodiscard]] Expected<std::vector<SqueezeRow>> parseSqueezeTable(const QByteArray& text, const QString& name,
                                                                  const SqueezeColumns& columns);
/// FileUnreadable too.
[[nodiscard]] Expected<std::vector<SqueezeRow>> readSqueezeTable(const QString& file,
                                                                 const SqueezeColumns& columns);

} // namespace gripscope
