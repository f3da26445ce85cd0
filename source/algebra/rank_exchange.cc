#include <auxfem/algebra/rank_exchange.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace auxfem
{
  ItemsOfRanks::ItemsOfRanks(const std::size_t n_mine,
                             const MPI_Comm    communicator)
    : sizes(dealii::Utilities::MPI::all_gather(communicator,
                                               static_cast<int>(n_mine)))
    , first(1, 0)
    , communicator(communicator)
  {
    std::partial_sum(sizes.begin(), sizes.end(), std::back_inserter(first));
  }

  ItemsOfRanks::ItemsOfRanks(const UnknownLayout &layout)
    : first(1, 0)
    , communicator(layout.communicator())
  {
    for (unsigned int rank = 0; rank < layout.n_ranks(); ++rank)
      {
        first.push_back(layout.first_of(rank + 1));
        sizes.push_back(first[rank + 1] - first[rank]);
      }
  }

  void ItemsOfRanks::gather(const void       *mine,
                            const std::size_t size,
                            void             *all) const
  {
    if (sizes.size() == 1)
      {
        std::copy_n(static_cast<const char *>(mine),
                    size * n(),
                    static_cast<char *>(all));
        return;
      }
    // A count of bytes might exceed MPI's int.
    const auto item =
      dealii::Utilities::MPI::create_mpi_data_type_n_bytes(size);
    MPI_Allgatherv(
      mine,
      sizes[dealii::Utilities::MPI::this_mpi_process(communicator)],
      *item,
      all,
      sizes.data(),
      first.data(),
      *item,
      communicator);
  }

  std::vector<std::string> gather_texts(const std::string &mine,
                                        const MPI_Comm     communicator)
  {
    const ItemsOfRanks letters(mine.size(), communicator);
    std::string        all(letters.n(), ' ');
    letters.gather(mine.data(), 1, all.data());
    std::vector<std::string> texts;
    for (unsigned int rank = 0; rank < letters.sizes.size(); ++rank)
      texts.push_back(all.substr(letters.first[rank], letters.sizes[rank]));
    return texts;
  }

  std::string broadcast_text(const unsigned int rank,
                             std::string        text,
                             const MPI_Comm     communicator)
  {
    text.resize(
      dealii::Utilities::MPI::broadcast(communicator, text.size(), rank));
    MPI_Bcast(text.data(),
              static_cast<int>(text.size()),
              MPI_CHAR,
              static_cast<int>(rank),
              communicator);
    return text;
  }

  NeighbourExchange::NeighbourExchange(const MPI_Comm     communicator,
                                       const SizesByRank &sent,
                                       const SizesByRank &received)
    : communicator(communicator)
    , sent(sent)
    , received(received)
  {}

  void NeighbourExchange::transfer(const void       *values,
                                   const std::size_t size,
                                   void             *received_values) const
  {
    constexpr int tag = 0;
    // A count of bytes might exceed MPI's int.
    const auto item =
      dealii::Utilities::MPI::create_mpi_data_type_n_bytes(size);
    std::vector<MPI_Request> requests;
    char                    *in = static_cast<char *>(received_values);
    for (const auto &[rank, n] : received)
      {
        MPI_Irecv(in,
                  static_cast<int>(n),
                  *item,
                  static_cast<int>(rank),
                  tag,
                  communicator,
                  &requests.emplace_back());
        in += n * size;
      }
    const char *out = static_cast<const char *>(values);
    for (const auto &[rank, n] : sent)
      {
        MPI_Isend(out,
                  static_cast<int>(n),
                  *item,
                  static_cast<int>(rank),
                  tag,
                  communicator,
                  &requests.emplace_back());
        out += n * size;
      }
    MPI_Waitall(static_cast<int>(requests.size()),
                requests.data(),
                MPI_STATUSES_IGNORE);
  }

  SizesByRank received_sizes(const SizesByRank &sent,
                             const MPI_Comm     communicator)
  {
    int n_ranks = 0;
    MPI_Comm_size(communicator, &n_ranks);
    std::vector<unsigned long> to(n_ranks), from(n_ranks);
    for (const auto &[rank, n] : sent)
      to[rank] = n;
    MPI_Alltoall(to.data(),
                 1,
                 MPI_UNSIGNED_LONG,
                 from.data(),
                 1,
                 MPI_UNSIGNED_LONG,
                 communicator);
    SizesByRank received;
    for (int rank = 0; rank < n_ranks; ++rank)
      if (from[rank] > 0)
        received[rank] = from[rank];
    return received;
  }
} // namespace auxfem
