#include <auxfem/contact/effects/contact.h>
#include <auxfem/mesh/position_function.h>
#include <auxfem/output/line_graphics.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <new>
#include <sstream>
#include <system_error>

namespace auxfem
{
  namespace
  {
    /** Digits of the number in a file name. */
    constexpr unsigned int n_digits = 5;

    const std::string record_head =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" "
      "ByteOrder=\"LittleEndian\">\n"
      "  <Collection>\n";

    const std::string record_tail = "  </Collection>\n"
                                    "</VTKFile>\n";

    /**
     * Text of a file without lines; adds the points section, which deal.II
     * omits but VTK requires.
     */
    std::string text_without_lines(const LineGraphics &graphics)
    {
      std::ostringstream stream;
      graphics.write_vtu(stream);
      std::string       text  = stream.str();
      const std::string cells = "<Cells>";
      text.insert(text.find(cells),
                  "<Points>\n"
                  "<DataArray type=\"Float32\" NumberOfComponents=\"3\">"
                  "</DataArray>\n"
                  "</Points>\n");
      return text;
    }
  } // namespace

  LineGraphics::LineGraphics(const std::vector<GraphicsField> &fields)
    : fields(fields)
  {
    set_time(0, 0);
  }

  unsigned int LineGraphics::n_components() const
  {
    unsigned int n = 0;
    for (const GraphicsField &field : fields)
      n += field.n_components;
    return n;
  }

  void LineGraphics::add_line(const std::vector<dealii::Point<3>> &points,
                              const std::vector<float>            &values)
  {
    const unsigned int n = n_components();
    Assert(points.size() >= 2, dealii::ExcInternalError());
    AssertDimension(values.size(), n * points.size());

    Patch patch;
    patch.vertices[0]    = points.front();
    patch.vertices[1]    = points.back();
    patch.patch_index    = patches.size();
    patch.n_subdivisions = points.size() - 1;
    patch.reference_cell = dealii::ReferenceCells::Line;
    // The points follow the fields as three more rows; otherwise deal.II draws
    // the chord of a curved line.
    patch.points_are_available = true;
    patch.data.reinit(n + 3, points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        for (unsigned int i = 0; i < n; ++i)
          patch.data(i, q) = values[q * n + i];
        for (unsigned int d = 0; d < 3; ++d)
          patch.data(n + d, q) = points[q][d];
      }
    patches.push_back(std::move(patch));
  }

  bool LineGraphics::write_file(const std::string &file) const
  {
    std::ofstream stream = open_output_file(file);
    if (!stream)
      return false;
    try
      {
        write_vtu(stream);
      }
    catch (const dealii::ExceptionBase &)
      {
        return false;
      }
    stream.close();
    return bool(stream);
  }

  void LineGraphics::set_time(const double time, const unsigned int number)
  {
    dealii::DataOutBase::VtkFlags flags;
    flags.time                = time;
    flags.cycle               = number;
    flags.print_date_and_time = false;
    flags.compression_level   = decltype(flags.compression_level)::best_speed;
    for (const GraphicsField &field : fields)
      if (!field.unit.empty())
        flags.physical_units[field.name] = field.unit;
    set_flags(flags);
  }

  std::vector<std::string> LineGraphics::get_dataset_names() const
  {
    std::vector<std::string> names;
    for (const GraphicsField &field : fields)
      names.insert(names.end(), field.n_components, field.name);
    return names;
  }

  std::vector<std::tuple<
    unsigned int,
    unsigned int,
    std::string,
    dealii::DataComponentInterpretation::DataComponentInterpretation>>
  LineGraphics::get_nonscalar_data_ranges() const
  {
    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
                 ranges;
    unsigned int first = 0;
    for (const GraphicsField &field : fields)
      {
        if (field.n_components == 3)
          ranges.emplace_back(
            first,
            first + 2,
            field.name,
            dealii::DataComponentInterpretation::component_is_part_of_vector);
        first += field.n_components;
      }
    return ranges;
  }

  GraphicsSeries::GraphicsSeries(const std::string &folder,
                                 const std::string &name,
                                 const MPI_Comm     communicator)
    : folder(folder)
    , name(name)
    , communicator(communicator)
  {
    on_first_rank(communicator, [&]() {
      const std::string subfolder = folder + "/" + name;
      if (const std::error_code error = make_output_subfolder(subfolder))
        throw InputError("Cannot make the folder " + subfolder + ": " +
                         output_error_text(error.value()) +
                         ".\nRemove the obstacle, or choose another "
                         "folder with Output/Directory or --output DIR.");
    });
  }

