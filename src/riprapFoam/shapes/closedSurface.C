// SPDX-License-Identifier: GPL-3.0-or-later

#include "closedSurface.H"
#include "OSspecific.H"
#include "didYouMean.H"
#include "listed.H"

namespace Foam
{

// OpenFOAM's message about a file that is no surface does not name it
static autoPtr<triSurface> readSurface(const dictionary& dict, const fileName& file, scalar scale)
{
    const word type(file.hasExt("gz") ? file.lessExt().ext() : file.ext());
    if (!triSurface::canReadType(type))
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: " << file << " cannot be read as a surface: unknown file extension "
            << type << ", valid are " << listed(triSurface::readTypes().sortedToc()).c_str()
            << exit(FatalIOError);
    }

    autoPtr<triSurface> surface;
    string why;
    const bool before = FatalError.throwExceptions();
    const bool beforeIO = FatalIOError.throwExceptions();
    try
    {
        surface.reset(new triSurface(file, scale));
    }
    catch (const error& e)
    {
        why = e.message();
    }
    FatalError.throwExceptions(before);
    FatalIOError.throwExceptions(beforeIO);

    if (!why.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry file: " << file << " cannot be read as a surface: " << why.c_str()
            << exit(FatalIOError);
    }
    return surface;
}


// Every edge between two triangles, normals outwards
static void close(const dictionary& dict, const fileName& file, autoPtr<triSurface>& surface)
{
    for (const labelList& faces : surface->edgeFaces())
    {
        if (faces.size() == 2) continue;
        FatalIOErrorInFunction(dict)
            << "Entry file: the surface " << file << " is not closed (an edge has " << faces.size()
            << " triangles): it holds no volume" << exit(FatalIOError);
    }

    scalar volume = 0;
    const pointField& p = surface->points();
    for (const labelledTri& t : *surface)
    {
        volume += (p[t[0]] - p[0]) & ((p[t[1]] - p[0]) ^ (p[t[2]] - p[0]));
    }
    if (volume < 0)
    {
        List<labelledTri> faces(*surface);
        for (labelledTri& t : faces) std::swap(t[0], t[1]);
        const pointField points(p);
        surface.reset(new triSurface(faces, points));
    }
}

} // namespace Foam


Foam::autoPtr<Foam::triSurface> Foam::readClosedSurface(checkedDictionary& dict, const Time& time)
{
    dict.found("file");
    const fileName name(dict.dict().get<fileName>("file"));
    const scalar scale = dict.positive("scale", 1);
    const fileName folder(time.globalPath()/time.constant()/"triSurface");
    const fileName file(folder/name);
    if (!isFile(file))
    {
        fileNameList there(readDir(folder, fileName::FILE));
        Foam::sort(there);
        FatalIOErrorInFunction(dict.dict())
            << "Entry file: there is no " << file << "; constant/triSurface holds "
            << listedFor(name, there).c_str() << exit(FatalIOError);
    }
    autoPtr<triSurface> surface(readSurface(dict.dict(), file, scale));
    if (surface->empty())
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry file: " << file << " holds no triangles" << exit(FatalIOError);
    }
    close(dict.dict(), file, surface);
    return surface;
}
