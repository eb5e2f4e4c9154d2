// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <QByteArray>
#include <QString>
#include <QStringList>

namespace gripscope {

/// A table of features with optional labels, from a CSV with a header.
struct FeatureTable {
    QStringList features;   ///< column names, in the order asked for
    Eigen::MatrixXd values; ///< rows: items
    QStringList truth;      ///< one label a row, or empty
};

/// Errors: BadInput with FILE:LINE:COLUMN, FileUnreadable.
[[nodiscard]] Expected<FeatureTable> readFeatureTable(const QString& file, const QStringList& features,
                                                      const QString& truthColumn = {});
[[nodiscard]] Expected<FeatureTable> parseFeatureTable(const QByteArray& text, const QString& name,
                                                       const QStringList& features,
                                                       const QString& truthColumn = {});

} // namespace gripscope
