#include <auxfem/equations/effects/contact.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/output/contact_graphics.h>

namespace auxfem
{
  namespace
  {
    void append_vector(std::vector<float>         &values,
                       const dealii::Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        values.push_back(vector[d]);
    }

    double size_of(const Lattice &lattice)
    {
      const auto [low, high] = bounding_box(lattice);
      return low.distance(high);
    }

    const std::vector<GraphicsField> contact_fields = {{"displacement", 3, "m"},
                                                       {"force", 3, "N"},
                                                       {"gap", 1, "m"},
                                                       {"strut", 1, ""},
                                                       {"plate", 1, ""},
                                                       {"other_strut", 1, ""}};

    const std::vector<GraphicsField> plate_fields = {{"displacement", 3, "m"},
                                                     {"force", 3, "N"},
                                                     {"plate", 1, ""}};
  } // namespace

  ContactGraphics::ContactGraphics(const Equations   &equations,
                                   const std::string &folder,
                                   const std::string &prefix)
    : equations(equations)
    , plates(equations.reporting().plates)
    , struts(equations.reporting().strut_contact)
    , size(size_of(equations.model().lattice))
    , folder(folder)
    , contacts_name(prefix + "contacts")
  {
    if (!plates)
      return;
    start_contacts();
    plate_series.emplace(folder,
                         prefix + "plates",
                         equations.unknowns().layout.communicator());
  }

  void ContactGraphics::start_contacts()
  {
    contact_series.emplace(folder,
                           contacts_name,
                           equations.unknowns().layout.communicator());
  }

  std::vector<std::string> ContactGraphics::series() const
  {
    std::vector<std::string> names = {contacts_name};
    if (plate_series)
      names.push_back(plate_series->series_name());
    return names;
  }

  void ContactGraphics::write(const Solution &solution)
  {
    write_contacts(solution);
    if (plate_series)
      write_plates(solution);
  }

  void ContactGraphics::write_contacts(const Solution &solution)
  {
    LineGraphics graphics(contact_fields);
    bool         touches = false;
    const auto   add =
      [&](const auto &report, const double plate, const double other_strut) {
        touches = true;
        std::vector<float> values;
        for (unsigned int end = 0; end < 2; ++end)
          {
            append_vector(values, report.displacement);
            append_vector(values, report.force);
            for (const double value :
                 {-report.depth, double(report.strut), plate, other_strut})
              values.push_back(value);
          }
        graphics.add_line({report.rest, report.rest - report.to_face}, values);
      };
    constexpr double none = -1;
    if (plates)
      for (const ContactReport &report :
           plates->contacts(equations.plate_results(solution.results),
                            solution.state))
        add(report, report.other, none);
    if (struts)
      for (const ContactReport &report :
           struts->contacts(equations.strut_contact_results(solution.results),
                            solution.state))
        add(report, none, report.other);
    // Without plates, the first file is that of the first touch.
    if (!contact_series)
      {
        if (equations.unknowns().layout.largest(touches ? 1. : 0.) == 0)
          return;
        start_contacts();
      }
    contact_series->write(graphics, solution.state.time);
  }

  void ContactGraphics::write_plates(const Solution &solution)
  {
    LineGraphics                   graphics(plate_fields);
    std::vector<float>             values;
    const std::vector<PlateReport> reports =
      plates->reports(equations.plate_results(solution.results),
                      solution.state);
    const bool writes = equations.model().numbering.layout().rank() == 0;
    for (unsigned int i = 0; i < reports.size() && writes; ++i)
      for (const auto &line : plates->outline(i, size))
        {
          values.clear();
          for (std::size_t k = 0; k < line.size(); ++k)
            {
              append_vector(values, reports[i].displacement);
              append_vector(values, reports[i].force);
              values.push_back(i);
            }
          graphics.add_line(line, values);
        }
    plate_series->write(graphics, solution.state.time);
  }

  void ContactGraphics::serialize(CheckpointArchive &archive)
  {
    if (!contact_series && GraphicsSeries::is_in(archive, contacts_name))
      start_contacts();
    if (contact_series)
      contact_series->serialize(archive);
    if (plate_series)
      plate_series->serialize(archive);
  }
} // namespace auxfem
