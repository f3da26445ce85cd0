#include <auxfem/analysis/saved_matrix.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>

#include <map>
#include <utility>

namespace auxfem
{
  namespace
  {
    const std::string diagonal = ": further diagonal";

    /** Serial numbers of the unknowns of a block; -1: not there. */
    std::vector<double> numbers_of(const TangentPattern &pattern,
                                   const std::size_t     block,
                                   const UnknownRecords &unknowns)
    {
      std::vector<double> numbers;
      for (const int *unknown = pattern.begin(block);
           unknown != pattern.end(block);
           ++unknown)
        numbers.push_back(
          *unknown < 0 ? -1. : double(unknowns.serial_number(*unknown)));
      return numbers;
    }

    /** On lower ranks. */
    unsigned int number_of_blocks_before(const TangentPattern &pattern,
                                         const DofNumbering   &numbering)
    {
      const unsigned int mine   = pattern.n_blocks();
      unsigned int       before = 0; // which the first rank gets nothing into
      MPI_Exscan(&mine,
                 &before,
                 1,
                 MPI_UNSIGNED,
                 MPI_SUM,
                 numbering.layout().communicator());
      return numbering.layout().rank() == 0 ? 0 : before;
    }

    std::string name_of_blocks(const std::string &name, const unsigned int n)
    {
      return name + ": blocks of " + std::to_string(n) + " unknowns";
    }

    /** Values of blocks with the same unknowns, in the order they come. */
    using BlockValues = std::multimap<std::vector<double>, const double *>;
  } // namespace

  void save_matrix(const std::string   &name,
                   const TangentMatrix &matrix,
                   const DofNumbering  &numbering,
                   Records             &records)
  {
    const TangentPattern &pattern = matrix.pattern();
    const UnknownRecords  unknowns(numbering, pattern.unknowns().layout);
    // Blocks that several ranks have are kept by each, as different items.
    const unsigned int first = number_of_blocks_before(pattern, numbering);
    std::map<unsigned int, std::vector<unsigned int>> items;
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      items[pattern.size(block)].push_back(first + block);
    for (auto &[n, of_size] : items)
      {
        std::vector<double> values;
        values.reserve(of_size.size() * (n + n * n));
        for (const unsigned int item : of_size)
          {
            const unsigned int        block = item - first;
            const std::vector<double> numbers =
              numbers_of(pattern, block, unknowns);
            const double *const entries = matrix.values(block);
            values.insert(values.end(), numbers.begin(), numbers.end());
            values.insert(values.end(), entries, entries + n * n);
          }
        records.keep(name_of_blocks(name, n),
                     std::move(of_size),
                     n + n * n,
                     std::move(values));
      }
    if (!matrix.added_diagonal().empty())
      unknowns.keep(name + diagonal, matrix.added_diagonal(), records);
  }

  void resume_matrix(const std::string  &name,
                     const DofNumbering &numbering,
                     const Records      &records,
                     TangentMatrix      &matrix)
  {
    const TangentPattern &pattern = matrix.pattern();
    const UnknownRecords  unknowns(numbering, pattern.unknowns().layout);
    matrix.reset();
    std::map<unsigned int, std::vector<double>> values;
    std::map<unsigned int, BlockValues>         blocks;
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const unsigned int n = pattern.size(block);
        if (values.count(n) == 0)
          {
            const std::string of_size = name_of_blocks(name, n);
            values[n] =
              records.values(of_size, records.items(of_size), n + n * n);
            for (auto item = values[n].begin(); item != values[n].end();
                 item += n + n * n)
              blocks[n].emplace(std::vector<double>(item, item + n),
                                &*item + n);
          }
        const auto found = blocks[n].find(numbers_of(pattern, block, unknowns));
        if (found == blocks[n].end())
          throw InputError(
            "What the run is to go on from has no matrix of these struts and "
            "connectors: it was left by another scene. Go on with that one, or "
            "start from t = 0.");
        matrix.set(block, found->second);
        blocks[n].erase(found);
      }
    if (records.has(name + diagonal))
      {
        Vector of_owned = unknowns.values(name + diagonal, records);
        of_owned.resize(numbering.layout().n_owned());
        matrix.add_to_diagonal(of_owned);
      }
  }
} // namespace auxfem
