#include <auxfem/equations/contact_axes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** What the rank that owns an element knows of it. */
    struct AxisElement
    {
      unsigned int     strut = 0, order = 1;
      double           begin = 0, end = 1; ///< fractions of the strut's length
      std::vector<int> unknowns;
      bool             is_owned = false;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &strut &order &begin &end &unknowns;
      }
    };

    std::vector<AxisElement>
    elements_of_this_rank(const DofNumbering &numbering)
    {
      const unsigned int       dimension = numbering.lattice().dimension;
      std::vector<AxisElement> mine;
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const DofNumbering::Element &element = numbering.elements()[e];
          if (!element.is_owned)
            continue;
          AxisElement axis{element.interval.strut,
                           element.order,
                           element.interval.begin,
                           element.interval.end,
                           {},
                           true};
          for (unsigned int node = 0; node <= element.order; ++node)
            for (unsigned int c = 0; c < dimension; ++c)
              axis.unknowns.push_back(
                numbering.layout().global(numbering.element_unknowns(
                  e)[node * numbering.n_components() + c]));
          mine.push_back(axis);
        }
      return mine;
    }

    std::vector<AxisElement> rigid_struts(const DofNumbering &numbering)
    {
      const Lattice           &lattice = numbering.lattice();
      std::vector<AxisElement> all;
      for (unsigned int s = 0; s < lattice.struts.size(); ++s)
        if (lattice.struts[s].is_rigid())
          {
            AxisElement axis;
            axis.strut = s;
            for (const unsigned int joint : lattice.struts[s].joints)
              for (unsigned int c = 0; c < lattice.dimension; ++c)
                axis.unknowns.push_back(numbering.global().joints[joint][c]);
            axis.is_owned = numbering.layout().is_owned(
              numbering.layout().local(axis.unknowns.front()));
            all.push_back(axis);
          }
      return all;
    }

    /** Of all ranks, in the order of the struts. Collective. */
    std::vector<AxisElement> all_elements(const DofNumbering &numbering)
    {
      const MPI_Comm           communicator = numbering.layout().communicator();
      std::vector<AxisElement> all          = rigid_struts(numbering);
      std::vector<AxisElement> mine         = elements_of_this_rank(numbering);
      if (numbering.layout().n_ranks() == 1)
        all.insert(all.end(), mine.begin(), mine.end());
      else
        {
          const auto of_ranks =
            dealii::Utilities::MPI::all_gather(communicator, mine);
          for (unsigned int rank = 0; rank < of_ranks.size(); ++rank)
            for (AxisElement element : of_ranks[rank])
              {
                element.is_owned = rank == numbering.layout().rank();
                all.push_back(element);
              }
        }
      std::sort(all.begin(),
                all.end(),
                [](const AxisElement &a, const AxisElement &b) {
                  return std::pair(a.strut, a.begin) <
                    std::pair(b.strut, b.begin);
                });
      return all;
    }

    /** Half the thickness of a strut (m): in the plane that in it, in space the
     * smaller one. */
    double half_thickness(const Section &section, const unsigned int dimension)
    {
      const auto &fibres = section.fibre_distances;
      return dimension == 2 ? fibres[1] : std::min(fibres[0], fibres[1]);
    }

    /** What sections are to contact, and what rigid struts are. */
    class ContactSections
    {
    public:
      ContactSections(const LatticeModel &model, const double factor)
        : model(model)
        , factor(factor)
      {
        for (const Section &section : model.sections)
          if (const double h = half_thickness(section, model.lattice.dimension);
              h > 0)
            stiffest = std::max(stiffest, stiffness(section, h));
      }

      /** Writes half the thickness and the stiffness. */
      void set(ContactAxis &axis) const
      {
        const Strut &strut  = model.lattice.struts[axis.strut];
        axis.half_thickness = 0;
        axis.stiffness      = stiffest;
        if (strut.section == invalid_index)
          return;
        const Section &section = model.sections[strut.section];
        axis.half_thickness = half_thickness(section, model.lattice.dimension);
        if (!strut.is_rigid())
          axis.stiffness = axis.half_thickness > 0
            ? stiffness(section, axis.half_thickness)
            : 0.;
      }

    private:
      /** Of the half of a strut between its axis and its face. */
      double stiffness(const Section &section, const double h) const
      {
        return factor * section.axial_stiffness() / (2 * h * h);
      }

      const LatticeModel &model;
      const double        factor;
      double              stiffest = 0;
    };
  } // namespace

  std::vector<ContactAxis> make_contact_axes(const LatticeModel &model,
                                             const double stiffness_factor)
  {
    const Lattice           &lattice = model.lattice;
    const ContactSections    sections(model, stiffness_factor);
    std::vector<AxisElement> elements = all_elements(model.numbering);
    std::vector<ContactAxis> axes;
    axes.reserve(elements.size());
    for (AxisElement &element : elements)
      {
        const Strut &strut = lattice.struts[element.strut];
        ContactAxis  axis;
        axis.strut    = element.strut;
        axis.begin    = element.begin;
        axis.end      = element.end;
        axis.unknowns = std::move(element.unknowns);
        axis.is_owned = element.is_owned;
        sections.set(axis);
        axis.order  = element.order;
        axis.length = (element.end - element.begin) * lattice.length(strut);
        dealii::Tensor<1, 3> tangent;
        lattice.axis(strut, axis.begin, axis.ends[0], tangent);
        lattice.axis(strut, axis.end, axis.ends[1], tangent);
        axes.push_back(std::move(axis));
      }
    return axes;
  }
} // namespace auxfem
