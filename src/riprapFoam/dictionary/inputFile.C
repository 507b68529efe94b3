/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inputFile.H"
#include "missingFunction.H"
#include "dictionaryText.hpp"
#include "dictionary.H"
#include "error.H"
#include "OSspecific.H"
#include "stringOps.H"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{

//- One file; what it includes is another
class inputFile
{
    fileName name_;
    double largest_;
    std::vector<fileName> chain_;           // of files that include each other, this one last
    dictionaryText text_;
    std::string path_;                      // of the present entry, ends with /
    bool merges_ = false;                   // after #inputMode

    //- Names of a pair of braces, and where they stand
    typedef std::map<std::string, int> names;

    [[noreturn]] void stop(int line, const std::string& what) const;

    void checkNumber(const textToken&, const std::string& entry) const;
    void checkWord(const textToken&, const std::string& entry) const;
    void include(const std::string& typed, int line, bool isValue, const std::string& entry) const;

    bool readDirective(const textToken&, names&);
    void readConditional(int line);
    void requireOne(const textToken& keyword, const std::string& entry, names&) const;
    void readEntry(const textToken& keyword, names&);
    void readValue(const textToken& keyword, const std::string& entry);
    void readValueDirective(const textToken&, const std::string& entry);

    //- A dictionary in a list; before: its name, if that is a word
    void readListEntry(const textToken& before, int line, const std::string& entry, names&);

    //- To the } that ends it, or the end of the file
    enum ends { file, brace, condition };
    void skipList(textToken);
    void readBlock(ends, int line);

public:

    inputFile
    (
        const fileName& name,
        const std::vector<fileName>& above,
        const std::string& text,
        const std::string& path,
        double largest
    )
    :
        name_(name),
        largest_(largest),
        chain_(above),
        text_(text),
        path_(path)
    {
        chain_.push_back(name);
    }

    void read()
    {
        readBlock(file, 1);
    }

    void readAsValue(const std::string& entry);
};


static bool textOf(const fileName& name, std::string& text)
{
    if (!isFile(name, false)) return false;
    std::ifstream in(name);
    text.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    // Compressed or binary: not a person's
    return in.good() && text.find('\0') == std::string::npos && text.compare(0, 2, "\x1f\x8b") != 0;
}


static bool isInclude(const std::string& directive)
{
    return directive == "#include" || directive == "#includeIfPresent" || directive == "#sinclude";
}


//- Brackets that are open in the value of an entry, and what is wrong with them
class valueBrackets
{
    const std::string where_;
    std::string open_;

    std::string fault(const std::string& bracket, const char* what) const
    {
        return where_ + ", has a bracket " + bracket + what;
    }

public:

    valueBrackets(const std::string& entry, int line)
    :
        where_("Entry " + entry + ", line " + std::to_string(line))
    {}

    bool empty() const { return open_.empty(); }
    bool inDimensions() const { return !open_.empty() && open_.back() == '['; }
    bool closes(const textToken& t) const
    {
        return !t.is('}') && !open_.empty() && open_.back() == (t.is(')') ? '(' : '[');
    }

    void add(const textToken& t) { open_ += t.text; }
    void close() { open_.pop_back(); }

    std::string notClosed() const
    {
        return fault(open_.substr(open_.size() - 1), " that nothing closes");
    }
    std::string notOpened(const textToken& t) const { return fault(t.text, " that nothing opens"); }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::inputFile::stop(int line, const std::string& what) const
{
    FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, name_, line)
        << what.c_str() << exit(FatalIOError);
    std::abort();
}


void Foam::inputFile::checkNumber(const textToken& t, const std::string& entry) const
{
    // OpenFOAM traps the overflow itself
    std::fenv_t traps;
    std::feholdexcept(&traps);
    const double value = std::strtod(t.text.c_str(), nullptr);
    std::fesetenv(&traps);
    if (!(std::fabs(value) <= largest_))
    {
        std::ostringstream most;
        most << largest_;
        stop(t.line,
            "Entry " + entry + " holds " + t.text + ": numbers up to " + most.str() + " are valid");
    }
}


