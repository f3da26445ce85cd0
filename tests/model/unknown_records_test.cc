#include <auxfem/model/unknown_records.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <set>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Local unknown of a node of element @p e of @p numbering. */
  int unknown_of(const DofNumbering &numbering,
                 const unsigned int  e,
                 const unsigned int  i)
  {
    return numbering.element_unknowns(e)[i];
  }

  std::pair<unsigned int, double> place_of(const DofNumbering &numbering,
                                           const unsigned int  e)
  {
    const StrutInterval &interval = numbering.elements()[e].interval;
    return {interval.strut, interval.begin};
  }
} // namespace

TEST(UnknownRecords, SerialNumbersAreThoseOfOneRank)
{
  for (const std::string &text : {std::string(star_with_everything(2, 2)),
                                  std::string(space_star_with_everything())})
    {
      const EquationsOnRanks alone(text, {}, MPI_COMM_SELF), together(text);
      const UnknownRecords   records_alone(alone.dofs()),
        records_together(together.dofs());

      std::set<unsigned int> different;
      for (unsigned int i = 0; i < alone.dofs().layout().n_local(); ++i)
        different.insert(records_alone.serial_number(i));
      EXPECT_EQ(different.size(), alone.dofs().layout().n_global());

      std::map<std::pair<unsigned int, double>, unsigned int> element_at;
      for (unsigned int e = 0; e < alone.dofs().elements().size(); ++e)
        element_at[place_of(alone.dofs(), e)] = e;
      for (unsigned int e = 0; e < together.dofs().elements().size(); ++e)
        for (unsigned int i = 0; i < together.dofs().n_element_unknowns(e); ++i)
          EXPECT_EQ(records_together.serial_number(
                      unknown_of(together.dofs(), e, i)),
                    records_alone.serial_number(
                      unknown_of(alone.dofs(),
                                 element_at.at(place_of(together.dofs(), e)),
                                 i)));
      const auto &multipliers = together.dofs().constraints().multipliers(),
                 &multipliers_alone = alone.dofs().constraints().multipliers();
      std::set<unsigned int> multiplier_numbers;
      for (const int i : multipliers_alone)
        multiplier_numbers.insert(records_alone.serial_number(i));
      for (const int i : multipliers)
        EXPECT_EQ(multiplier_numbers.count(records_together.serial_number(i)),
                  1u);
    }
}

TEST(UnknownRecords, ValuesComeBackWithGhosts)
{
  const EquationsOnRanks on_ranks(star_with_everything(2, 2).str());
  const UnknownLayout   &layout = on_ranks.dofs().layout();
  const UnknownRecords   unknowns(on_ranks.dofs());
  Vector                 values(layout.n_local());
  for (unsigned int i = 0; i < values.size(); ++i)
    values[i] = 1. / (1 + layout.global(i));
  CheckpointData records;
  unknowns.keep("values", values, records);
  EXPECT_EQ(records.items("values").size(), layout.n_owned());
  EXPECT_EQ(unknowns.values("values", records), values);
}
