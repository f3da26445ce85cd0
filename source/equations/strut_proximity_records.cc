#include <auxfem/equations/strut_proximity.h>

#include <algorithm>

// What of the search for near struts does not follow from the state at which a
// run is resumed.

namespace auxfem
{
  namespace
  {
    const std::string travel_record    = "contact of struts: travel",
                      pairs_record     = "contact of struts: pairs in reach",
                      connected_record = "contact of struts: connected pairs",
                      turned_record    = "contact of struts: turned at",
                      looked_record    = "contact of struts: last look";

    /** A record of any length, which may be nothing. */
    void keep_list(const std::string         &name,
                   const std::vector<double> &values,
                   Records                   &records)
    {
      std::vector<double> list = {double(values.size())};
      list.insert(list.end(), values.begin(), values.end());
      records.keep(name, list);
    }

    std::vector<double> kept_list(const std::string &name,
                                  const Records     &records)
    {
      std::vector<double> list =
        records.values(name, records.values_per_item(name));
      list.erase(list.begin());
      return list;
    }
  } // namespace

  std::vector<double>
  StrutProximity::by_axis(const std::vector<double> &values) const
  {
    std::vector<double> result;
    if (!values.empty())
      for (const ContactAxis &axis : curves.list())
        for (const int number : axis.unknowns)
          result.push_back(values[number]);
    return result;
  }

  std::vector<double>
  StrutProximity::by_number(const std::vector<double> &values) const
  {
    if (values.empty())
      return {};
    std::vector<double> result(model.numbering.layout().n_global(), 0.);
    std::size_t         next = 0;
    for (const ContactAxis &axis : curves.list())
      for (const int number : axis.unknowns)
        result[number] = values[next++];
    return result;
  }

  void StrutProximity::add_values(const Connected     &pair,
                                  std::vector<double> &values)
  {
    values.insert(values.end(),
                  {pair.turning_left[0],
                   pair.turning_left[1],
                   double(pair.is_near)});
  }

  StrutProximity::Connected
  StrutProximity::connected_at(const std::vector<double> &values,
                               const std::size_t          k)
  {
    return {{{values[3 * k], values[3 * k + 1]}}, values[3 * k + 2] != 0};
  }

  void StrutProximity::save(Records &records) const
  {
    std::vector<double> pairs, of_connected;
    for (const Reach &pair : in_reach)
      for (const double value : {double(pair.pair[0]),
                                 double(pair.pair[1]),
                                 pair.due,
                                 double(pair.is_near)})
        pairs.push_back(value);
    for (const Connected &pair : connected)
      add_values(pair, of_connected);
    records.keep(travel_record, {travelled, list_due, double(touches_soon)});
    keep_list(pairs_record, pairs, records);
    keep_list(connected_record, of_connected, records);
    keep_list(turned_record, turned_at, records);
    keep_list(looked_record, by_axis(looked), records);
  }

  void StrutProximity::resume(const Records &records)
  {
    const std::vector<double> travel = records.values(travel_record, 3);
    travelled                        = travel[0];
    list_due                         = travel[1];
    const std::vector<double> pairs  = kept_list(pairs_record, records);
    in_reach.clear();
    for (std::size_t i = 0; i + 3 < pairs.size(); i += 4)
      in_reach.push_back({{{static_cast<unsigned int>(pairs[i]),
                            static_cast<unsigned int>(pairs[i + 1])}},
                          pairs[i + 2],
                          pairs[i + 3] != 0});
    touches_soon = travel[2] != 0;
    const std::vector<double> of_connected =
      kept_list(connected_record, records);
    for (unsigned int i = 0; i < connected.size(); ++i)
      connected[i] = connected_at(of_connected, i);
    turned_at = kept_list(turned_record, records);
    for (unsigned int a = 0; a < allowed_turning.size(); ++a)
      {
        allowed_turning[a] = turning_allowed(a);
        turning_due[a]     = std::min(turning_due[a], travelled);
      }
    looked = by_number(kept_list(looked_record, records));
    near_pairs.clear();
    collect_near(looked);
  }
} // namespace auxfem
