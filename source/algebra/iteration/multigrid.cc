#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/shared_work.h>

#include <deal.II/base/mpi.h>

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_SmootherBase.hpp>

#include <limits>
#include <map>
#include <stdexcept>

#include "tpetra_types.h"

namespace auxfem
{
  namespace
  {
    using Teuchos::ParameterList;
    using Teuchos::RCP;
    using Teuchos::rcp;

    using Level        = MueLu::Level;
    using Map          = TpetraMatrix::map_type;
    using XMatrix      = Xpetra::Matrix<double,
                                   Map::local_ordinal_type,
                                   Map::global_ordinal_type,
                                   Map::node_type>;
    using XMultiVector = Xpetra::MultiVector<double,
                                             Map::local_ordinal_type,
                                             Map::global_ordinal_type,
                                             Map::node_type>;
    using Smoother     = MueLu::SmootherBase<double>;
    using Utilities    = MueLu::Utilities<double>;

    /**
     * Exact solution on the coarsest level, the same on all ranks: it is so
     * small that all of them can have all of it. Amesos2, which MueLu would
     * use, returns wrong solutions on several ranks (Trilinos 13.2, KLU2).
     */
    class CoarseSolver : public Smoother
    {
    public:
      CoarseSolver(const TpetraMatrix &matrix, const unsigned int block_size)
        : communicator(*Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(
                          matrix.getComm())
                          ->getRawMpiComm())
        , rows_of_ranks(matrix.getNodeNumRows(), communicator)
      {
        const Rows rows = rows_of(matrix);
        for (const long long global : rows.globals)
          number.emplace(global, number.size());
        layout   = std::make_unique<UnknownLayout>(MPI_COMM_SELF,
                                                 number.size(),
                                                 std::vector<int>());
        unknowns = std::make_unique<Unknowns>(*layout);
        unknowns->positions =
          std::make_shared<const std::vector<dealii::Point<3>>>();
        unknowns->components.resize(block_size);
        for (unsigned int row = 0; row < number.size(); ++row)
          unknowns->joint[row] = row / block_size;
        elimination = std::make_unique<JointElimination>(
          *unknowns,
          std::numeric_limits<unsigned int>::max(),
          std::numeric_limits<std::size_t>::max());
        if (!elimination->factorize(make_matrix(rows)))
          throw std::runtime_error("the coarsest level is singular");
      }

      void Apply(XMultiVector       &x,
                 const XMultiVector &right_side,
                 const bool /*starts_at_zero*/) const override
      {
        const auto          data = right_side.getData(0);
        std::vector<double> all(layout->n_owned());
        rows_of_ranks.gather(data.get(), sizeof(double), all.data());
        elimination->reduce(all.data(), nullptr);
        elimination->expand(nullptr, all.data());
        std::copy_n(all.begin() + rows_of_ranks.first[rank()],
                    data.size(),
                    x.getDataNonConst(0).begin());
      }

      std::size_t getNodeSmootherComplexity() const override
      {
        return Teuchos::OrdinalTraits<std::size_t>::invalid();
      }

    private:
      struct Rows
      {
        std::vector<long long>   globals, columns;
        std::vector<std::size_t> sizes;
        std::vector<double>      entries;
      };

      unsigned int rank() const
      {
        return dealii::Utilities::MPI::this_mpi_process(communicator);
      }

      /** Of all ranks. Collective. */
      Rows rows_of(const TpetraMatrix &matrix) const
      {
        Rows        rows;
        const auto &row_map    = *matrix.getRowMap(),
                   &column_map = *matrix.getColMap();
        for (unsigned int row = 0; row < matrix.getNodeNumRows(); ++row)
          {
            TpetraMatrix::local_inds_host_view_type columns;
            TpetraMatrix::values_host_view_type     entries;
            matrix.getLocalRowView(row, columns, entries);
            rows.globals.push_back(row_map.getGlobalElement(row));
            rows.sizes.push_back(columns.extent(0));
            for (std::size_t i = 0; i < columns.extent(0); ++i)
              {
                rows.columns.push_back(column_map.getGlobalElement(columns[i]));
                rows.entries.push_back(entries[i]);
              }
          }
        rows.globals = of_all_ranks(rows.globals, communicator);
        rows.columns = of_all_ranks(rows.columns, communicator);
        rows.sizes   = of_all_ranks(rows.sizes, communicator);
        rows.entries = of_all_ranks(rows.entries, communicator);
        return rows;
      }

