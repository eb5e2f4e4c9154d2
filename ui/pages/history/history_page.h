// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/library/history_document.h"
#include "ui/models/history_model.h"
#include "ui/pages/page.h"

#include <functional>
#include <memory>
#include <vector>

namespace gripscope {

/// Every squeeze of the library, inspected or enrolled: as a list or as charts, what is known of the one that
/// is chosen, and what can be done with those that are selected or let through by the filters.
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
    /// Chooses it in the list of all squeezes, by its key.
    void showSqueeze(const QString& graspId);
    /// Writes all squeezes that the filters let through, shown or not.
    void exportTo(const QString& file, HistoryFormat format);
    /// Writes the recordings of the selected squeezes into a folder.
    void exportRecordingsTo(const QString& folder);
    void reportTo(const QString& file);

private:
    [[nodiscard]] QWidget* buildActions();
    [[nodiscard]] QWidget* buildContent();
    [[nodiscard]] QWidget* buildEmpty();
    void buildExportMenu();
    [[nodiscard]] HistoryQuery query() const;
    void reload();
    void countOn();
    void showCounts();
    void fetchPage();
    void loadPoints();
    void showPoints(std::shared_ptr<const HistoryPoints> points);
    void loadDetails();
    void choose(const QString& key);
    void withSelected(std::function<void(std::vector<QString>)> then);
    void showContent();
    void refreshActions();
    void openCurrent();
    void overlaySelected();
    void identifyAgain();
    void openIdentifyAgain(std::vector<QString> keys);
    void chooseFile(const QString& title, const QString& filter, const QString& suffix,
                    void (HistoryPage::*write)(const QString&));
    void exportCsv(const QString& file) { exportTo(file, HistoryFormat::Csv); }
    void exportJson(const QString& file) { exportTo(file, HistoryFormat::Json); }
    void exportAqdef(const QString& file) { exportTo(file, HistoryFormat::Aqdef); }
    void chooseFolder();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
