// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

/// `library merge OTHER.db`: brings in what another station has.
int mergeStations(const QStringList& arguments);
/// `library status`: which stations are in a library, and what they decided apart.
int stationStatus(const QStringList& arguments);
/// `library sync --server postgresql://...`: brings a station's library and its plant's in step.
int syncWithServer(const QStringList& arguments);

} // namespace gripscope::cli
