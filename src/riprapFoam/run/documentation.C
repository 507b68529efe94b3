/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "documentation.H"
#include "CStringList.H"
#include "debug.H"
#include "dictionary.H"
#include "IOstreams.H"
#include "OSspecific.H"
#include "stringOps.H"
#include <cstdlib>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The site that etc/makeDocs has built, else the text
static fileName pageOf(const fileName& page)
{
    const fileName top(getEnv("RIPRAP_DIR"));
    const fileName site(top/"platforms/docs"/(page + ".html"));
    return isFile(site) ? site : top/(page + ".md");
}


static int show(const fileName& file)
{
    if (!isFile(file))
    {
        Info<< nl << "No documentation: there is no file " << file
            << ". RIPRAP_DIR must be riprap's folder (source its etc/bashrc)"
            << nl << endl;
        return 1;
    }

    string browser(getEnv("FOAM_DOC_BROWSER"));
    if (browser.empty())
    {
        const dictionary* settings =
            debug::controlDict().findDict("Documentation");
        if (settings) settings->readIfPresent("docBrowser", browser);
    }

    Info<< nl << "Documentation: " << file << nl << endl;
    if (browser.find("%f") != std::string::npos)
    {
        browser.replace("%f", file);
    }
    else
    {
        browser += " " + file;
    }
    const CStringList command(stringOps::splitSpace(browser));
    return Foam::system(command, true);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::showDocumentation
(
    int argc,
    char* argv[],
    const fileName& page,
    const fileName& source
)
{
    for (int i = 1; i < argc; ++i)
    {
        const std::string option(argv[i]);
        if (option == "-doc")
        {
            std::exit(show(pageOf(page)));
        }
        if (option == "-doc-source")
        {
            std::exit(show(fileName(getEnv("RIPRAP_DIR"))/source));
        }
    }
}


// ************************************************************************* //
