/*  Particles of several ranks (threads here) whose fields stay on the device: order, ghosts and
    values beside those of one process, and what is lost or comes twice.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <functional>
#include <mutex>
#include <numeric>
#include "backendTest.hpp"
#include "core/threadRanks.hpp"
#include "core/ranks/slotExchange.hpp"

namespace riprap
{
namespace
{

//- All there is, as one process has it
struct Truth
{
    static constexpr int nx = 14, ny = 9, nz = 5, cells = nx*ny*nz;

    std::vector<std::uint32_t> cell;        // by id; `cells`: it has left
    std::vector<std::int64_t> value;        // by id
    std::vector<int> order;                 // ids by cell, then by the order before

    explicit Truth(int n) : cell(n), value(n, 0), order(n)
    {
        Random random(7);
        std::iota(order.begin(), order.end(), 0);
        for (auto& c : cell) c = std::uint32_t(random(0, cells));
    }

    //- Some go to a cell nearby, some anywhere, a few leave
    void walk(unsigned seed)
    {
        Random random(seed);
        for (auto& c : cell)
        {
            const double chance = random(0, 1);
            const int to = int(c) + int(random(-1.99, 2));
            if (c == std::uint32_t(cells)) continue;
            if (chance < 0.3 && to >= 0 && to < cells) c = std::uint32_t(to);
            else if (chance < 0.32) c = std::uint32_t(random(0, cells));
            else if (chance < 0.33) c = std::uint32_t(cells);
        }
        for (std::size_t i = 0; i < value.size(); ++i) value[i] = 1000*std::int64_t(seed) + int(i);
    }

    void sort()
    {
        order.erase(std::remove_if(order.begin(), order.end(),
                        [&](int id) { return cell[id] == std::uint32_t(cells); }),
            order.end());
        std::stable_sort(
            order.begin(), order.end(), [&](int a, int b) { return cell[a] < cell[b]; });
    }
};

struct PutValue
{
    const std::int64_t* value;
    HD void operator()(int i, unsigned char* to) const { putWord(to, value[i]); }
};

struct TakeValue
{
    std::int64_t* value;
    HD void operator()(int i, const unsigned char* from) const { takeWord(from, value[i]); }
};

//- What a rank has of it
class Part
{
public:

    Part(Transport& ranks, const Truth& all)
        : exchange_(context_, ranks, 0.1, false, false), n_(int(all.cell.size()))
    {
        id_ = fields_.template add<std::int32_t>("id");
        value_ = fields_.template add<std::int64_t>("value");
        fields_.allocate(context_, n_);
        sort_.allocate(context_, n_, Truth::cells);
        std::vector<std::int32_t> ids(n_);
        std::iota(ids.begin(), ids.end(), 0);
        fields_.upload(context_, id_, ids);
        PieceGrid g;
        g.n[0] = Truth::nx;
        g.n[1] = Truth::ny;
        g.n[2] = Truth::nz;
        g.stride[1] = Truth::nx;
        g.stride[2] = Truth::nx*Truth::ny;
        g.periodic[1] = true;
        exchange_.setPieces({g}, 1.1);
        exchange_.begin(n_);
    }

    void rebuild(const Truth& all)
    {
        const auto ids = fields_.template download<std::int32_t>(context_, id_);
        std::vector<std::uint32_t> keys(n_, Truth::cells);
        for (int i = 0; i < exchange_.residents(); ++i) keys[i] = all.cell[ids[i]];
        context_.toDevice(sort_.keys(), keys.data(), keys.size()*sizeof(keys[0]));
        exchange_.migrate(fields_, sort_, n_, [this](int n) { grow(n); });
        for (int k = 0; k < exchange_.left(); ++k)
        {
            std::int32_t id = 0;
            std::memcpy(&id, exchange_.leftRecord(k), sizeof(id));
            left.push_back(id);
        }
        sort_.sort(context_, n_);
        fields_.permute(context_, sort_.order(), n_);
        int active = 0;
        context_.toHost(&active, sort_.active(), sizeof(int));
        exchange_.settle(sort_, n_, active);
    }

    //- Own values are the truth's, those of ghosts follow
    void share(const Truth& all)
    {
        const auto ids = fields_.template download<std::int32_t>(context_, id_);
        auto values = fields_.template download<std::int64_t>(context_, value_);
        for (int i = 0; i < exchange_.residents(); ++i)
            values[i] = exchange_.ghost(i) ? -1 : all.value[ids[i]];
        fields_.upload(context_, value_, values);
        std::int64_t* value = fields_.template data<std::int64_t>(value_);
        exchange_.share(sizeof(*value), PutValue{value}, TakeValue{value});
    }

    //- \return own particles
    int check(const Truth& all)
    {
        const auto ids = fields_.template download<std::int32_t>(context_, id_);
        const auto values = fields_.template download<std::int64_t>(context_, value_);
        const std::vector<std::int64_t> numbers = exchange_.numbers();
        const int me = exchange_.transport().rank();
        int own = 0, expected = 0;
        require(exchange_.total() == std::int64_t(all.order.size()), "the number of all");
        for (int i = 0; i < exchange_.residents(); ++i)
        {
            require(i == 0 || numbers[i] > numbers[i - 1], "the order of numbers");
            require(all.order[numbers[i]] == ids[i], "the place in the order of all");
            require(values[i] == all.value[ids[i]], "a value");
            const bool mine = exchange_.ownerOf(all.cell[ids[i]]) == me;
            require(exchange_.ghost(i) == !mine, "who is a ghost");
            own += mine;
        }
        for (const int id : all.order)
        {
            const auto& needs = exchange_.ghostsOf(all.cell[id]);
            expected += exchange_.ownerOf(all.cell[id]) == me
                || std::binary_search(needs.begin(), needs.end(), me);
        }
        require(expected == exchange_.residents(), "who is here");
        require(own == exchange_.ownedHere(), "the number of own ones");
        return own;
    }

    const SlotExchange<Backend>& exchange() const { return exchange_; }
    std::vector<int> left;                  // ids

private:

    static void require(bool right, const char* what)
    {
        if (!right) throw std::runtime_error(std::string("wrong: ") + what);
    }

    void grow(int n)
    {
        FieldSet<Backend> old(std::move(fields_));
        fields_ = FieldSet<Backend>();
        fields_.template add<std::int32_t>("id");
        fields_.template add<std::int64_t>("value");
        fields_.allocate(context_, n);
        for (int f = 0; f < 2; ++f)
            copyOnDevice(context_, fields_.bytes(f), old.bytes(f),
                std::size_t(n_)*fields_.elementBytes(f));
        context_.synchronise();
        sort_ = CellSort<Backend>();
        sort_.allocate(context_, n, Truth::cells);
        n_ = n;
    }

    Context<Backend> context_;
    FieldSet<Backend> fields_;
    CellSort<Backend> sort_;
    SlotExchange<Backend> exchange_;
    int n_, id_ = 0, value_ = 0;
};

template<class C>
class SlotExchangeTest : public BackendTest {};

// Nothing depends on dimension or precision: the case gives the name of the device
using OneCase = testing::Types<Case<3, Double>>;
TYPED_TEST_SUITE(SlotExchangeTest, OneCase, CaseNames);

TYPED_TEST(SlotExchangeTest, orderGhostsAndValues)
{
    constexpr int particles = 3000, rebuilds = 12;
    for (const int ranks : {2, 3, 8})
    {
        std::mutex mutex;
        std::vector<int> own(rebuilds, 0), left;
        std::int64_t arrivals = 0;
        Truth last(particles);
        onRanks(ranks, [&](Transport& transport)
        {
            Truth all(particles);
            Part part(transport, all);
            for (int k = 0; k < rebuilds; ++k)
            {
                if (k) all.walk(k);
                all.sort();
                part.rebuild(all);
                part.share(all);
                const int here = part.check(all);
                std::lock_guard<std::mutex> lock(mutex);
                own[k] += here;
            }
            std::lock_guard<std::mutex> lock(mutex);
            left.insert(left.end(), part.left.begin(), part.left.end());
            arrivals += part.exchange().counts.arrivals;
            last = all;
        });
        for (const int n : own) EXPECT_GE(n, int(last.order.size()));
        EXPECT_EQ(own.front(), particles);
        EXPECT_EQ(own.back(), int(last.order.size()));
        EXPECT_GT(arrivals, 100);
        // each that left was told by one rank
        std::sort(left.begin(), left.end());
        std::vector<int> gone;
        for (int id = 0; id < particles; ++id)
            if (last.cell[id] == std::uint32_t(Truth::cells)) gone.push_back(id);
        EXPECT_EQ(left, gone);
        EXPECT_GT(gone.size(), 20u);
    }
}

//- A transport that loses the first record that comes, or brings it twice
class Faulty : public Transport
{
public:
    Faulty(Transport& inner, bool lose, std::size_t record)
        : inner_(inner), record_(record), lose_(lose)
    {}
    int rank() const override { return inner_.rank(); }
    int size() const override { return inner_.size(); }
    void exchange(const std::vector<RankBytes>& out, std::vector<RankBytes>& in) override
    {
        inner_.exchange(out, in);
        // numbers in pieces, then particles
        if (++calls_ % 2) return;
        for (RankBytes& b : in)
        {
            if (b.size() < record_) continue;
            const RankBytes first(b.begin(), b.begin() + record_);
            if (lose_) b.erase(b.begin(), b.begin() + record_);
            else b.insert(b.end(), first.begin(), first.end());
            return;
        }
    }
    void swap(const std::vector<RankMessage>& out, std::vector<RankMessage>& in) override
    { inner_.swap(out, in); }
    void sum(std::vector<std::int64_t>& v) override { inner_.sum(v); }
    void largest(std::vector<double>& v) override { inner_.largest(v); }

private:
    Transport& inner_;
    std::size_t record_;
    bool lose_;
    int calls_ = 0;
};

TYPED_TEST(SlotExchangeTest, lostAndDoubledParticles)
{
    for (const bool lose : {true, false})
        EXPECT_THROW(onRanks(2, [&](Transport& transport)
        {
            // a header of 16 bytes, an id and a value
            Faulty faulty(transport, lose, 28);
            Truth all(3000);
            Part part(faulty, all);
            for (int k = 0; k < 5; ++k)
            {
                if (k) all.walk(k);
                all.sort();
                part.rebuild(all);
            }
        }), std::logic_error);
}

} // namespace
} // namespace riprap
