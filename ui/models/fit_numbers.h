// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QString>

namespace gripscope {

/// Every number of an identification that belongs to no plot, for a spreadsheet: tab-separated blocks with a
/// header line each and an empty line between them; full precision, units in the headers. First the
/// estimators (as EstimateTableModel::toTsv()), then, of the recommended one, what follows from m, b and k,
/// the correlation matrix, the residual tests, the uncertainty budget and the other models; last the checks
/// on the measurement.
[[nodiscard]] QString fitNumbers(const Identification& identification, const QString& forceUnit,
                                 const QString& positionUnit);

} // namespace gripscope
