// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAbstractItemModel;
class QTableView;
class QWidget;

namespace gripscope {

/// A table of a calibration: whole rows, no grid, the last column takes what is left.
[[nodiscard]] QTableView* makeCalibrationTable(QAbstractItemModel& model, QWidget* parent);

} // namespace gripscope
