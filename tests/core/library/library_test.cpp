// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

class LibraryTest : public QObject {
    Q_OBJECT
private slots:
    void aTypeComesBackAsItWasAdded()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const Recipe recipe{u"gentle"_s, 5, 10, 0.0025, 0.5, 15, 0.01};
        const TypeRecord added = valueOf(library->addType(u"Can, 33 cl"_s, recipe, u"N"_s, u"mm"_s));
        const auto found = valueOf(folder.open()->findType(u"Can, 33 cl"_s));
        QVERIFY(found);
        QCOMPARE(found->id, added.id);
        QVERIFY(found->recipe == recipe);
        QCOMPARE(found->forceUnit, u"N"_s);
        QCOMPARE(found->positionUnit, u"mm"_s);
        QCOMPARE(found->squeezes, 0);
        QVERIFY(!found->approved);
        QVERIFY(std::abs(found->created.secsTo(QDateTime::currentDateTimeUtc())) < 60);
        QVERIFY(!valueOf(library->findType(u"Other"_s)));
    }
    void typesAreListedByName()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const QString& name : {u"C"_s, u"A"_s, u"B"_s})
            valueOf(library->addType(name, {}, u"N"_s, u"m"_s));
        QStringList names;
        for (const TypeRecord& type : valueOf(library->types()))
            names += type.name;
        QCOMPARE(names, QStringList({u"A"_s, u"B"_s, u"C"_s}));
    }
    void aNameCanBeUsedOnce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        QCOMPARE(library->addType(u"A"_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
        QCOMPARE(library->addType(u"  "_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
        QCOMPARE(valueOf(library->types()).size(), std::size_t(1));
    }
    void approvalAndANewRecipeAreKept()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        valueOf(library->approveType(type.id, u"Ada"_s));
        Recipe firmer = type.recipe;
        firmer.peak_N = 12;
        QVERIFY(valueOf(library->reviseType(type.id, firmer)).recipe == firmer);
        const auto found = valueOf(library->findType(u"A"_s));
        QVERIFY(found->approved);
        QVERIFY(found->recipe == firmer);
        QCOMPARE(library->approveType(u"nobody"_s, u"Ada"_s).error().code, ErrorCode::NotFound);
        QCOMPARE(library->reviseType(u"nobody"_s, firmer).error().code, ErrorCode::NotFound);
    }
    void aSqueezeComesBackBitForBit()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        const NewGrasp grasp = aGrasp(type.id);
        const GraspRecord added = valueOf(library->addGrasp(grasp));
        const auto again = folder.open();
        const auto found = valueOf(again->grasp(added.id));
        QVERIFY(found);
        QCOMPARE(found->typeName, u"A"_s);
        QCOMPARE(found->source, grasp.source);
        QCOMPARE(found->operatorName, grasp.operatorName);
        QVERIFY(found->accepted);
        QVERIFY(found->hasRecording);
        QVERIFY(*found->parameters == *grasp.estimates[0].parameters);
        QVERIFY(*found->covariance == *grasp.estimates[0].covariance);
        QCOMPARE(*found->simulationFitPercent, 91.25);
        QVERIFY(valueOf(again->recording(added.id)) == *grasp.recording);
        QCOMPARE(valueOf(again->identificationDocument(added.id)), grasp.identification);
    }
    void whatASqueezeDeterminesBesidesOrInsteadComesBack()
    {
        const LibraryFolder folder;
        const TypeRecord type = valueOf(folder.open()->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        NewGrasp grasp = aGrasp(type.id);
        grasp.determined = someQuantities();
        const GraspRecord besides = valueOf(folder.open()->addGrasp(grasp));
        grasp.estimates.resize(1);
        grasp.estimates[0].parameters.reset(); // no mass was found
        grasp.estimates[0].covariance.reset();
        grasp.determined->covariance.reset();
        const GraspRecord instead = valueOf(folder.open()->addGrasp(grasp));
        const auto library = folder.open();
        const GraspRecord first = *valueOf(library->grasp(besides.id));
        QVERIFY(first.parameters && first.determined && first.determined->space == someQuantities().space);
        QVERIFY(first.determined->log == someQuantities().log);
        QVERIFY(*first.determined->covariance == *someQuantities().covariance);
        const GraspRecord second = *valueOf(library->grasp(instead.id));
        QVERIFY(!second.parameters && second.determined && !second.determined->covariance);
        const auto squeezes = valueOf(library->enrolledSqueezes());
        QCOMPARE(squeezes.size(), std::size_t(2));
        for (const TypeSqueeze& squeeze : squeezes)
            QVERIFY(squeeze.determined && squeeze.determined->log == someQuantities().log);
        QCOMPARE(squeezes[1].parameters.k, 0.0);
    }
    void whatWasDeterminedMustBeNumbers()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        NewGrasp grasp = aGrasp(type.id);
        grasp.determined = someQuantities();
        grasp.determined->log[1] = std::nan("");
        QCOMPARE(library->addGrasp(grasp).error().code, ErrorCode::Usage);
        grasp.determined = someQuantities();
        grasp.determined->covariance = LogMatrix::Identity(2, 2);
        QCOMPARE(library->addGrasp(grasp).error().code, ErrorCode::Usage);
        QVERIFY(valueOf(library->grasps(type.id)).empty());
    }
    void squeezesAreInOrderOfRecording()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        QStringList added;
        for (int i = 0; i < 20; ++i)
            added += valueOf(library->addGrasp(aGrasp(type.id))).id;
        QStringList listed;
        for (const GraspRecord& grasp : valueOf(library->grasps(type.id)))
            listed += grasp.id;
        QCOMPARE(listed, added);
    }
    void aDroppedSqueezeStaysOnRecordButCountsNoMore()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        const QString first = valueOf(library->addGrasp(aGrasp(type.id, 1000))).id;
        valueOf(library->addGrasp(aGrasp(type.id, 2000)));
        valueOf(library->dropGrasp(first, u"slipped"_s, u"Ada"_s));
        valueOf(library->dropGrasp(first, u"slipped"_s, u"Ada"_s));
        QCOMPARE(valueOf(library->findType(u"A"_s))->squeezes, 1);
        QCOMPARE(valueOf(library->grasps(type.id)).size(), std::size_t(2));
        QVERIFY(!valueOf(library->grasp(first))->accepted);
        const auto enrolled = valueOf(library->enrolledSqueezes());
        QCOMPARE(enrolled.size(), std::size_t(1));
        QCOMPARE(enrolled[0].parameters.k, 2000.0);
        QCOMPARE(library->dropGrasp(u"nobody"_s, {}, {}).error().code, ErrorCode::NotFound);
    }
    void enrolledSqueezesAreTheRecommendedEstimatesInSi()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord metre = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        const TypeRecord millimetre = valueOf(library->addType(u"B"_s, {}, u"N"_s, u"mm"_s));
        valueOf(library->addGrasp(aGrasp(metre.id)));
        NewGrasp grasp = aGrasp(millimetre.id);
        grasp.positionUnit = u"mm"_s;
        grasp.estimates[0].parameters = MassDampingStiffness{4e-5, 0.043, 9.99};
        valueOf(library->addGrasp(grasp));
        Estimate failed;
        failed.status = EstimateStatus::TooFewSamples;
        grasp.estimates = {failed};
        valueOf(library->addGrasp(grasp)); // without parameters: not among them
        const auto squeezes = valueOf(library->enrolledSqueezes());
        QCOMPARE(squeezes.size(), std::size_t(2));
        QCOMPARE(squeezes[0].parameters.k, 9990.0);
        QCOMPARE(squeezes[1].type, u"B"_s);
        QCOMPARE(squeezes[1].parameters.k, 9990.0); // QCOMPARE allows the rounding of one product
        QCOMPARE(squeezes[1].parameters.m, 0.04);
    }
    void unitsThatCannotBeComparedAreRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"1"_s, u"1"_s));
        QCOMPARE(library->addGrasp(aGrasp(type.id)).error().code, ErrorCode::UnitsDiffer);
        QCOMPARE(library->addType(u"B"_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::UnitsDiffer);
        NewGrasp grasp = aGrasp(type.id);
        grasp.forceUnit = grasp.positionUnit = u"1"_s;
        valueOf(library->addGrasp(grasp));
        QCOMPARE(valueOf(library->enrolledSqueezes())[0].parameters.k, 9990.0);
    }
    void whatMakesNoSenseIsRefusedAndNothingOfItStored()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        NewGrasp noEstimate = aGrasp(type.id);
        noEstimate.estimates.clear();
        QCOMPARE(library->addGrasp(noEstimate).error().code, ErrorCode::Usage);
        NewGrasp notFinite = aGrasp(type.id);
        notFinite.estimates[1].parameters->k = std::nan("");
        QCOMPARE(library->addGrasp(notFinite).error().code, ErrorCode::Usage);
        NewGrasp uneven = aGrasp(type.id);
        uneven.recording->position.pop_back();
        QCOMPARE(library->addGrasp(uneven).error().code, ErrorCode::Usage);
        QCOMPARE(library->addGrasp(aGrasp(u"nobody"_s)).error().code, ErrorCode::NotFound);
        Recipe recipe;
        recipe.seconds = std::nan("");
        QCOMPARE(library->addType(u"B"_s, recipe, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
        QVERIFY(valueOf(library->grasps(type.id)).empty());
        QCOMPARE(valueOf(library->types()).size(), std::size_t(1));
    }
    void aSqueezeWithoutRecordingSaysSo()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        NewGrasp row = aGrasp(type.id);
        row.recording.reset();
        row.identification = {};
        const GraspRecord added = valueOf(library->addGrasp(row));
        QVERIFY(!added.hasRecording);
        QCOMPARE(library->recording(added.id).error().code, ErrorCode::NotFound);
        QVERIFY(valueOf(library->identificationDocument(added.id)).isEmpty());
        QVERIFY(!valueOf(library->grasp(u"nobody"_s)));
    }
    void theExampleTypesAreThePapersCansInSi()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->loadExampleTypes());
        valueOf(library->loadExampleTypes()); // once is enough
        const auto types = valueOf(library->types());
        QCOMPARE(types.size(), std::size_t(4));
        for (const TypeRecord& type : types) {
            QCOMPARE(type.squeezes, 10);
            QVERIFY(type.approved);
        }
        const auto squeezes = valueOf(library->enrolledSqueezes());
        QCOMPARE(squeezes.size(), std::size_t(40));
        double m = 0, b = 0, k = 0;
        for (int i = 0; i < 10; ++i) {
            m += squeezes[std::size_t(i)].parameters.m / 10;
            b += squeezes[std::size_t(i)].parameters.b / 10;
            k += squeezes[std::size_t(i)].parameters.k / 10;
        }
        // Can A as the virtual gripper has it, to the digits that are stated: 0.0396 kg, 43.0 N s/m, 9,990
        // N/m.
        QVERIFY(std::abs(m - 0.0396) < 0.00005);
        QVERIFY(std::abs(b - 43.0) < 0.05);
        QVERIFY(std::abs(k - 9990) < 5);
    }
};

GRIPSCOPE_TEST(LibraryTest)
#include "library_test.moc"