      SparseMatrix make_matrix(const Rows &rows) const
      {
        SparseMatrix matrix(*layout);
        unsigned int row  = 0;
        std::size_t  next = 0;
        for (const std::size_t size : rows.sizes)
          {
            std::map<int, double> sorted;
            for (std::size_t i = 0; i < size; ++i, ++next)
              sorted[number.at(rows.columns[next])] = rows.entries[next];
            for (const auto &[column, entry] : sorted)
              {
                matrix.columns.push_back(column);
                matrix.entries.push_back(entry);
              }
            matrix.first[++row] = matrix.columns.size();
          }
        return matrix;
      }

      MPI_Comm                          communicator;
      ItemsOfRanks                      rows_of_ranks;
      std::map<long long, int>          number;
      std::unique_ptr<UnknownLayout>    layout;
      std::unique_ptr<Unknowns>         unknowns;
      std::unique_ptr<JointElimination> elimination;
    };

    RCP<TpetraVectors> make_near_null_space(const JointRows    &rows,
                                            const TpetraMatrix &matrix)
    {
      const auto modes = rows.rigid_body_modes();
      auto vectors = rcp(new TpetraVectors(matrix.getRowMap(), modes.size()));
      for (unsigned int mode = 0; mode < modes.size(); ++mode)
        std::copy(modes[mode].begin(),
                  modes[mode].end(),
                  vectors->getDataNonConst(mode).begin());
      return vectors;
    }

    /**
     * Chebyshev smoothing does the same on any number of ranks. With MueLu's
     * own bounds of eigenvalues conjugate gradients break down. Aggregates of
     * at most 6 joints instead of 4 cost a quarter less a solution in the plane
     * (60 x 60 cells of prm/star-10x10.prm in statics: 21 iterations either
     * way), in space a seventh more iterations (prm/lattice-3d.prm, 6 cells a
     * side, four ranks: 38 and 34). Keeping the hierarchy's structure for the
     * next matrix was measured and saves a tenth of a factorization at most.
     */
    ParameterList settings(const unsigned int block_size)
    {
      ParameterList list;
      list.set("verbosity", "none");
      list.set("multigrid algorithm", "sa");
      list.set("number of equations", static_cast<int>(block_size));
      list.set("coarse: max size", 1000);
      list.set("coarse: type", "none");
      list.set("aggregation: max agg size", block_size == 3 ? 6 : 4);
      list.set("smoother: type", "CHEBYSHEV");
      ParameterList &smoother = list.sublist("smoother: params");
      smoother.set("chebyshev: degree", 4);
      smoother.set("chebyshev: ratio eigenvalue", 20.);
      smoother.set("chebyshev: eigenvalue max iterations", 30);
      smoother.set("chebyshev: boost factor", 1.2);
      return list;
    }
  } // namespace

  RCP<TpetraOperator> make_multigrid(const RCP<TpetraMatrix> &matrix,
                                     const JointRows         &rows)
  {
    ParameterList list = settings(rows.block_size());
    list.sublist("user data")
      .set("Nullspace", make_near_null_space(rows, *matrix));
    const auto multigrid =
      MueLu::CreateTpetraPreconditioner(RCP<TpetraOperator>(matrix), list);
    auto  &hierarchy = *multigrid->GetHierarchy();
    Level &coarsest  = *hierarchy.GetLevel(hierarchy.GetNumLevels() - 1);
    const RCP<Smoother> solver =
      rcp(new CoarseSolver(*Utilities::Op2NonConstTpetraCrs(
                             coarsest.Get<RCP<XMatrix>>("A")),
                           rows.block_size()));
    coarsest.Set("PreSmoother", solver, MueLu::NoFactory::get());
    return multigrid;
  }
} // namespace auxfem
