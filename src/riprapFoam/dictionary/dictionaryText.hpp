/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The text of a dictionary as tokens, cut as OpenFOAM's ISstream cuts it,
    with the line of each. Nothing is evaluated.
\*---------------------------------------------------------------------------*/

#ifndef dictionaryText_hpp
#define dictionaryText_hpp

#include <cctype>
#include <string>

namespace Foam
{

struct textToken
{
    enum kinds { end, mark, number, word, string, directive, variable, verbatim };

    kinds kind = end;
    std::string text;           // of strings without their quotes
    int line = 0;

    bool is(char c) const
    {
        return kind == mark && text[0] == c;
    }
};


class dictionaryText
{
    std::string text_;
    std::size_t at_ = 0;
    int line_ = 1;
    textToken back_;
    bool hasBack_ = false;

    char peek(std::size_t ahead = 0) const
    {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    char take()
    {
        const char c = text_[at_++];
        line_ += c == '\n';
        return c;
    }

    //- Up to and with what is sought, or all that is left
    std::string takeTo(const std::string& sought)
    {
        const std::size_t found = text_.find(sought, at_);
        const std::size_t stop = found == std::string::npos ? text_.size() : found + sought.size();
        std::string taken;
        while (at_ < stop) taken += take();
        return taken;
    }

    void skipBlanks()
    {
        while (at_ < text_.size())
        {
            if (std::isspace(static_cast<unsigned char>(peek()))) take();
            else if (peek() == '/' && peek(1) == '/') takeTo("\n");
            else if (peek() == '/' && peek(1) == '*') takeTo("*/");
            else return;
        }
    }

    std::string takeString()
    {
        std::string s;
        take();
        while (at_ < text_.size() && peek() != '"')
        {
            if (peek() == '\\' && at_ + 1 < text_.size()) s += take();
            s += take();
        }
        if (at_ < text_.size()) take();
        return s;
    }

    //- As word::valid, with what a path has; brackets as long as they match
    std::string takeWord()
    {
        std::string s;
        int depth = 0;
        while (at_ < text_.size())
        {
            const char c = peek();
            if (c == '{' && !s.empty() && s.back() == '$')
            {
                s += takeTo("}");
                continue;
            }
            if (std::isspace(static_cast<unsigned char>(c)) || c == '"' || c == '\'' || c == ';'
                || c == '{' || c == '}')
                break;
            if ((c == ')' && depth == 0) || (c == '/' && (peek(1) == '/' || peek(1) == '*'))) break;
            depth += (c == '(') - (c == ')');
            s += take();
        }
        if (s.empty()) s += take();
        return s;
    }

public:

    explicit dictionaryText(const std::string& text)
    :
        text_(text)
    {}

    void putBack(const textToken& t)
    {
        back_ = t;
        hasBack_ = true;
    }

    //- What an expression in braces holds, from after its opening
    std::string takeBraces()
    {
        return takeTo("}");
    }

    textToken next()
    {
        if (hasBack_)
        {
            hasBack_ = false;
            return back_;
        }

        skipBlanks();
        textToken t;
        t.line = line_;
        if (at_ >= text_.size()) return t;

        const char c = peek(), second = peek(1);
        const auto isDigit = [](char x)
        { return std::isdigit(static_cast<unsigned char>(x)) != 0; };
        if (std::string("{}()[];").find(c) != std::string::npos)
        {
            t.kind = textToken::mark;
            t.text = take();
        }
        else if (c == '"')
        {
            t.kind = textToken::string;
            t.text = takeString();
        }
        else if (c == '#' && second == '{')
        {
            t.kind = textToken::verbatim;
            t.text = takeTo("#}");
        }
        else if (isDigit(c)
            || ((c == '-' || c == '.' || c == '+') && (isDigit(second) || second == '.')))
        {
            t.kind = textToken::number;
            while (isDigit(peek())
                || (at_ < text_.size() && std::string("+-.eE").find(peek()) != std::string::npos))
                t.text += take();
        }
        else
        {
            t.kind = c == '#' ? textToken::directive
                : c == '$' ? textToken::variable
                              : textToken::word;
            t.text = takeWord();
        }
        return t;
    }
};

} // End namespace Foam

#endif
