// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

const ChangeNote because{u"Ada"_s, u"a mistake"_s};

/// "A:approved:3 B:enrolled:1", of the types at a version.
QString summary(const Library& library, qint64 version)
{
    QStringList parts;
    for (const TypeState& type : valueOf(library.stateAt(version)).types)
        parts += u"%1:%2:%3"_s.arg(type.name, toString(type.status)).arg(type.squeezes);
    return parts.join(u' ');
}

/// What recognition is made of.
QStringList recognised(const Library& library)
{
    QStringList squeezes;
    for (const TypeSqueeze& squeeze : valueOf(library.enrolledSqueezes()))
        squeezes += u"%1 %2 %3"_s.arg(squeeze.type).arg(squeeze.parameters.k).arg(squeeze.part);
    return squeezes;
}

} // namespace

/// Every version of a library can be listed and restored.
class LibraryVersionsTest : public QObject {
    Q_OBJECT
private:
    /// A library in which everything was done that can be done.
    struct Story {
        LibraryFolder folder;
        std::unique_ptr<Library> library = folder.open();
        std::vector<QString> summaries{summary(*library, 0)}; ///< by version
        std::vector<QStringList> contents{recognised(*library)};

        Story()
        {
            const QString a = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s)).id;
            noteDown();
            QStringList squeezes;
            for (int i = 0; i < 4; ++i) {
                squeezes += valueOf(library->addGrasp(aGrasp(a, 1000 + i))).id;
                noteDown();
            }
            valueOf(library->approveType(a, u"Ada"_s));
            noteDown();
            valueOf(library->dropGrasp(squeezes[3], u"slipped"_s, u"Ada"_s));
            noteDown();
            Recipe firmer;
            firmer.peak_N = 12;
            valueOf(library->reviseType(a, firmer));
            noteDown();
            const QString b = valueOf(library->splitType(a, {squeezes[0]}, u"B"_s, because)).id;
            noteDown();
            valueOf(library->renameType(a, u"Cola"_s, because));
            noteDown();
            valueOf(library->retireType(b, because));
            noteDown();
            valueOf(library->reinstateType(b, because));
            noteDown();
            valueOf(library->mergeTypes(a, b, because));
            noteDown();
        }
        void noteDown()
        {
            summaries.push_back(summary(*library, valueOf(library->version())));
            contents.push_back(recognised(*library));
        }
    };

private slots:
    void everyVersionStaysAsItWas()
    {
        const Story story;
        QCOMPARE(valueOf(story.library->version()), qint64(story.summaries.size()) - 1);
        for (std::size_t version = 0; version < story.summaries.size(); ++version)
            QCOMPARE(summary(*story.library, qint64(version)), story.summaries[version]);
        QCOMPARE(story.summaries[0], u""_s);
        QCOMPARE(story.summaries[6], u"A:approved:4"_s);
        QCOMPARE(story.summaries[7], u"A:enrolled:3"_s); // other squeezes than were approved
        QCOMPARE(story.summaries[9], u"A:enrolled:2 B:enrolled:1"_s);
        QCOMPARE(story.summaries.back(), u"B:enrolled:3"_s);
    }
    void anyVersionCanBeRestoredAndLeftAgain()
    {
        const Story story;
        const std::size_t last = story.summaries.size() - 1;
        for (std::size_t version = 0; version < last; ++version) {
            const qint64 made = valueOf(story.library->restoreVersion(qint64(version), because));
            QCOMPARE(summary(*story.library, made), story.summaries[version]);
            QCOMPARE(recognised(*story.library), story.contents[version]);
            const LibraryChange change = valueOf(story.library->changes(1)).at(0);
            QVERIFY(change.kind == ChangeKind::Restore);
            QCOMPARE(change.other, QString::number(version));
        }
        valueOf(story.library->restoreVersion(qint64(last), because));
        QCOMPARE(recognised(*story.library), story.contents[last]);
        QCOMPARE(summary(*story.library, qint64(last)), story.summaries[last]);
    }
    void theRecipeComesBackWithItsVersion()
    {
        const Story story;
        valueOf(story.library->restoreVersion(7, because));
        QCOMPARE(valueOf(story.library->findType(u"A"_s))->recipe.peak_N, 10.0);
        valueOf(story.library->restoreVersion(8, because));
        QCOMPARE(valueOf(story.library->findType(u"A"_s))->recipe.peak_N, 12.0);
        // A further recipe does not take the number of one that is no longer in use.
        valueOf(story.library->restoreVersion(7, because));
        Recipe third;
        third.peak_N = 14;
        const QString id = valueOf(story.library->findType(u"A"_s))->id;
        QCOMPARE(valueOf(story.library->reviseType(id, third)).recipe.peak_N, 14.0);
        QCOMPARE(valueOf(story.library->findType(u"A"_s))->recipe.peak_N, 14.0);
    }
    void aRestoredLibraryGoesOn()
    {
        const Story story;
        valueOf(story.library->restoreVersion(6, because));
        const QString id = valueOf(story.library->findType(u"A"_s))->id;
        valueOf(story.library->addGrasp(aGrasp(id, 1100)));
        QCOMPARE(valueOf(story.library->findType(u"A"_s))->squeezes, 5);
    }
    void whatIsNotThereCannotBeRestored()
    {
        const Story story;
        const qint64 version = valueOf(story.library->version());
        for (const qint64 wrong : {qint64(-1), version + 1, version})
            QCOMPARE(story.library->restoreVersion(wrong, because).error().code, ErrorCode::Usage);
        QCOMPARE(story.library->stateAt(version + 1).error().code, ErrorCode::Usage);
        QCOMPARE(valueOf(story.library->version()), version);
    }
    void theExamplesAreOneVersion()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->loadExampleTypes());
        QCOMPARE(valueOf(library->version()), 1);
        valueOf(library->loadExampleTypes());
        QCOMPARE(valueOf(library->version()), 1);
        valueOf(library->restoreVersion(0, because));
        QVERIFY(valueOf(library->types()).empty());
    }
};

GRIPSCOPE_TEST(LibraryVersionsTest)
#include "library_versions_test.moc"
