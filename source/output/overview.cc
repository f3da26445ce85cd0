#include <auxfem/model/supports.h>
#include <auxfem/output/console.h>
#include <auxfem/output/line_graphics.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/text.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace auxfem
{
  namespace
  {
    void list_effects(std::ostream                      &stream,
                      const std::string                 &title,
                      const std::vector<EffectDecision> &decisions,
                      const bool                         on)
    {
      std::size_t width = 0;
      for (const EffectDecision &decision : decisions)
        width = std::max(width, decision.name.size());

      bool is_first = true;
      for (const EffectDecision &decision : decisions)
        if (decision.on == on)
          {
            if (is_first)
              stream << '\n' << title << '\n';
            is_first = false;
            stream << "  " << decision.name
                   << std::string(width - decision.name.size() + 2, ' ')
                   << decision.reason << '\n';
          }
    }

    /** Text on the elements of the struts, with their number if it varies. */
    std::string divisions_text(const Counts &counts)
    {
      if (counts.struts_of_division.empty())
        return "";
      if (counts.struts_of_division.size() == 1)
        return " of order " +
          std::to_string(counts.struts_of_division.begin()->first.order);
      const unsigned int first_number =
        counts.struts_of_division.begin()->first.n_elements;
      const bool are_equally_many =
        std::all_of(counts.struts_of_division.begin(),
                    counts.struts_of_division.end(),
                    [&](const auto &entry) {
                      return entry.first.n_elements == first_number;
                    });
      std::string text;
      for (const auto &[division, n] : counts.struts_of_division)
        {
          text += (text.empty() ? ": " : ", ") + std::to_string(n) +
            (text.empty() ? " struts of order " : " of order ") +
            std::to_string(division.order);
          if (!are_equally_many && division.n_elements > 1)
            text +=
              " with " + std::to_string(division.n_elements) + " elements";
        }
      return text;
    }
    /** Lines on MassAndSize. */
    std::string text_of(const MassAndSize &found, const bool is_infinite)
    {
      std::ostringstream text;
      text.precision(4);
      const dealii::Tensor<1, 3> &size = found.size;
      text << "  Size          " << size[0] << " x " << size[1];
      if (size[2] > 0)
        text << " x " << size[2];
      text << " m\n";
      if (found.mass)
        text << "  Mass          " << *found.mass << " kg\n";
      if (found.relative_density)
        text << "  Struts fill   "
             << percentage_text(*found.relative_density, 3)
             << (is_infinite ? " of the volume of a period\n"
                             : " of the volume of this size\n");
      std::string sections;
      for (const auto &[section, n_struts] : found.struts_of_section)
        sections += (sections.empty() ? "" : ", ") + section + " " +
          std::to_string(n_struts);
      if (found.struts_of_section.size() > 1)
        text << indented("Struts by section: " + sections) << '\n';
      return text.str();
    }
  } // namespace

  std::string heading_text(const Scene &scene)
  {
    std::string text = "auxfem " + version_text() + "\n" + scene.file;
    if (!scene.title.empty())
      text += ": " + scene.title;
    return text;
  }

  std::string overview_text(const Scene                       &scene,
                            const Counts                      &counts,
                            const std::vector<EffectDecision> &decisions,
                            const std::vector<std::string>    &notes)
  {
    std::ostringstream stream;
    stream << heading_text(scene) << "\n\n";

    const auto line = [&stream](const std::string &name,
                                const unsigned int value,
                                const std::string &remark = "") {
      const std::string number = std::to_string(value);
      stream << "  " << name << std::string(14 - name.size(), ' ')
             << std::string(std::max<int>(0, 10 - number.size()), ' ') << number
             << remark << '\n';
    };
    line("Joints", counts.joints);
    line("Struts", counts.struts);
    line("Elements", counts.elements, divisions_text(counts));
    line("Connectors", counts.connectors);
    if (counts.rigid_parts > 0)
      line("Rigid parts", counts.rigid_parts);
    if (counts.constraints > 0)
      line("Constraints", counts.constraints);
    line("Unknowns",
         counts.unknowns,
         counts.constraints == 0
           ? ", " + std::to_string(counts.free_unknowns) + " of them free"
           : ", " + std::to_string(counts.free_unknowns) +
             " of them free motions, which leaves " +
             std::to_string(int(counts.free_unknowns) -
                            int(counts.constraints)) +
             " degrees of freedom");
    line("MPI ranks", counts.ranks);
    stream << text_of(counts.mass_and_size, scene.lattice.is_infinite);

    list_effects(stream, "Simulated", decisions, true);
    list_effects(stream, "Left out", decisions, false);
    for (const std::string &note : notes)
      stream << "\nNote\n" << indented(note) << '\n';
    std::string text = stream.str();
    text.pop_back();
    return text;
  }

  namespace
  {
    const std::vector<GraphicsField> lattice_fields = {{"strut", 1, ""},
                                                       {"rigid_part", 1, ""},
                                                       {"connectors", 1, ""},
                                                       {"cell", 1, ""},
                                                       {"section", 1, ""},
                                                       {"area", 1, "m2"},
                                                       {"height", 1, "m"},
                                                       {"width", 1, "m"},
                                                       {"radius", 1, "m"},
                                                       {"youngs_modulus",
                                                        1,
                                                        "Pa"},
                                                       {"density", 1, "kg/m3"}};

    /** Marks "none" among the numbers of lattice_fields. */
    constexpr float none = -1;

    /** Points on a strut: both ends, more if it is curved or tapered. */
    constexpr unsigned int n_points_of_curves = 17;

    void add_strut(const LatticeModel &model,
                   unsigned int        number,
                   LineGraphics       &file)
    {
      const Lattice &lattice    = model.lattice;
      const Strut   &strut      = lattice.struts[number];
      const auto    *definition = strut.section == invalid_index
           ? nullptr
           : &model.plan.scene.sections[strut.section];
      const bool     varies     = strut.sagitta != 0 ||
        (definition != nullptr && definition->section.taper);
      const unsigned int            n = varies ? n_points_of_curves : 2;
      std::vector<dealii::Point<3>> points(n);
      std::vector<float>            values;
      dealii::Tensor<1, 3>          tangent;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double s = double(i) / (n - 1);
          lattice.axis(strut, s, points[i], tangent);
          const Section section =
            definition == nullptr ? Section() : definition->section.at(s);
          values.push_back(number);
          values.push_back(strut.is_rigid() ? strut.rigid_part : none);
          values.push_back(none);
          values.push_back(strut.cell);
          values.push_back(definition == nullptr ? none : definition->number);
          for (const double value : {section.area,
                                     2 * section.half_thicknesses[1],
                                     2 * section.half_thicknesses[0],
                                     section.radius,
                                     section.youngs_modulus,
                                     section.density})
            values.push_back(value);
        }
      file.add_line(points, values);
    }

    void add_connectors(const LatticeModel &model, LineGraphics &file)
    {
      for (unsigned int group = 0; group < model.connector_pairs.size();
           ++group)
        for (const JointPair &pair : model.connector_pairs[group])
          if (pair.second != invalid_index)
            {
              std::vector<float> values;
              for (unsigned int end = 0; end < 2; ++end)
                {
                  for (const float value :
                       {none, none, float(group), float(pair.cell), none})
                    values.push_back(value);
                  values.resize(values.size() + 6);
                }
              file.add_line({model.lattice.joints[pair.first],
                             model.lattice.joints[pair.second]},
                            values);
            }
    }

    /** Writes the lattice at rest to @p file. Throws InputError on failure. */
    void write_lattice(const LatticeModel &model, const std::string &file)
    {
      LineGraphics graphics(lattice_fields);
      for (unsigned int i = 0; i < model.lattice.struts.size(); ++i)
        add_strut(model, i, graphics);
      add_connectors(model, graphics);
      if (!graphics.write_file(file))
        throw InputError("Cannot write " + file +
                         ".\nChoose another folder with Output/Directory or "
                         "--output DIR.");
    }
  } // namespace

  void show_lattice(const Scene &scene, const Equations &equations)
  {
    const LatticeModel &model    = equations.model();
    const MPI_Comm      on_ranks = model.numbering.layout().communicator();
    const Counts        counts   = count(equations);
    on_first_rank(on_ranks, [&]() {
      std::cout << overview_text(scene,
                                 counts,
                                 model.plan.simulated.decisions,
                                 notes_on(equations))
                << std::endl;
      const std::string folder = scene.output.directory;
      std::error_code   error;
      std::filesystem::create_directories(folder, error);
      write_lattice(model, folder + "/lattice.vtu");
      std::cout << "\nThe lattice at rest is in " << folder << "/lattice.vtu"
                << std::endl;
    });
  }
} // namespace auxfem
