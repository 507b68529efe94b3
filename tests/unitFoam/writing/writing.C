// SPDX-License-Identifier: GPL-3.0-or-later
/*  Files of a time that are written while the run goes on: the same bytes as OpenFOAM's own writing
    gives, states of any size, and failures that are told. */

#include "foamVersions/foamVersions.H"
#include "IOField.H"
#include "labelField.H"
#include "labelIOList.H"
#include "OSspecific.H"
#include "sceneState.H"
#include "scratchCase.hpp"
#include "timeWriter.H"
#include "vectorField.H"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <sstream>
#include <thread>

using namespace Foam;

//- A time sets the digits of all streams
struct Writing : testing::Test
{
    void TearDown() override { defaultDigits(); }
};

namespace
{
    //- Of this program's own; it goes with it
    struct Scratch
    {
        fileName folder;

        Scratch()
        {
            char name[] = "/tmp/unitTestsFoamXXXXXX";
            folder = mkdtemp(name);
        }

        ~Scratch() { rmDir(folder); }
    };

    const Scratch scratch;

    //- A time in it, in this format
    autoPtr<Time> timeOf(const std::string& format, const std::string& compression = "off")
    {
        autoPtr<Time> time(
            new Time(entries("startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT "
                             "1; writeControl timeStep; writeInterval 1; writeFormat "
                         + format + "; writeCompression " + compression + "; writePrecision 9;"),
                scratch.folder, "case", "system", "constant", false));
        return time;
    }

    std::string bytes(const fileName& path)
    {
        std::ifstream in(path, std::ios::binary);
        std::ostringstream all;
        all << in.rdbuf();
        return all.str();
    }

    IOobject object(const Time& time, const word& name)
    {
        return IOobject(name, time.timeName(), "lagrangian/fluid", time, IOobject::NO_READ,
            IOobject::NO_WRITE, false);
    }

    template<class T>
    void sameFile(const Field<T>& values)
    {
        for (const char* format : {"ascii", "binary"})
        {
            for (const char* compression : {"off", "on"})
            {
                // OpenFOAM compresses no binary files
                if (std::string(format) == "binary" && std::string(compression) == "on") continue;
                const autoPtr<Time> time(timeOf(format, compression));
                const fileName path(object(time(), "values").objectPath()
                    + (compression == std::string("on") ? ".gz" : ""));
                IOField<T>(object(time(), "values"), values).write();
                const std::string expected = bytes(path);
                ASSERT_TRUE(rm(path));
                for (const int threads : {1, 3})
                {
                    writtenFile file(object(time(), "values"), IOField<T>::typeName, time());
                    file.add(listBody(Field<T>(values)));
                    const fileSum sum(file.write(threads));
                    EXPECT_GT(expected.size(), 100u);
                    EXPECT_EQ(bytes(path), expected)
                        << format << ' ' << values.size() << ' ' << threads;
                    EXPECT_EQ(sum.bytes,
                        compression == std::string("off") ? int64_t(expected.size()) : -1);
                }
            }
        }
    }

    //- Finite numbers of all sizes
    std::vector<scalar> numbers(std::size_t n)
    {
        std::mt19937_64 random(7);
        std::vector<scalar> values{0, -0.0, 1, 1e-5, 1e-4, 123456, 1234567, 999999.5, 0.1, 2.5,
            1e22, std::numeric_limits<scalar>::max()};
        while (values.size() < n)
        {
            const uint64_t bits = random();
            scalar value;
            std::memcpy(&value, &bits, sizeof(value));
            if (std::isfinite(value)) values.push_back(value);
            values.push_back(scalar(int64_t(random()))*std::pow(10.0, int(random() % 12) - 24));
        }
        values.resize(n);
        return values;
    }

    std::vector<std::int32_t> words(std::size_t n)
    {
        std::vector<std::int32_t> words(n);
        std::mt19937 random(3);
        for (auto& w : words) w = std::int32_t(random());
        return words;
    }

    std::string thrown(const std::function<void()>& f)
    {
        const bool before = FatalError.throwExceptions(), ioBefore = FatalIOError.throwExceptions();
        std::string said;
        try { f(); }
        catch (const error& e) { said = e.message(); }
        FatalError.throwExceptions(before);
        FatalIOError.throwExceptions(ioBefore);
        return said;
    }
}

TEST_F(Writing, numbersAreThoseOfAStream)
{
    std::vector<scalar> values(numbers(20000));
    values.push_back(std::numeric_limits<scalar>::infinity());
    values.push_back(-std::numeric_limits<scalar>::infinity());
    values.push_back(std::numeric_limits<scalar>::quiet_NaN());
    for (const int precision : {1, 6, 10, 17, 40})
    {
        std::vector<char> text(riprap::numberSize(precision));
        for (const scalar v : values)
        {
            std::ostringstream os;
            os.precision(precision);
            os << v;
            ASSERT_EQ(
                std::string(text.data(), riprap::putNumber(text.data(), v, precision)), os.str());
        }
    }
}

