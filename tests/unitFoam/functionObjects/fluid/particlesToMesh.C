// SPDX-License-Identifier: GPL-3.0-or-later
/*  Particles as fields on the mesh: values, files, owners. */

#include "runningFluid.hpp"
#include "volFields.H"

using namespace Foam;

namespace
{
    const Water pool{point(0, 0, 0), point(1, 0.5, 0.5), vector(0.3, 0, -0.1), 0.5};

    struct PoolRun : RunningSph
    {
        explicit PoolRun(int D = 2, const std::string& control = "")
        :
            RunningSph(tank(D, 1, 1, 10, 0.5), "maxVelocity 3;", "deltaT 0.001; " + control)
        {
            start(0.05, {pool});
        }

        template<class Type>
        const GeometricField<Type, fvPatchField, volMesh>& field(const char* name) const
        {
            return mesh->lookupObject<GeometricField<Type, fvPatchField, volMesh>>(name);
        }

        bool there(const std::string& file) const { return isFile(path()/file); }
    };
}

TEST(ParticlesToMesh, values)
{
    for (const int D : {2, 3})
    {
        PoolRun run(D);
        const auto f = run.make("particlesToMesh");
        const auto& p = run.field<scalar>("p");
        const auto& U = run.field<vector>("U");
        const auto& alpha = run.field<scalar>("alpha.water");
        forAll(p, c)
        {
            const point& x = run.mesh->C()[c];
            const bool inside = x.z() < 0.4, dry = x.z() > 0.6;
            const bool away = x.x() > 0.1 && x.x() < 0.9 && x.z() > 0.1
                && (D == 2 || (x.y() > 0.1 && x.y() < 0.4));
            if (inside)
            {
                EXPECT_NEAR(p[c], 1e4*(0.5 - x.z()), away ? 1 : 150) << c;
                EXPECT_NEAR(alpha[c], 1, 0.03) << c;
                EXPECT_NEAR(mag(U[c] - vector(0.3, 0, -0.1)), 0, 1e-5) << c;
            }
            if (dry)
            {
                EXPECT_EQ(p[c], 0) << c;
                EXPECT_EQ(alpha[c], 0) << c;
                EXPECT_EQ(mag(U[c]), 0) << c;
            }
        }
        // patches have the value of their cells
        const auto& floor = p.boundaryField()[run.mesh->boundaryMesh().findPatchID("zMin")];
        const scalarField above(floor.patchInternalField());
        forAll(floor, i) EXPECT_EQ(floor[i], above[i]);
    }
}

//- What is there at the start stays; the run's write times, or the object's own
TEST(ParticlesToMesh, files)
{
    PoolRun run(2, "writeInterval 2; writePrecision 12;");
    run.write("0/U", "mine");
    const auto f = run.make("particlesToMesh", "fields (U alpha.water);");
    EXPECT_EQ(run.read("0/U"), "mine");
    EXPECT_FALSE(run.there("0/p"));
    EXPECT_TRUE(run.there("0/alpha.water"));
    EXPECT_FALSE(run.mesh->foundObject<regIOobject>("p"));
    run.step();
    FluidCase::sample(*f);
    EXPECT_FALSE(run.there("0.001/U"));
    run.step();
    FluidCase::sample(*f);
    const volVectorField read(
        IOobject("U", "0.002", run.mesh(), IOobject::MUST_READ, IOobject::NO_WRITE, false),
        run.mesh());
    const auto& U = run.field<vector>("U");
    EXPECT_NEAR(max(mag(U.primitiveField())), std::sqrt(0.1), 0.05);
    forAll(U, c) EXPECT_NEAR(mag(read[c] - U[c]), 0, 1e-11) << c;
    EXPECT_EQ(read.dimensions(), dimVelocity);
    // at its own times
    const auto g = run.make("particlesToMesh", "fields (p); writeControl timeStep;", "g");
    run.step();
    FluidCase::sample(*g);
    EXPECT_TRUE(run.there("0.003/p"));
    EXPECT_FALSE(run.there("0.003/U"));
}

//- Fluid thinner than the least fraction has no pressure
TEST(ParticlesToMesh, leastFraction)
{
    PoolRun run;
    const auto f = run.make("particlesToMesh", "minVolumeFraction 1;");
    const auto& p = run.field<scalar>("p");
    const auto& alpha = run.field<scalar>("alpha.water");
    forAll(p, c) EXPECT_EQ(p[c] > 0, alpha[c] == 1) << c;
    f->read(run.entriesOf("particlesToMesh", "fields (p);"));
    f->execute();
    EXPECT_NEAR(p[25], 1e4*0.25, 1);
    EXPECT_FALSE(run.mesh->foundObject<regIOobject>("alpha.water"));
}

TEST(ParticlesToMesh, fieldsOfOthers)
{
    PoolRun run;
    const volScalarField own(IOobject("p", "0", run.mesh(), IOobject::NO_READ, IOobject::NO_WRITE),
        run.mesh(), dimensionedScalar("p", dimPressure, 3));
    EXPECT_EQ(run.said("particlesToMesh"),
        "Function object f of type particlesToMesh: the mesh has a field p of another owner "
        "already. "
        "Leave it out of entry fields");
    const auto f = run.make("particlesToMesh", "fields (U);");
    EXPECT_EQ(own[0], 3);

    RunningPic pic(tank(2, 1, 1, 10));
    pic.start(0.05, {pool});
    testing::internal::CaptureStdout();
    const auto g = pic.make("particlesToMesh");
    FluidCase::sample(*g);
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
        "particlesToMesh f: the fields are the solver's own, there is nothing to do\n\n");
    EXPECT_FALSE(pic.mesh->foundObject<regIOobject>("U"));
}
