// SPDX-License-Identifier: GPL-3.0-or-later
/*  A case with the files that a solver module reads, and a mesh made in memory. */
#pragma once

#include "boxMesh.hpp"
#include "scratchCase.hpp"

struct ParticleCase : ScratchCase
{
    Foam::autoPtr<Foam::polyMesh> mesh;

    ParticleCase(const BoxMesh& box, const std::string& control = "",
        const char* gravity = "(0 0 -10)")
    :
        ScratchCase(control)
    {
        write("constant/g", std::string("FoamFile { version 2.0; format ascii; class "
                                        "uniformDimensionedVectorField; object g; }\n"
                                        "dimensions [0 1 -2 0 0 0 0]; value ")
                + gravity + ";\n");
        writeDict("constant/fluidProperties", "rho 1000; nu 1e-6;");
        mesh = box.make(time());
    }
};
