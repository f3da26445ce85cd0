#include <auxfem/output/notes.h>
#include <auxfem/scene/time_function_notes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Of its length, as thick as a strut may be without a question. */
    constexpr double thickest = 0.25;

    /** Height of the rectangle with the same area and second moment (m): that
     * in the plane, in space the larger one. */
    double thickness(const Section &section, const unsigned int dimension)
    {
      const double second_moment = dimension == 2
        ? section.second_moment_3
        : std::max(section.second_moment_2, section.second_moment_3);
      return std::sqrt(12 * second_moment / section.area);
    }

    void add_thick_sections(const Scene              &scene,
                            const LatticeModel       &model,
                            std::vector<std::string> &notes)
    {
      const Lattice &lattice = model.lattice;
      for (unsigned int s = 0; s < scene.sections.size(); ++s)
        {
          unsigned int shortest = 0;
          double       length   = std::numeric_limits<double>::infinity();
          for (unsigned int i = 0; i < lattice.struts.size(); ++i)
            if (!lattice.struts[i].is_rigid() &&
                lattice.struts[i].section == s &&
                lattice.length(lattice.struts[i]) < length)
              {
                shortest = i;
                length   = lattice.length(lattice.struts[i]);
              }
          const double found =
            thickness(scene.sections[s].section, lattice.dimension);
          if (found <= thickest * length)
            continue;
          std::ostringstream note;
          note << scene.sections[s].path << ": the struts are about " << found
               << " m thick, but strut " << shortest << " is only " << length
               << " m long; beams are meant to be slender. ";
          if (found / 1000 <= thickest * length)
            note << "A number without a unit is in m: was " << found
                 << " mm meant? Then write the unit, or else";
          else
            note << "If that is not what was meant,";
          note << " look at the dimensions of the section and the size of the "
                  "lattice.";
          notes.push_back(note.str());
        }
    }
  } // namespace

  std::vector<std::string> notes_on(const Scene        &scene,
                                    const LatticeModel &model)
  {
    std::vector<std::string> notes;
    if (const std::optional<std::string> on_scheme =
          scene.time.scheme->note_on_rigid_parts();
        on_scheme && model.numbering.constraints().n_multipliers() > 0)
      notes.push_back(*on_scheme);
    for (const std::string &note : time_function_notes(scene))
      notes.push_back(note);
    add_thick_sections(scene, model, notes);
    return notes;
  }
} // namespace auxfem