TEST_F(Writing, listsAreTheBytesOfOpenFOAM)
{
    for (const label n : {0, 1, 2, 10, 11, 100000})
    {
        const std::vector<scalar> x(numbers(3*n + 1));
        scalarField scalars(n);
        vectorField vectors(n);
        labelField labels(n);
        forAll(scalars, i)
        {
            scalars[i] = x[i];
            vectors[i] = vector(x[3*i], x[3*i + 1], x[3*i + 2]);
            labels[i] = label(i*2654435761u);
        }
        sameFile(scalars);
        sameFile(vectors);
        sameFile(labels);
        sameFile(scalarField(n, 0.25));
        sameFile(vectorField(n, vector(1, 2, 3)));
    }
}

//- Number, hash, words; long states are read with the hash that they once had, too
TEST_F(Writing, stateIsTheListItWas)
{
    const autoPtr<Time> time(timeOf("ascii"));
    for (const std::size_t n : {100000, 1000000})
    {
        const std::vector<std::int32_t> given(words(n));
        writeStateWords(time(), "state", riprap::knownWords(given));
        const std::string written = bytes(stateObject(time(), "state").objectPath());
        EXPECT_EQ(readStateWords(time(), "state"), given);

        labelIOList file(stateObject(time(), "state"), label(given.size()) + 2);
        file[0] = given.size();
        file[1] = label(Hasher(given.data(), given.size()*sizeof(given[0]), 0));
        std::copy(given.begin(), given.end(), file.begin() + 2);
        writeUncompressed(file, IOstream::BINARY);
        EXPECT_EQ(written == bytes(file.objectPath()), n < 200000);
        EXPECT_EQ(readStateWords(time(), "state"), given);
        file[1] += 1;
        writeUncompressed(file, IOstream::BINARY);
        EXPECT_NE(thrown([&]() { readStateWords(time(), "state"); }).find("its check sum is wrong"),
            std::string::npos);
    }
}

TEST_F(Writing, moreWordsThanAListHoldsAreSeveralLists)
{
    const autoPtr<Time> time(timeOf("ascii"));
    const std::size_t before = stateListSize;
    stateListSize = 100;
    for (const std::size_t n : {98, 99, 100, 101, 200, 1234})
    {
        const std::vector<std::int32_t> given(words(n));
        writeStateWords(time(), "long", riprap::knownWords(given));
        EXPECT_EQ(readStateWords(time(), "long"), given) << n;
    }
    stateListSize = before;

    // One bit is wrong
    const fileName path(stateObject(time(), "long").objectPath());
    std::string text(bytes(path));
    text[text.size()/2] ^= 4;
    std::ofstream(path, std::ios::binary) << text;
    EXPECT_NE(thrown([&]() { readStateWords(time(), "long"); }).find("its check sum is wrong"),
        std::string::npos);
}

TEST_F(Writing, aTimeIsWholeWhenItsLastFileIs)
{
    for (const bool later : {true, false})
    {
        autoPtr<Time> time(timeOf("ascii"));
        const fileName path(time().path()/(later ? "1" : "2"));
        timeWriter& writer = timeWriter::ofRun();
        writer.begin(path, later);
        EXPECT_TRUE(isFile(path/"uniform/riprap/manifest.part"));
        time.ref().setTime(later ? 1 : 2, 1);
        for (const char* name : {"a", "b"})
        {
            writtenFile file(object(time(), name), IOField<scalar>::typeName, time());
            file.add(listBody(scalarField(100000, 0.5)));
            writer.put(std::move(file));
        }
        mkDir(scratch.folder/"old");
        writer.finish(fileNameList(1, scratch.folder/"old"));
        writer.wait();
        EXPECT_FALSE(isDir(scratch.folder/"old"));
        EXPECT_FALSE(isFile(path/"uniform/riprap/manifest.part"));
        const timeManifest& manifest(timeManifest::of(path));
        EXPECT_EQ(int(manifest.is), int(timeManifest::kind::whole));
        EXPECT_TRUE(manifest.changed.empty());
    }
}

