// SPDX-License-Identifier: GPL-3.0-or-later
/*  VTK XML polydata, base64 inline: points with fields, one vertex a point; or lines with fields.
    */

#include "particleCloudIO.H"
#include "foamVtkOutput.H"
#include "OSspecific.H"

#include <fstream>
#include <stdexcept>

namespace Foam
{

template<class T>
static void writeArrays(vtk::formatter& format, const HashTable<Field<T>>& fields)
{
    for (const word& name : fields.sortedToc())
    {
        const Field<T>& values = fields[name];
        if (std::is_integral<typename pTraits<T>::cmptType>::value)
        {
            format.beginDataArray<label>(name);
            format.writeSize(vtk::sizeofData<label>(values.size()));
        }
        else
        {
            format.beginDataArray<float, pTraits<T>::nComponents>(name);
            format.writeSize(vtk::sizeofData<float, pTraits<T>::nComponents>(values.size()));
        }
        vtk::writeList(format, values);
        format.flush();
        format.endDataArray();
    }
}


static void writeVertices(vtk::formatter& format, label n)
{
    const uint64_t payLoad = vtk::sizeofData<label>(n);

    format.tag(vtk::fileTag::VERTS);
    for (const bool offsets : {false, true})
    {
        format.beginDataArray<label>
        (
            offsets ? vtk::dataArrayAttr::OFFSETS : vtk::dataArrayAttr::CONNECTIVITY
        );
        format.writeSize(payLoad);
        vtk::writeIdentity(format, n, offsets ? 1 : 0);
        format.flush();
        format.endDataArray();
    }
    format.endTag(vtk::fileTag::VERTS);
}


static void writeLineEnds(vtk::formatter& format, const edgeList& lines)
{
    format.tag(vtk::fileTag::LINES);
    format.beginDataArray<label>(vtk::dataArrayAttr::CONNECTIVITY);
    format.writeSize(vtk::sizeofData<label>(2*lines.size()));
    for (const edge& line : lines)
    {
        format.write(line.start());
        format.write(line.end());
    }
    format.flush();
    format.endDataArray();

    format.beginDataArray<label>(vtk::dataArrayAttr::OFFSETS);
    format.writeSize(vtk::sizeofData<label>(lines.size()));
    forAll(lines, i)
    {
        format.write(label(2*(i + 1)));
    }
    format.flush();
    format.endDataArray();
    format.endTag(vtk::fileTag::LINES);
}


static void writePoints(vtk::formatter& format, const pointField& points)
{
    format.tag(vtk::fileTag::POINTS).beginDataArray<float, 3>(vtk::dataArrayAttr::POINTS);
    format.writeSize(vtk::sizeofData<float, 3>(points.size()));
    vtk::writeList(format, points);
    format.flush();
    format.endDataArray();
    format.endTag(vtk::fileTag::POINTS);
}


// A file of one piece: its points, `cells` and `fields` by the caller
template<class Cells, class Fields>
static void writePiece
(
    const fileName& file,
    const pointField& points,
    const vtk::fileAttr kind,
    label n,
    const Cells& cells,
    const Fields& fields
)
{
    if (!isDir(file.path())) mkDir(file.path());
    std::ofstream os(file);
    autoPtr<vtk::formatter> formatter(vtk::newFormatter(os, vtk::formatType::INLINE_BASE64));
    vtk::formatter& format = *formatter;

    format.xmlHeader().beginVTKFile<vtk::fileTag::POLY_DATA>();
    format.tag(vtk::fileTag::PIECE, vtk::fileAttr::NUMBER_OF_POINTS, points.size(), kind, n);
    writePoints(format, points);
    cells(format);
    fields(format);
    format.endPiece();
    format.endTag(vtk::fileTag::POLY_DATA).endVTKFile();

    // what a full disk does not take is known when all has left the buffer
    os.flush();
    if (!os.good())
    {
        // Maybe in a thread of its own
        throw std::runtime_error("Cannot write " + file + ": is the disk full?");
    }
}

} // namespace Foam


void Foam::writePolyData
(
    const fileName& file,
    const pointField& points,
    const HashTable<labelField>& labels,
    const HashTable<scalarField>& scalars,
    const HashTable<vectorField>& vectors
)
{
    const label n = points.size();
    writePiece
    (
        file, points, vtk::fileAttr::NUMBER_OF_VERTS, n,
        [&](vtk::formatter& format) { writeVertices(format, n); },
        [&](vtk::formatter& format)
        {
            format.beginPointData();
            writeArrays(format, labels);
            writeArrays(format, scalars);
            writeArrays(format, vectors);
            format.endPointData();
        }
    );
}


void Foam::writePolyLines
(
    const fileName& file,
    const pointField& points,
    const edgeList& lines,
    const HashTable<labelField>& labels,
    const HashTable<scalarField>& scalars,
    const HashTable<vectorField>& vectors
)
{
    writePiece
    (
        file, points, vtk::fileAttr::NUMBER_OF_LINES, lines.size(),
        [&](vtk::formatter& format) { writeLineEnds(format, lines); },
        [&](vtk::formatter& format)
        {
            format.beginCellData();
            writeArrays(format, labels);
            writeArrays(format, scalars);
            writeArrays(format, vectors);
            format.endCellData();
        }
    );
}
