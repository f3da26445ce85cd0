#include <auxfem/model/unknown_records.h>

#include <algorithm>
#include <limits>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int not_numbered =
      std::numeric_limits<unsigned int>::max();

    /** Numbers local unknowns one after the other, or leaves out others. */
    class SerialNumbers
    {
    public:
      explicit SerialNumbers(const UnknownLayout &layout)
        : layout(layout)
        , of_local(layout.n_local(), not_numbered)
      {}

      /** Of the next unknown, by its global number; -1: not there. */
      void count(const int global)
      {
        if (global < 0)
          return;
        if (const int local = layout.local(global); local >= 0)
          of_local[local] = next;
        ++next;
      }

      template <class Globals>
      void count_all(const Globals &globals)
      {
        for (const int global : globals)
          count(global);
      }

      const UnknownLayout      &layout;
      std::vector<unsigned int> of_local;
      unsigned int              next = 0;
    };

    /** Those of joints, rigid parts and hinges; joints may share some. */
    void count_outside_struts(const GlobalNumbers &numbers,
                              SerialNumbers       &serial)
    {
      for (const GlobalNumbers::OfMotion &joint : numbers.joints)
        serial.count_all(joint);
      for (const auto &[end, rotation] : numbers.released_ends)
        serial.count_all(rotation);
      for (const GlobalNumbers::OfRigidPart &part : numbers.rigid_parts)
        {
          serial.count_all(part.motion);
          serial.count_all(part.multipliers);
        }
      for (const GlobalNumbers::OfHinge &hinge : numbers.hinges)
        serial.count_all(hinge.multipliers);
    }

    void count_inside_struts(const DofNumbering &numbering,
                             SerialNumbers      &serial)
    {
      const auto &elements = numbering.elements();
      const auto &first    = numbering.global().first_nodes;
      for (unsigned int e = 0; e < elements.size(); ++e)
        {
          const StrutInterval &interval = elements[e].interval;
          const unsigned int   order    = elements[e].order;
          const int           *unknowns = numbering.element_unknowns(e);
          for (unsigned int node = 0; node <= order;
               ++node, unknowns += numbering.n_components())
            if (!interval.is_joint(node))
              for (unsigned int c = 0; c < numbering.n_components(); ++c)
                serial.of_local[unknowns[c]] = serial.next +
                  (first[interval.strut] + order * interval.number() +
                   place_along(node, order)) *
                    numbering.n_components() +
                  c;
        }
    }

    std::vector<unsigned int> serial_numbers(const DofNumbering &numbering)
    {
      SerialNumbers serial(numbering.layout());
      count_outside_struts(numbering.global(), serial);
      count_inside_struts(numbering, serial);
      return serial.of_local;
    }

    /** Also of ghosts that the numbering does not know. */
    std::vector<unsigned int> serial_numbers(const DofNumbering  &numbering,
                                             const UnknownLayout &layout)
    {
      const std::vector<unsigned int> known = serial_numbers(numbering);
      Vector                          all(known.begin(), known.end());
      all.resize(layout.n_local());
      layout.update_ghosts(all.data());
      return {all.begin(), all.end()};
    }
  } // namespace

  UnknownRecords::UnknownRecords(const DofNumbering &numbering)
    : layout(numbering.layout())
    , serial(serial_numbers(numbering))
  {}

  UnknownRecords::UnknownRecords(const DofNumbering  &numbering,
                                 const UnknownLayout &layout)
    : layout(layout)
    , serial(serial_numbers(numbering, layout))
  {}

  void UnknownRecords::keep(const std::string &name,
                            const Vector      &values,
                            Records           &records) const
  {
    records.keep(name,
                 owned(),
                 1,
                 {values.begin(), values.begin() + layout.n_owned()});
  }

  Vector UnknownRecords::values(const std::string &name,
                                const Records     &records) const
  {
    Vector values = records.values(name, owned(), 1);
    values.resize(layout.n_local());
    layout.update_ghosts(values.data());
    return values;
  }
} // namespace auxfem
