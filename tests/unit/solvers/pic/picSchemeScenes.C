/*  Each transfer scheme of the table in whole scenes: a column that collapses, on every device, in
    both dimensions and precisions. The state that was saved goes on to the bit; what the scheme
    remembers is among the fields; what it does not bear is refused.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picSceneTest.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace riprap
{
namespace
{

class PicSchemeScenes : public PicSceneTest
{
protected:

    PicConfig with(const TransferCard& card) const
    {
        PicConfig c = config(8);
        c.transfer = card.word;
        c.splineOrder = card.orders.front();
        for (const TransferEntry& e : card.entries)
            if (!e.yesNo) e.set(c.transferNumbers, e.typical);
        return c;
    }

    static std::unique_ptr<PicScene> column(const PicConfig& c)
    {
        return scene(c, box(c, {{0, 0, 0}}, {{0.5, 0.75, 1}}, [](double, double) { return true; }),
            PicInside());
    }
};

RIPRAP_ALL_SETUPS(PicSchemeScenes);

TEST_P(PicSchemeScenes, StatesGoOnToTheBit)
{
    for (const TransferCard& card : transfers())
    {
        const auto whole = column(with(card)), second = column(with(card));
        whole->advance(1, 6);
        const std::vector<std::int32_t> half = whole->saveState();
        const auto words = whole->savedState(true);
        const Later<FluidState> fluid = whole->fluidLater();
        const FluidState fluidNow = whole->fluid();
        const PicReport report = whole->advance(1, 5);
        EXPECT_EQ(report.stop, StopReason::none) << card.word;
        EXPECT_GT(report.maxSpeed, 0.1) << card.word;
        EXPECT_EQ(words.size, half.size()) << card.word;
        EXPECT_EQ(words.take(), half) << card.word;
        expectSameBits(fluid.take(), fluidNow);
        second->loadState(half);
        second->advance(1, 5);
        EXPECT_TRUE(whole->saveState() == second->saveState()) << card.word;
        EXPECT_FALSE(whole->saveState() == half) << card.word;
    }
}

TEST_P(PicSchemeScenes, FieldsAreThoseOfTheScheme)
{
    for (const TransferCard& card : transfers())
        for (const bool affine : {false, true})
        {
            PicConfig c = with(card);
            c.transferNumbers.affine = affine;
            const auto s = column(c);
            std::map<std::string, int> fields;
            for (const ArrayInfo& a : s->arrays()) ++fields[a.name];
            EXPECT_EQ(fields["affine"], keepsGradient(card, c.transferNumbers) ? D()*D() : 0)
                << card.word;
            EXPECT_EQ(fields["transfer"], card.memory*D()) << card.word;
        }
}

//- A state whose particles remember for another scheme, or of other fields, is not taken
TEST_P(PicSchemeScenes, StatesOfOtherFieldsAreRefused)
{
    for (const TransferCard& from : transfers())
        for (const TransferCard& to : transfers())
        {
            const bool same = keepsGradient(from, TransferProperties())
                    == keepsGradient(to, TransferProperties())
                && (std::string(from.word) == to.word || (!from.memory && !to.memory));
            const auto state = column(with(from))->saveState();
            const auto other = column(with(to));
            if (same) { EXPECT_NO_THROW(other->loadState(state)) << from.word << " " << to.word; }
            else
            {
                EXPECT_THROW(other->loadState(state), std::invalid_argument)
                    << from.word << " " << to.word;
            }
        }
}

//- The step is no longer than the scheme bears
TEST_P(PicSchemeScenes, StepsAreBorne)
{
    for (const TransferCard& card : transfers())
    {
        const PicConfig c = with(card);
        const double longest = card.timeStep(c.transferNumbers);
        std::string limit;
        const double step = column(c)->estimateTimeStep(limit);
        EXPECT_LE(step, longest) << card.word;
        EXPECT_EQ(limit == "transfer", step == longest) << card.word << " " << limit;
    }
}

TEST_P(PicSchemeScenes, UnknownWordsAreRefusedWithTheValidOnes)
{
    PicConfig c = config(8);
    c.transfer = "harmonic";
    try { column(c); FAIL(); }
    catch (const std::invalid_argument& e)
    {
        for (const TransferCard& card : transfers())
            EXPECT_NE(std::string(e.what()).find(card.word), std::string::npos) << e.what();
    }
}

} // namespace
} // namespace riprap
