// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "core/store/statement.h"

namespace gripscope::measuring_chain_table {

[[nodiscard]] Expected<void> insert(Database& database, const RowStamp& stamp,
                                    const NewMeasuringChain& measured);
/// The newest of this gripper.
[[nodiscard]] Expected<std::optional<MeasuringChainRecord>> newest(Database& database,
                                                                   const QString& gripperSerial);

} // namespace gripscope::measuring_chain_table
