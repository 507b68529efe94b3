/*  SPDX-License-Identifier: GPL-3.0-or-later  */
#include "stirredBlock.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace riprap;

int main(int argc, char** argv)
{
    // scratch: kind force rigid ratio [duration] [courant] [young] [damping]
    StirredBlock b;
    b.kind = CouplingKind(std::atoi(argv[1]));
    b.force = FluidForceKind(std::atoi(argv[2]));
    b.rigid = std::atoi(argv[3]);
    if (argc > 5) b.duration = std::atof(argv[5]);
    if (argc > 6) b.courant = std::atof(argv[6]);
    if (argc > 7) b.young = std::atof(argv[7]);
    if (argc > 8) b.dampingRatio = std::atof(argv[8]);
    char* list = argv[4];
    for (char* w = std::strtok(list, ","); w; w = std::strtok(nullptr, ","))
    {
        b.densityRatio = std::atof(w);
        const StirredResult r = stir(b);
        std::printf("kind %d force %d rigid %d ratio %g: stopped %d energy %.4f end %.4f solids %.4f K %d inside %d steps %lld\n", int(b.kind), int(b.force), b.rigid,
            b.densityRatio, r.stopped, r.energy, r.end, r.solids, r.subcycles, r.inside, (long long)r.steps);
        std::fflush(stdout);
    }
}
