/*  What was launched how often and, on request, how long it took. Kept by name, in order of first
    use.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace riprap
{

class Profile
{
public:

    struct Entry { std::string name; std::int64_t launches = 0; double seconds = 0; };

    bool timing = false;
    bool capturing = false;     // launches are recorded into a graph: counted at each replay

    Entry& entry(const char* name)
    {
        // a kernel's name is mostly the same characters in memory: no string is made of it then
        const auto known = known_.find(name);
        if (known != known_.end()) return entries_[known->second];
        Entry& e = entryCalled(name);
        known_.emplace(name, std::size_t(&e - entries_.data()));
        return e;
    }

    Entry& entryCalled(const char* name)
    {
        const auto found = index_.find(name);
        if (found != index_.end()) return entries_[found->second];
        index_.emplace(name, entries_.size());
        entries_.push_back(Entry{name, 0, 0});
        return entries_.back();
    }

    void count(const char* name)
    {
        Entry& e = entry(name);
        if (capturing) captured_.push_back(&e - entries_.data());
        else ++e.launches;
    }

    void addTime(const char* name, double seconds) { entry(name).seconds += seconds; }

    //- What the capture in hand has recorded so far; the caller keeps it with its graph
    std::vector<std::size_t> takeCaptured() { return std::move(captured_); }
    void countReplay(const std::vector<std::size_t>& recorded)
    {
        for (const std::size_t e : recorded) ++entries_[e].launches;
    }

    const std::vector<Entry>& entries() const { return entries_; }

private:

    std::vector<Entry> entries_;
    std::unordered_map<std::string, std::size_t> index_;
    std::unordered_map<const void*, std::size_t> known_;
    std::vector<std::size_t> captured_;
};

} // namespace riprap
