/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenFile.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::writtenFile::writtenFile
(
    const IOobject& io,
    const word& className,
    const Time& time
)
:
    writtenFile(io, className, time.writeFormat(), time.writeCompression())
{}


Foam::writtenFile::writtenFile
(
    const IOobject& io,
    const word& className,
    IOstream::streamFormat format,
    IOstream::compressionType compression
)
:
    path_(io.objectPath()),
    compression_(compression),
    format_{format, int(IOstream::defaultPrecision())}
{
    addWritten([&](Ostream& os) { io.writeHeader(os, className); });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::writtenFile::add(std::string text)
{
    bodies_.emplace_back
    (
        [text = std::move(text)](fileSink& sink, const listFormat&)
        {
            sink.write(text);
        }
    );
}


Foam::fileSum Foam::writtenFile::writeTo(fileSink& sink) const
{
    static const std::string end =
        "\n\n// ************************************************************"
        "************* //\n";

    for (const fileBody& body : bodies_)
    {
        body(sink, format_);
    }
    sink.write(end);
    return sink.close();
}


Foam::fileSum Foam::writtenFile::write(int threads) const
{
    fileSink sink(path_, compression_, threads);
    return writeTo(sink);
}


Foam::fileSum Foam::writtenFile::formatOnly(int threads) const
{
    fileSink sink(threads);
    return writeTo(sink);
}


// ************************************************************************* //
