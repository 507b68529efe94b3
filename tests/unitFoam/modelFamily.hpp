// SPDX-License-Identifier: GPL-3.0-or-later
/*  A family of models as its case reads it: each word of the table, and no other; each number of a
    card in its range. */
#pragma once

#include <functional>
#include <string>
#include <vector>
#include <gtest/gtest.h>
#include "scratchCase.hpp"
#include "api/models.hpp"

struct ModelFamily
{
    std::string entry;
    std::vector<std::string> words;
    //- The dictionary with this in the place of the family's entries
    std::function<std::string(const std::string& entries)> text;
    //- The word that is read from a dictionary
    std::function<std::string(const std::string& text)> word;

    std::string refusal(const std::string& entries) const
    { return messageOf([&] { word(text(entries)); }); }

    //- more: what a model needs besides its word
    void expectWords(const std::function<std::string(const std::string&)>& more
        = [](const std::string&) { return ""; }) const
    {
        ASSERT_FALSE(words.empty()) << entry;
        for (const std::string& w : words)
            EXPECT_EQ(word(text(entry + " " + w + "; " + more(w))), w) << entry;
        const std::string said = refusal(entry + " noSuchModel; " + more(words[0]));
        EXPECT_TRUE(holds(said, "Entry " + entry + " has the unknown word noSuchModel; valid are "
          + riprap::listOf(words))) << said;
    }

    //- Of one of the models: what it may have is read, what is out of its range is refused
    template<class Entry>
    void expectEntries(const std::string& model, const std::vector<Entry>& all) const
    {
        const auto with = [&](const Entry& changed, double value)
        {
            std::string s = entry + " " + model + "; ";
            for (const Entry& e : all)
                s += std::string(e.name) + " "
                    + std::to_string(&e == &changed ? value : e.typical) + "; ";
            return s;
        };
        for (const Entry& e : all)
        {
            if (e.yesNo) continue;
            EXPECT_EQ(refusal(with(e, e.typical)), "") << model << " " << e.name;
            EXPECT_TRUE(holds(refusal(with(e, -1)), std::string("Entry ") + e.name + " is -1"))
                << refusal(with(e, -1));
            if (e.highest < 1e19)
            {
                EXPECT_TRUE(holds(refusal(with(e, 2*e.highest)), std::string("Entry ") + e.name))
                    << model;
            }
        }
    }
};
