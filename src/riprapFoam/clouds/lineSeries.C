/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lineSeries.H"
#include "Pstream.H"
#include "OSspecific.H"
#include "SortableList.H"
#include "timeWriter.H"
#include <fstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Made anew from what is there: a run that was continued has earlier files
static void writeSeries(const fileName& folder, const word& name)
{
    const std::string head(name + "_");
    const std::string tail(".vtp");

    DynamicList<fileName> files;
    DynamicList<scalar> times;
    for (const fileName& file : readDir(folder/name, fileName::FILE))
    {
        scalar t = 0;
        if
        (
            file.size() > head.size() + tail.size()
         && file.starts_with(head)
         && file.ends_with(tail)
         && readScalar(file.substr(head.size(), file.size() - head.size() - tail.size()), t)
        )
        {
            files.append(file);
            times.append(t);
        }
    }

    const fileName series(folder/name + ".vtp.series");
    std::ofstream os(series);
    os.precision(12);
    os  << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n";
    const SortableList<scalar> order(times);
    forAll(order, i)
    {
        os  << "    { \"name\" : \"" << std::string(name) << '/'
            << std::string(files[order.indices()[i]]) << "\", \"time\" : "
            << order[i] << " }" << (i + 1 < order.size() ? ",\n" : "\n");
    }
    os  << "  ]\n}\n";
    os.flush();
    if (!os.good()) throw std::runtime_error("Cannot write " + series + ": is the disk full?");
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::endOfLine
(
    DynamicList<point>& points,
    const label a,
    const label b,
    const vector& way
)
{
    if (points[b] - points[a] == way) return b;
    points.append(points[a] + way);
    return points.size() - 1;
}


void Foam::writeLineSeries
(
    const Time& time,
    const word& name,
    const pointField& points,
    const edgeList& lines,
    const lineFields& fields
)
{
    // Each process has them all
    if (!Pstream::master() || timeWriter::ofRun().onTrial()) return;

    const fileName folder(time.globalPath()/"VTK");
    const fileName file(folder/name/(name + '_' + time.timeName() + ".vtp"));
    mkDir(file.path());
    timeWriter::ofRun().put
    (
        [folder, name, file, points, lines, fields]()
        {
            writePolyLines
            (
                file, points, lines, fields.labels, fields.scalars, fields.vectors
            );
            writeSeries(folder, name);
        }
    );
}


// ************************************************************************* //
