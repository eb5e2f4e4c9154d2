// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/batch.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/opened_file.h"

namespace gripscope::test {

/// Names as somebody would choose them who wants more than to be called: markup that opens the bait,
/// entities, placeholders, what steers a terminal or turns the line, halves of characters, and far too much
/// of it.
[[nodiscard]] inline QStringList hostileNames(const BaitFile& bait)
{
    const QString picture = QStringLiteral("<img src=\"%1\">").arg(bait.path());
    return {
        picture,
        QStringLiteral("<img src=\"file://%1\"/>").arg(bait.path()),
        QStringLiteral("<b>bold</b><script>&amp;&lt;%1 %2 %n</script>") + picture,
        QStringLiteral("<table background='%1'><tr><td>").arg(bait.path()),
        QStringLiteral("\x1b[31m\x07\n\r\t\u202egpj.\u2066x") + picture,
        QStringLiteral("a\n# force_unit: kN\n[*] & && &x ") + picture,
        QString(QChar(0xd83d)) + picture + QChar(0xde00),
        picture + QString(64 * 1024, QLatin1Char('W')),
    };
}

/// A library whose every text that a person or a file can choose is one of `names`.
inline void fillWithHostileNames(const QString& file, const QStringList& names)
{
    {
        auto library = valueOf(Library::open(file));
        QStringList types;
        for (const double k : {9990.0, 5000.0, 7000.0}) {
            const QString id = valueOf(library->addType(QStringLiteral("T%1").arg(k), {}, QStringLiteral("N"),
                                                        QStringLiteral("m")))
                                   .id;
            for (int i = 0; i < 6; ++i)
                valueOf(library->addGrasp(aGrasp(id, k * (1 + 0.01 * i))));
            valueOf(library->approveType(id, {}));
            types << id;
        }
        const BatchRecord batch = valueOf(library->beginBatch({QStringLiteral("batch"), 20, {}, {}}));
        for (const VerdictKind kind : {VerdictKind::Type, VerdictKind::Unknown, VerdictKind::Invalid})
            for (int i = 0; i < 3; ++i) {
                NewInspection inspection = anInspection(kind, QStringLiteral("T5000"));
                inspection.batchId = batch.id;
                valueOf(library->addInspection(inspection));
            }
    }
    RawDatabase raw(file);
    // As many people as there are names, none of them active: they are listed, and nobody has to sign in.
    for (int i = 0; i < names.size(); ++i)
        raw.run(
            QStringLiteral("INSERT INTO people VALUES ('p%1', '', '2026-01-01T00:00:00.000Z', 'p%1', 1, 'x', "
                           "'operator', 0, '', 1)")
                .arg(i));
    raw.run(QStringLiteral(
        "INSERT INTO enrollment_drafts (id, station, created_utc, type_name, state, step, recipe_name, "
        "peak_n, "
        "bias_n, bit_s, seconds, max_force_n, max_travel_m, part, picture_id, pending_id, remark, "
        "operator_name, serial) VALUES ('d', '', '2026-01-01T00:00:00.000Z', 'x', 'open', "
        "'recipe', 'x', 10, 20, 0.005, 1, 40, 0.02, 'x', NULL, NULL, 'x', 'x', 1)"));
    int next = 0;
    const auto fill = [&](const QString& table, const QStringList& columns) {
        const qint64 rows = raw.count(table);
        for (qint64 row = 0; row < rows; ++row) {
            const QString id =
                raw.run(QStringLiteral("SELECT rowid FROM %1 LIMIT 1 OFFSET %2").arg(table).arg(row))
                    .toString();
            for (const QString& column : columns) {
                // As bytes, which is how a library keeps them: a half of a character has none of its own.
                QString name = QString::fromUtf8(names[next++ % names.size()].toUtf8());
                name.replace(QLatin1Char('\''), QStringLiteral("''"));
                raw.run(QStringLiteral("UPDATE ") + table + QStringLiteral(" SET ") + column +
                        QStringLiteral(" = '") + name + QStringLiteral("' WHERE rowid = ") + id);
            }
        }
    };
    fill(QStringLiteral("type_states"), {QStringLiteral("name"), QStringLiteral("code")});
    fill(QStringLiteral("type_versions"), {QStringLiteral("recipe_name")});
    fill(QStringLiteral("library_changes"), {QStringLiteral("type_name"), QStringLiteral("other_name"),
                                             QStringLiteral("operator_name"), QStringLiteral("reason")});
    fill(QStringLiteral("grasps"),
         {QStringLiteral("operator_name"), QStringLiteral("source"), QStringLiteral("part"),
          QStringLiteral("device_name"), QStringLiteral("device_serial"), QStringLiteral("firmware")});
    fill(QStringLiteral("inspections"), {QStringLiteral("expected_type"), QStringLiteral("type_name"),
                                         QStringLiteral("nearest"), QStringLiteral("operator_name")});
    fill(QStringLiteral("people"), {QStringLiteral("name")});
    fill(QStringLiteral("batches"),
         {QStringLiteral("name"), QStringLiteral("expected_type"), QStringLiteral("operator_name")});
    fill(QStringLiteral("enrollment_drafts"),
         {QStringLiteral("type_name"), QStringLiteral("recipe_name"), QStringLiteral("part"),
          QStringLiteral("remark"), QStringLiteral("operator_name")});
    fill(QStringLiteral("audit_entries"),
         {QStringLiteral("person"), QStringLiteral("subject"), QStringLiteral("reason")});
}

} // namespace gripscope::test