void Foam::inputFile::checkWord(const textToken& t, const std::string& entry) const
{
    std::string lower(t.text);
    for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
    while (!lower.empty() && (lower[0] == '-' || lower[0] == '+')) lower.erase(0, 1);
    if (lower == "nan" || lower == "inf" || lower == "infinity")
    {
        stop(t.line, "Entry " + entry + " holds " + t.text + ": it must be a finite number");
    }
}


void Foam::inputFile::include(
    const std::string& typed, int line, bool isValue, const std::string& entry) const
{
    fileName name(typed);
    stringOps::inplaceExpand(name, dictionary::null, true, true);
    if (name.empty()) return;
    if (!name.isAbsolute()) name = name_.path()/name;
    name.clean();

    if (std::find(chain_.begin(), chain_.end(), name) != chain_.end())
    {
        std::string way;
        for (const fileName& f : chain_) way += f.name() + " includes ";
        stop(line, "The file includes itself: " + way + name.name());
    }

    std::string text;
    if (!textOf(name, text)) return;
    inputFile file(name, chain_, text, path_, largest_);
    if (isValue) file.readAsValue(entry);
    else file.read();
}


//- \return false if the directive is none that stands between entries
bool Foam::inputFile::readDirective(const textToken& t, names& known)
{
    const std::string& name = t.text;
    if (isInclude(name))
    {
        include(text_.next().text, t.line, false, "");
    }
    else if (name == "#inputMode")
    {
        text_.next();
        merges_ = true;
    }
    else if (name == "#remove")
    {
        textToken first(text_.next());
        if (first.is('('))
        {
            // Patterns as well
            known.clear();
            while (!first.is(')') && first.kind != textToken::end) first = text_.next();
        }
        else if (first.kind == textToken::string) known.clear();
        else known.erase(first.text);
    }
    else if (name == "#if" || name == "#ifeq")
    {
        text_.next();
        if (name == "#ifeq") text_.next();
        readConditional(t.line);
    }
    else if (name == "#includeFunc")
    {
        const std::string missing(missingFunction(text_.next().text));
        if (!missing.empty()) stop(t.line, missing);
    }
    else if (name == "#includeEtc" || name == "#sincludeEtc" || name == "#message")
    {
        text_.next();
    }
    else
    {
        return false;
    }
    return true;
}


void Foam::inputFile::readConditional(int line)
{
    // Only one branch is read, and it may change what stands outside
    readBlock(condition, line);
}


void Foam::inputFile::requireOne(
    const textToken& keyword, const std::string& entry, names& known) const
{
    // "a.*" is a pattern, and not the same as a.*
    const auto added = known.insert(
        {(keyword.kind == textToken::string ? "\"" : "") + keyword.text, keyword.line});
    if (!added.second && !merges_)
    {
        stop(keyword.line,
            "Entry " + entry + " is there twice: in line " + std::to_string(added.first->second)
                + " and in line " + std::to_string(keyword.line));
    }
}


void Foam::inputFile::readEntry(const textToken& keyword, names& known)
{
    const std::string entry(path_ + keyword.text);
    requireOne(keyword, entry, known);

    const textToken first(text_.next());
    if (first.is('{'))
    {
        const std::string above(path_);
        path_ = entry + '/';
        readBlock(brace, first.line);
        path_ = above;
    }
    else
    {
        text_.putBack(first);
        readValue(keyword, entry);
    }
}


