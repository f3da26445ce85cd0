#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/run_checkpoints.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/version.h>

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream_buffer.hpp>
#include <boost/serialization/map.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <streambuf>
#include <utility>

#include <zlib.h>

namespace auxfem
{
  namespace
  {
    namespace io  = boost::iostreams;
    namespace mpi = dealii::Utilities::MPI;

    const std::string scene_section      = "scene file",
                      parameter_section  = "parameters",
                      input_file_section = "input files",
                      rank_section       = "rank ";

    /**
     * Time between two checkpoints over the time for writing one.
     * @tuned judgement: 0.3 % of the run time
     */
    constexpr unsigned int time_over_cost = 300;

    /** Stream buffer that counts bytes. */
    struct ByteCounter : public std::streambuf
    {
      std::size_t n = 0;

      int_type overflow(const int_type character) override
      {
        ++n;
        return character;
      }

      std::streamsize xsputn(const char * /*bytes*/,
                             const std::streamsize n_bytes) override
      {
        n += n_bytes;
        return n_bytes;
      }
    };

    /** Bytes that @p write writes to an archive, about @p n_bytes. */
    template <class Write>
    std::string bytes_by(const Write &write, const std::size_t n_bytes = 0)
    {
      std::string bytes;
      bytes.reserve(n_bytes);
      io::stream_buffer<io::back_insert_device<std::string>> buffer(bytes);
      {
        // It writes to the buffer until its end.
        boost::archive::binary_oarchive archive(buffer);
        write(archive);
      }
      buffer.close();
      return bytes;
    }

    /** Bytes of @p records; neither the records nor the bytes are copied. */
    std::string bytes_of(CheckpointData records)
    {
      ByteCounter                     counter;
      boost::archive::binary_oarchive counting(counter);
      records.save(counting, /*version=*/0);
      return bytes_by([&](auto &archive) { records.move_to(archive); },
                      counter.n);
    }

    /** Calls @p read with an archive of @p bytes. */
    template <class Read>
    void read_bytes(const std::string &bytes, const Read &read)
    {
      io::stream_buffer<io::array_source> buffer(bytes.data(), bytes.size());
      boost::archive::binary_iarchive     archive(buffer);
      read(archive);
    }

    std::string absolute(const std::string &file)
    {
      std::error_code ignored;
      return std::filesystem::absolute(file, ignored).lexically_normal();
    }

    /** Checksum of a file; zero if it cannot be read. */
    unsigned int checksum(const std::string &file)
    {
      std::ifstream           stream(file, std::ios::binary);
      std::array<char, 65536> block;
      unsigned long           sum = 0;
      while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
        sum = crc32_z(sum,
                      reinterpret_cast<const Bytef *>(block.data()),
                      stream.gcount());
      return sum;
    }

    const std::string &section(const CheckpointContent &content,
                               const std::string       &name)
    {
      for (const CheckpointContent::Section &candidate : content.sections)
        if (candidate.name == name)
          return candidate.bytes;
      throw InputError("The checkpoint has no section `" + name +
                       "`: another version of auxfem has written it.");
    }

    /**
     * Records of this rank, or of all ranks if the number of ranks has changed.
     */
    CheckpointData records_in(const CheckpointContent &content,
                              const MPI_Comm           communicator)
    {
      const auto records_of_rank = [&](const unsigned int rank) {
        CheckpointData records;
        read_bytes(section(content, rank_section + std::to_string(rank)),
                   [&](auto &archive) {
                     records.load(archive, /*version=*/0);
                   });
        return records;
      };
      if (content.n_ranks == mpi::n_mpi_processes(communicator))
        return records_of_rank(mpi::this_mpi_process(communicator));
      CheckpointData all = records_of_rank(0);
      for (unsigned int rank = 1; rank < content.n_ranks; ++rank)
        all.add(records_of_rank(rank));
      return all;
    }
  } // namespace

  std::string changed_input_file(const RestartedRun &run)
  {
    for (const auto &[file, expected] : run.input_files)
      if (checksum(file) != expected)
        return file;
    return "";
  }

  RestartedRun find_run_to_resume(const std::string &folder,
                                  const MPI_Comm     communicator)
  {
    const CheckpointFiles::LoadedCheckpoint found =
      CheckpointFiles(folder).newest();
    const CheckpointContent &content = found.content;
    if (content.program_version != version)
      throw InputError("The checkpoint in " + folder +
                       " was written by auxfem " + content.program_version +
                       ", this is " + version +
                       ". Continue with that version, or start from t = 0.");
    RestartedRun run;
    run.folder     = folder;
    run.scene_file = section(content, scene_section);
    run.parameters = section(content, parameter_section);
    read_bytes(section(content, input_file_section),
               [&](auto &archive) { archive >> run.input_files; });
    run.records = records_in(content, communicator);
    run.warning = found.warning;
    return run;
  }

  RunCheckpoints::RunCheckpoints(const Scene   &scene,
                                 const MPI_Comm communicator)
    : scene(scene)
    , communicator(communicator)
    , files(scene.output.directory)
    , last_write(Clock::now())
  {}

  bool RunCheckpoints::is_due()
  {
    const bool due =
      Clock::now() - last_write >= time_over_cost * write_duration;
    return mpi::n_mpi_processes(communicator) == 1
      ? due
      : mpi::broadcast(communicator, due);
  }

  void RunCheckpoints::write(CheckpointData                  records,
                             const std::vector<std::string> &files_before)
  {
    const auto                     begin       = Clock::now();
    std::string                    local_bytes = bytes_of(std::move(records));
    const std::vector<std::size_t> sizes =
      mpi::gather(communicator, local_bytes.size());
    if (mpi::this_mpi_process(communicator) > 0)
      send_to_first(local_bytes.data(), local_bytes.size(), communicator);
    on_first_rank(communicator, [&]() {
      CheckpointContent content = content_of(std::move(local_bytes));
      for (unsigned int rank = 1; rank < sizes.size(); ++rank)
        {
          std::string bytes(sizes[rank], ' ');
          receive(bytes.data(), bytes.size(), rank, communicator);
          content.sections.push_back(
            {rank_section + std::to_string(rank), std::move(bytes)});
        }
      files.write(content, files_before);
    });
    last_write     = Clock::now();
    write_duration = last_write - begin;
  }

  CheckpointContent RunCheckpoints::content_of(std::string bytes) const
  {
    std::map<std::string, unsigned int> input_files;
    for (const std::string &file : scene.input_files)
      if (const std::string name = absolute(file); name != absolute(scene.file))
        input_files[name] = checksum(name);
    CheckpointContent content;
    content.program_version = version;
    content.n_ranks         = mpi::n_mpi_processes(communicator);
    content.sections        = {{scene_section, absolute(scene.file)},
                               {parameter_section, scene.all_parameters},
                               {input_file_section, bytes_by([&](auto &archive) {
                           archive << input_files;
                         })}};
    // An initializer list would copy the bytes.
    content.sections.push_back({rank_section + "0", std::move(bytes)});
    return content;
  }
} // namespace auxfem
