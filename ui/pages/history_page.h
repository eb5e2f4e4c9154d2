// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"
#include "ui/pages/page.h"

#include <memory>

class QModelIndex;

namespace gripscope {

class HistoryModel;

/// Every inspection of the library, newest first.
class HistoryPage : public Page {
    Q_OBJECT
public:
    explicit HistoryPage(Workbench& workbench, QWidget* parent = nullptr);
    ~HistoryPage() override;

    [[nodiscard]] QString id() const override;
    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString iconName() const override;
    void setActive(bool active) override;
    void prepareTour() override;
    [[nodiscard]] bool tourReady() const override;

    [[nodiscard]] HistoryModel* model() const;
    /// Writes the rows that match the filters, all of them, shown or not.
    void exportTo(const QString& file);

private:
    [[nodiscard]] QWidget* buildBar();
    void buildTable();
    [[nodiscard]] HistoryFilter filter() const;
    void reload();
    void fetch(int offset);
    void showCounts(const InspectionCounts& counts, qint64 matching);
    void openRow(const QModelIndex& index);
    void chooseExport();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