//- To its semicolon
void Foam::inputFile::readValue(const textToken& keyword, const std::string& entry)
{
    valueBrackets open(entry, keyword.line);
    names known;                    // of dictionaries in a list
    textToken before = keyword;
    for (textToken t = text_.next(); ; before = t, t = text_.next())
    {
        if (t.kind == textToken::end || (open.empty() && t.is('}')))
        {
            // a file that is a value
            if (keyword.kind == textToken::end && open.empty()) return;
            stop(before.line,
                open.empty() ? "Entry " + entry + " has no semicolon at its end"
                             : open.notClosed());
        }
        if (open.empty() && t.is(';')) return;

        if (t.kind == textToken::number) checkNumber(t, entry);
        else if (t.kind == textToken::word)
        {
            checkWord(t, entry);
            // [s^-1]
            if (open.inDimensions() && t.text.back() == ']') open.close();
        }
        else if (t.kind == textToken::directive) readValueDirective(t, entry);
        else if (t.is('(') || t.is('[')) open.add(t);
        else if (t.is('{')) readListEntry(before, t.line, entry, known);
        else if (t.is(')') || t.is(']') || t.is('}'))
        {
            if (!open.closes(t)) stop(t.line, open.notOpened(t));
            open.close();
        }
        else if (t.is(';')) stop(t.line, open.notClosed());
    }
}


void Foam::inputFile::readValueDirective(const textToken& t, const std::string& entry)
{
    if (isInclude(t.text))
    {
        include(text_.next().text, t.line, true, entry);
    }
    else if (t.text == "#eval" || t.text == "#calc")
    {
        const textToken expression(text_.next());
        if (expression.is('{')) text_.takeBraces();
    }
}


void Foam::inputFile::readListEntry(
    const textToken& before, int line, const std::string& entry, names& known)
{
    const std::string above(path_);
    path_ = entry + '/';
    if (before.kind == textToken::word && before.line != 0)
    {
        requireOne(before, path_ + before.text, known);
        path_ += before.text + '/';
    }
    readBlock(brace, line);
    path_ = above;
}


//- A list of dictionaries, as the boundary of a mesh: not looked into
void Foam::inputFile::skipList(textToken t)
{
    for (int depth = t.is('(');
         t.kind != textToken::end && (depth > 0 || t.kind == textToken::number); )
    {
        t = text_.next();
        depth += t.is('(') - t.is(')');
    }
}


void Foam::inputFile::readBlock(ends until, int line)
{
    names known;
    const std::string where(
        path_.empty() ? std::string("The file") : "Entry " + path_.substr(0, path_.size() - 1));
    for (textToken t = text_.next(); ; t = text_.next())
    {
        if (t.kind == textToken::end)
        {
            if (until == file) return;
            stop(line,
                where
                    + (until == brace ? " has a bracket { that nothing closes"
                                      : " has an #if without its #endif"));
        }
        if (t.is(';')) continue;
        if (t.is('}'))
        {
            if (until == brace) return;
            stop(t.line, where + " has a bracket } that nothing opens");
        }
        if (t.kind == textToken::directive)
        {
            if (until == condition && t.text == "#endif") return;
            if (until == condition && (t.text == "#else" || t.text == "#elif"))
            {
                if (t.text == "#elif") text_.next();
                known.clear();
                continue;
            }
            if (readDirective(t, known)) continue;
            readValue(t, path_ + t.text);
        }
        else if (t.kind == textToken::variable)
        {
            // $name; or $name { ... }
            const textToken then(text_.next());
            if (then.is('{')) readBlock(brace, then.line);
            else text_.putBack(then);
        }
        else if (t.kind == textToken::word || t.kind == textToken::string)
        {
            readEntry(t, known);
        }
        else if (t.is('(') || t.kind == textToken::number)
        {
            skipList(t);
        }
        else
        {
            stop(t.line,
                where + " has a bracket " + t.text
                    + " that nothing opens, or a semicolon is missing before it");
        }
    }
}


void Foam::inputFile::readAsValue(const std::string& entry)
{
    readValue(textToken(), entry);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkInputFile(const fileName& name, double largest)
{
    std::string text;
    fileName clean(name);
    clean.clean();
    if (textOf(clean, text)) inputFile(clean, {}, text, "", largest).read();
}


// ************************************************************************* //