  void GraphicsSeries::write(LineGraphics &graphics, const double time)
  {
    graphics.set_time(time, n_written);

    std::string file;
    bool        failed = false;
    errno              = 0;
    try
      {
        file = write_pieces(graphics);
      }
    catch (const dealii::ExceptionBase &)
      {
        // A stream reports a lack of memory as its own failure.
        if (errno == ENOMEM)
          throw std::bad_alloc();
        failed = true;
      }
    if (dealii::Utilities::MPI::max(failed ? 1 : 0, communicator) > 0)
      throw ComputationError("Cannot write graphics file number " +
                             std::to_string(n_written) + " in " + folder + "/" +
                             name +
                             ": the disk is full or the folder is gone.\n"
                             "Earlier files are complete.");

    ++n_written;
    on_first_rank(communicator,
                  [&]() { append_to_record(time, name + "/" + file); });
  }

  std::string GraphicsSeries::record_name(const std::string &series)
  {
    return "graphics: files of " + series;
  }

  bool GraphicsSeries::is_in(const CheckpointArchive &archive,
                             const std::string       &series)
  {
    return !archive.is_saving() && archive.has(record_name(series));
  }

  void GraphicsSeries::serialize(CheckpointArchive &archive)
  {
    archive.values(record_name(name), n_written, end_of_entries);
    if (archive.is_saving())
      return;
    on_first_rank(communicator, [&]() {
      const std::string record = folder + "/" + name + ".pvd";
      std::error_code   error;
      if (end_of_entries > 0 &&
          (std::filesystem::file_size(record, error) <
             static_cast<std::uintmax_t>(end_of_entries) ||
           error))
        throw InputError(record +
                         " differs from the file that the run has written. "
                         "Restore it, or start from t = 0.");
      restore_record(record);
      remove_later_files();
    });
  }

  void GraphicsSeries::remove_later_files() const
  {
    // NAME_NUMBER.vtu, .pvtu or .RANK.vtu
    const std::string begin = name + "_";
    std::error_code   ignored;
    for (const auto &entry :
         std::filesystem::directory_iterator(folder + "/" + name, ignored))
      {
        const std::string file = entry.path().filename();
        if (file.compare(0, begin.size(), begin) == 0 &&
            std::strtoul(file.c_str() + begin.size(), nullptr, 10) >= n_written)
          std::filesystem::remove(entry.path(), ignored);
      }
  }

  std::string GraphicsSeries::write_pieces(LineGraphics &graphics) const
  {
    const std::string subfolder = folder + "/" + name + "/";
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      return graphics.write_vtu_with_pvtu_record(subfolder,
                                                 name,
                                                 n_written,
                                                 communicator,
                                                 n_digits);

    const std::string file = name + "_" +
      dealii::Utilities::int_to_string(n_written, n_digits) + ".vtu";
    std::ofstream stream = open_output_file(subfolder + file);
    if (graphics.empty())
      stream << text_without_lines(graphics);
    else
      graphics.write_vtu(stream);
    stream.close();
    AssertThrow(stream, dealii::ExcIO());
    return file;
  }

  void GraphicsSeries::append_to_record(const double       time,
                                        const std::string &file)
  {
    std::ostringstream entry;
    entry << std::setprecision(12) << "    <DataSet timestep=\"" << time
          << "\" group=\"\" part=\"0\" file=\"" << file << "\"/>\n";

    const std::string record   = folder + "/" + name + ".pvd";
    const bool        is_first = end_of_entries == 0;
    const auto        mode     = std::ios::out | std::ios::binary;
    std::ofstream     stream =
      open_output_file(record, is_first ? mode : mode | std::ios::in);
    stream.seekp(end_of_entries);
    const std::string head = is_first ? record_head : "";
    // A single write keeps the record complete at any moment.
    stream << head + entry.str() + record_tail;
    stream.close();
    if (stream)
      {
        end_of_entries += head.size() + entry.str().size();
        return;
      }

    restore_record(record);
    throw ComputationError("Cannot write " + record +
                           ": the disk is full or the folder is gone.");
  }

  void GraphicsSeries::restore_record(const std::string &record) const
  {
    std::error_code ignored;
    if (end_of_entries == 0)
      {
        std::filesystem::remove(record, ignored);
        return;
      }
    std::ofstream stream =
      open_output_file(record, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(end_of_entries);
    stream << record_tail;
    stream.close();
    std::filesystem::resize_file(record,
                                 end_of_entries + record_tail.size(),
                                 ignored);
  }

  std::string field_name(const std::string &name)
  {
    std::string result = name;
    for (char &character : result)
      if (!std::isalnum(static_cast<unsigned char>(character)) &&
          character != '-' && character != '_')
        character = '_';
    return result;
  }

  namespace
  {
    void append_vector(std::vector<float>         &values,
                       const dealii::Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        values.push_back(vector[d]);
    }

    double diagonal(const Lattice &lattice)
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
    , size(diagonal(equations.model().lattice))
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
    // Without plates, the series starts with the first contact.
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