//- Where cores are free. What writes files of its own waits for those before it, and others for it
TEST_F(Writing, severalFilesAtOnce)
{
    const int before = timeWriter::threadsBeside;
    timeWriter::threadsBeside = 4;
    timeWriter& writer = timeWriter::ofRun();
    writer.freeCores(true);
    autoPtr<Time> time(timeOf("ascii"));
    time.ref().setTime(6, 6);
    const fileName path(time().path()/"6");
    std::atomic<int> now{0}, most{0}, done{0};
    const auto put = [&](const word& name, label n)
    {
        writtenFile file(object(time(), name), IOField<scalar>::typeName, time());
        file.add([&](fileSink&, const listFormat&)
        {
            most = std::max(int(most), ++now);
            // until others have come, or never will
            for (int k = 0; k < 200 && most < 3; ++k)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        });
        scalarField values(n);
        forAll(values, i) values[i] = i + 0.25*n;
        file.add(listBody(std::move(values)));
        file.add([&](fileSink&, const listFormat&) { --now; ++done; });
        writer.put(std::move(file));
    };
    int alone = -1, doneThen = -1;
    writer.begin(path, true);
    for (label k = 0; k < 7; ++k) put("first" + Foam::name(k), 20000 - 2500*k);
    writer.put(timeWriter::job([&]() { alone = now; doneThen = done; }));
    for (label k = 0; k < 5; ++k) put("second" + Foam::name(k), 40000);
    writer.finish(fileNameList());
    writer.wait();
    EXPECT_GE(most, 3);
    EXPECT_LE(most, 4);
    EXPECT_EQ(alone, 0);
    EXPECT_EQ(doneThen, 7);
    EXPECT_EQ(done, 12);
    EXPECT_EQ(int(timeManifest::of(path).is), int(timeManifest::kind::whole));
    EXPECT_TRUE(timeManifest::of(path).changed.empty());
    const std::string together(bytes(object(time(), "second1").objectPath()));
    writer.begin(path, false);
    put("second1", 40000);
    writer.finish(fileNameList());
    EXPECT_EQ(bytes(object(time(), "second1").objectPath()), together);

    writer.begin(path, true);
    for (label k = 0; k < 4; ++k) put("first" + Foam::name(k), 1000);
    const std::string said = thrown([&]()
    {
        writer.put(timeWriter::job([]() { throw std::runtime_error("no disk"); }));
        writer.finish(fileNameList());
        writer.wait();
    });
    EXPECT_NE(said.find("no disk"), std::string::npos) << said;
    EXPECT_FALSE(isFile(path/"uniform/riprap/manifest"));
    writer.freeCores(false);
    timeWriter::threadsBeside = before;
}

TEST_F(Writing, whatFailsIsTold)
{
    const autoPtr<Time> time(timeOf("ascii"));
    for (const bool later : {true, false})
    {
        timeWriter& writer = timeWriter::ofRun();
        writer.begin(time().path()/"3", later);
        const std::string said = thrown(
            [&]()
            {
                writtenFile file(
                    IOobject("full", "/dev", time(), IOobject::NO_READ, IOobject::NO_WRITE, false),
                    "scalarField", time());
                file.add(listBody(scalarField(100000, 0.5)));
                writer.put(std::move(file));
                writer.finish(fileNameList());
                writer.wait();
            });
        EXPECT_NE(said.find("/dev/full cannot be written: is the disk full? This time is not "
                            "whole, earlier ones are"),
            std::string::npos)
            << said;
        EXPECT_TRUE(isFile(time().path()/"3/uniform/riprap/manifest.part"));
        EXPECT_FALSE(isFile(time().path()/"3/uniform/riprap/manifest"));
    }
}

TEST_F(Writing, aTimeWithoutARequiredFileFails)
{
    for (const bool later : {true, false})
    {
        autoPtr<Time> time(timeOf("ascii"));
        const fileName path(time().path()/(later ? "4" : "5"));
        time.ref().setTime(later ? 4 : 5, 1);
        const auto write = [&](const fileNameList& required)
        {
            timeWriter& writer = timeWriter::ofRun();
            writer.begin(path, later);
            writtenFile file(object(time(), "a"), IOField<scalar>::typeName, time());
            file.add(listBody(scalarField(100, 0.5)));
            writer.put(std::move(file));
            writer.finish(fileNameList(1, scratch.folder/"older"), false, required);
            writer.wait();
        };
        mkDir(scratch.folder/"older");
        const fileName there(object(time(), "a").objectPath().substr(path.size() + 1));
        const std::string said = thrown(
            [&]() {
                write(fileNameList({there, fileName("uniform/riprap/state")}));
            });
        EXPECT_NE(
            said.find("has been written without its file uniform/riprap/state"), std::string::npos)
            << said;
        EXPECT_FALSE(isFile(path/"uniform/riprap/manifest"));
        EXPECT_TRUE(isDir(scratch.folder/"older"));

        EXPECT_EQ(thrown([&]() { write(fileNameList({there})); }), "");
        EXPECT_TRUE(isFile(path/"uniform/riprap/manifest"));
        EXPECT_FALSE(isDir(scratch.folder/"older"));
    }
}
