// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace gripscope::cli {

// The actions of `gripscope-cli library ACTION`; `arguments` follow the action. They return the exit code.
// `verify` and `examples` are in command_library.cpp.

/// `backup FILE`: a copy of a library that may be in use.
int backUp(const QStringList& arguments);
/// `restore FILE`: the way back.
int restore(const QStringList& arguments);
/// `merge OTHER.db`: brings in what another station has.
int mergeStations(const QStringList& arguments);
/// `status`: which stations are in a library, and what they decided apart.
int stationStatus(const QStringList& arguments);
/// `sync --server postgresql://...`: brings a station's library and its plant's in step.
int syncWithServer(const QStringList& arguments);
/// `take-back FILE`: stores inspections that were kept aside.
int takeBack(const QStringList& arguments);

} // namespace gripscope::cli
