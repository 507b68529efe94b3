// SPDX-License-Identifier: GPL-3.0-or-later
/*  source surface;  file "drop.stl";       // closed, in constant/triSurface; optional: scale 0.001; */

#include "addToRunTimeSelectionTable.H"
#include "particleSource.H"
#include "triSurface.H"
#include "triSurfaceSearch.H"
#include "OSspecific.H"
#include "listed.H"

namespace Foam
{

class surfaceSource
:
    public volumeSource
{
    autoPtr<triSurface> surface_;
    autoPtr<triSurfaceSearch> search_;

    // Every edge between two triangles, normals outwards
    void close(const dictionary& dict, const fileName& file)
    {
        for (const labelList& faces : surface_->edgeFaces())
        {
            if (faces.size() == 2) continue;
            FatalIOErrorInFunction(dict)
                << "Entry file: the surface " << file << " is not closed (an edge has " << faces.size()
                << " triangles): it holds no volume" << exit(FatalIOError);
        }

        scalar volume = 0;
        const pointField& p = surface_->points();
        for (const labelledTri& t : *surface_)
        {
            volume += (p[t[0]] - p[0]) & ((p[t[1]] - p[0]) ^ (p[t[2]] - p[0]));
        }
        if (volume < 0)
        {
            List<labelledTri> faces(*surface_);
            for (labelledTri& t : faces) std::swap(t[0], t[1]);
            const pointField points(p);
            surface_.reset(new triSurface(faces, points));
        }
    }

public:

    TypeName("surface");

    surfaceSource(checkedDictionary& dict, const Time& time)
    {
        dict.found("file");
        const fileName name(dict.dict().get<fileName>("file"));
        const scalar scale = dict.positive("scale", 1);
        const fileName file(time.path()/time.constant()/"triSurface"/name);
        if (!isFile(file))
        {
            fileNameList there(readDir(file.path(), fileName::FILE));
            Foam::sort(there);
            FatalIOErrorInFunction(dict.dict())
                << "Entry file: there is no " << file << "; constant/triSurface holds " << listed(there).c_str()
                << exit(FatalIOError);
        }
        surface_.reset(new triSurface(file, scale));
        if (surface_->empty())
        {
            FatalIOErrorInFunction(dict.dict())
                << "Entry file: " << file << " holds no triangles" << exit(FatalIOError);
        }
        close(dict.dict(), file);
        search_.reset(new triSurfaceSearch(*surface_));
    }

    virtual boundBox bounds() const { return boundBox(surface_->points(), false); }

    virtual boolList inside(const pointField& points) const { return search_->calcInside(points); }
};

defineTypeNameAndDebug(surfaceSource, 0);
addToRunTimeSelectionTable(particleSource, surfaceSource, dictionary);

} // namespace Foam
