/*  All fields of some particles as records: what a particle that goes to another rank takes along.
    Put together and taken apart where the fields are, and brought over in one copy.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/hostMemory.hpp"
#include "core/containers/fieldSet.hpp"

namespace riprap
{

//- Words of some fields of particles to records, or back
struct MoveRecords
{
    static constexpr const char* name = "moveRecords";
    static constexpr int maxFields = 20;

    const int* slots;
    std::uint32_t* records;
    int words;                  // of a record
    bool toFields;
    int fields;
    std::uint32_t* field[maxFields];
    int at[maxFields];          // in a record
    int wide[maxFields];        // words of an element

    HD void operator()(int k) const
    {
        std::uint32_t* const record = records + std::size_t(k)*words;
        for (int f = 0; f < fields; ++f)
            for (int w = 0; w < wide[f]; ++w)
            {
                std::uint32_t& value = field[f][std::size_t(slots[k])*wide[f] + w];
                if (toFields) value = record[at[f] + w];
                else record[at[f] + w] = value;
            }
    }
};

template<class Backend>
class FieldRecords
{
public:

    //- Of these slots, in their order
    void gather(Context<Backend>& context, FieldSet<Backend>& set, const std::vector<int>& slots)
    {
        const std::size_t bytes = slots.size()*sizeOf(set);
        move(context, set, slots, false);
        host_.room(bytes);
        if (bytes) context.toHost(host_.data(), device_.data(), bytes);
        each_ = sizeOf(set);
        next_ = 0;
    }

    std::size_t each() const { return each_; }
    const unsigned char* record(std::size_t k) { return host_.data() + k*each_; }
    //- One after the other
    const unsigned char* next() { return record(next_++); }

    //- Into these slots
    void scatter(Context<Backend>& context, FieldSet<Backend>& set, const std::vector<int>& slots,
        const std::vector<unsigned char>& records)
    {
        if (slots.empty()) return;
        device_.allocate(context, records.size());
        context.toDevice(device_.data(), records.data(), records.size());
        move(context, set, slots, true);
    }

    static std::size_t sizeOf(FieldSet<Backend>& set)
    {
        std::size_t bytes = 0;
        for (int f = 0; f < set.fields(); ++f) bytes += set.elementBytes(f);
        return bytes;
    }

    //- Where a field is in a record [bytes]
    static std::size_t offset(FieldSet<Backend>& set, int field)
    {
        std::size_t bytes = 0;
        for (int f = 0; f < field; ++f) bytes += set.elementBytes(f);
        return bytes;
    }

private:

    void move(Context<Backend>& context, FieldSet<Backend>& set, const std::vector<int>& slots,
        bool toFields)
    {
        slots_.upload(context, slots);
        device_.allocate(context, slots.size()*sizeOf(set));
        MoveRecords m{};
        m.slots = slots_.data();
        m.records = reinterpret_cast<std::uint32_t*>(device_.data());
        m.words = int(sizeOf(set)/4);
        m.toFields = toFields;
        for (int f = 0; f < set.fields(); ++f)
        {
            m.field[m.fields] = reinterpret_cast<std::uint32_t*>(set.bytes(f));
            m.at[m.fields] = int(offset(set, f)/4);
            m.wide[m.fields++] = set.elementBytes(f)/4;
            if (m.fields < MoveRecords::maxFields && f + 1 < set.fields()) continue;
            forEach(context, int(slots.size()), m);
            m.fields = 0;
        }
    }

    Array<Backend, int> slots_;
    Array<Backend, unsigned char> device_;
    HostMemory<Backend> host_;
    std::size_t each_ = 0, next_ = 0;
};

} // namespace riprap
