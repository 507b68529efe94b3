// SPDX-License-Identifier: GPL-3.0-or-later
/*  A scene's cloud, whose files another thread may make while the scene moves on: the same bytes as
    those that are written at once. */

#include "boxMesh.hpp"
#include "scratchCase.hpp"
#include "sceneCloud.H"
#include "timeWriter.H"

#include <gtest/gtest.h>
#include <map>
#include <random>

using namespace Foam;

namespace
{
    //- Its scene is a cloud that the test moves on
    class ScriptedCloud : public sceneCloud
    {
        void fill(particleCloud& p) const override
        {
            ++filled;
            take(scene, p);
        }

        std::function<void(particleCloud&)> fillLater(
            particleCloud& names, label& size) const override
        {
            take(particleCloud(), names);
            size = scene.size();
            return [this, now = scene](particleCloud& p)
            {
                ++filledLater;
                take(now, p);
            };
        }

        static void take(const particleCloud& from, particleCloud& p)
        {
            p.position = from.position;
            p.labels.set("id", from.labels.lookup("id", labelField()));
            p.vectors.set("U", from.vectors.lookup("U", vectorField()));
        }

        void addProperties(dictionary& properties) const override
        {
            properties.add("spacing", 0.5);
        }

        void writeState(bool) const override {}

    public:

        particleCloud scene;
        mutable int filled = 0;
        mutable std::atomic<int> filledLater{0};

        using sceneCloud::sceneCloud;

        wordList stateFiles() const override { return wordList(); }

        //- n of them, in no order of ids; some outside the mesh
        void set(label n, unsigned seed)
        {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> in(-0.05, 1.05);
            scene = particleCloud("fluid", n);
            labelField id(n);
            vectorField U(n);
            forAll(id, i)
            {
                scene.position[i] = point(in(random), in(random), in(random));
                id[i] = (7*i + 3) % n;
                U[i] = vector(in(random), in(random), in(random));
            }
            scene.labels.set("id", id);
            scene.vectors.set("U", U);
            moved();
        }
    };

    using Files = std::map<std::string, std::string>;

    Files filesOf(const ScratchCase& c, const std::string& time)
    {
        Files all;
        for (const char* name : {"positions", "id", "U"})
            all[name] = c.read(time + "/lagrangian/fluid/" + name);
        all["cloudProperties"] = c.read(time + "/uniform/lagrangian/fluid/cloudProperties");
        return all;
    }

    //- The files of a cloud of this block, written so; later: by threads, while it moves on
    Files written(const std::string& format, bool later, label n, bool graded = false)
    {
        ScratchCase c(format);
        BoxMesh box;
        for (int d = 0; d < 3; ++d) box.divide(d, 0, 1, 4);
        if (graded) box.nodes[0][1] = 0.3;
        const auto mesh = box.make(c.time());
        ScriptedCloud cloud(mesh(), "fluid");
        cloud.set(n, 5);
        timeWriter& writer = timeWriter::ofRun();
        testing::internal::CaptureStdout();
        writer.freeCores(later);
        writer.begin(c.path()/"0", later);
        cloud.write();
        cloud.set(n, 6);
        writer.finish(fileNameList());
        writer.wait();
        writer.freeCores(false);
        const std::string said(testing::internal::GetCapturedStdout());
        EXPECT_EQ(cloud.filledLater, later && !graded ? 1 : 0) << format << ' ' << n;
        EXPECT_EQ(cloud.filled, later && !graded ? 0 : 1) << format << ' ' << n;
        EXPECT_TRUE(holds(said, "Written 0: " + std::to_string(n) + " particles")) << said;
        EXPECT_EQ(holds(said, "outside the mesh"), n > 0) << said;
        return filesOf(c, "0");
    }
}

TEST(SceneCloud, sameFilesLater)
{
    for (const char* format : {"writeFormat binary;", "writeFormat ascii; writePrecision 17;"})
        for (const label n : {0, 1000, 40000})
        {
            const Files now(written(format, false, n)), later(written(format, true, n));
            for (const auto& file : now)
            {
                EXPECT_FALSE(file.second.empty()) << file.first;
                EXPECT_TRUE(file.second == later.at(file.first))
                    << format << ' ' << n << ' ' << file.first;
            }
        }
}

//- Where the cells of particles are found by other ways, they are found at once
TEST(SceneCloud, graded)
{
    const Files now(written("writeFormat binary;", false, 1000, true)),
        later(written("writeFormat binary;", true, 1000, true));
    EXPECT_TRUE(now == later);
}
