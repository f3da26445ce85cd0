#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/joint_order.h>

#include <Ifpack2_Factory.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_SmootherBase.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tpetra_types.h"

namespace auxfem
{
  namespace
  {
    using Teuchos::ParameterList;
    using Teuchos::RCP;
    using Teuchos::rcp;

    using Level        = MueLu::Level;
    using XMatrix      = Xpetra::Matrix<double,
                                   TpetraMap::local_ordinal_type,
                                   TpetraMap::global_ordinal_type,
                                   TpetraMap::node_type>;
    using XMultiVector = Xpetra::MultiVector<double,
                                             TpetraMap::local_ordinal_type,
                                             TpetraMap::global_ordinal_type,
                                             TpetraMap::node_type>;
    using Utilities    = MueLu::Utilities<double>;

    /**
     * The coarsest level, factorized by MUMPS on the first rank. MueLu's
     * default Amesos2 gives wrong solutions on several ranks (Trilinos 13.2,
     * KLU2).
     */
    class CoarsestLevel
    {
    public:
      /** Throws std::runtime_error if @p matrix is singular. Collective. */
      CoarsestLevel(const TpetraMatrix &matrix, const bool is_symmetric)
        : layout(make_layout(matrix))
        , factors(make_mumps(MumpsRanks::first))
      {
        const SparseMatrix rows = copy_rows(matrix, is_symmetric);
        if (factors->analyse(rows) != FactorizationOutcome::done ||
            factors->factorize(rows) != FactorizationOutcome::done)
          throw std::runtime_error("the coarsest level is singular");
      }

      /** Replaces the right-hand side @p x by the solution. Collective. */
      void solve(double *x) const
      {
        factors->solve(x);
      }

      /** Negative eigenvalues of a symmetric level. */
      std::optional<unsigned long> n_negative() const
      {
        const std::optional<Inertia> inertia = factors->inertia();
        return inertia ? std::optional(inertia->negative) : std::nullopt;
      }

    private:
      /** MueLu numbers coarse rows rank by rank, as UnknownLayout does. */
      static UnknownLayout make_layout(const TpetraMatrix &matrix)
      {
        const TpetraMap &rows = *matrix.getRowMap();
        std::vector<int> ghosts;
        for (const auto global : matrix.getColMap()->getNodeElementList())
          if (!rows.isNodeGlobalElement(global))
            ghosts.push_back(global);
        return UnknownLayout(
          *Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(
             matrix.getComm())
             ->getRawMpiComm(),
          matrix.getNodeNumRows(),
          ghosts);
      }

      SparseMatrix copy_rows(const TpetraMatrix &matrix,
                             const bool          is_symmetric) const
      {
        const TpetraMap &columns_of_ranks = *matrix.getColMap();
        SparseMatrix     rows(layout);
        rows.is_symmetric = is_symmetric;
        std::vector<std::pair<int, double>> sorted;
        for (unsigned int row = 0; row < layout.n_owned(); ++row)
          {
            TpetraMatrix::local_inds_host_view_type columns;
            TpetraMatrix::values_host_view_type     entries;
            matrix.getLocalRowView(row, columns, entries);
            sorted.clear();
            for (std::size_t i = 0; i < columns.extent(0); ++i)
              sorted.emplace_back(
                layout.local(columns_of_ranks.getGlobalElement(columns[i])),
                entries[i]);
            std::sort(sorted.begin(), sorted.end());
            for (const auto &[column, entry] : sorted)
              {
                rows.columns.push_back(column);
                rows.entries.push_back(entry);
              }
            rows.first[row + 1] = rows.columns.size();
          }
        return rows;
      }

      const UnknownLayout                 layout;
      const std::unique_ptr<DirectSolver> factors;
    };

    class CoarseSolver : public MueLu::SmootherBase<double>
    {
    public:
      CoarseSolver(const TpetraMatrix &matrix, const bool is_symmetric)
        : level(matrix, is_symmetric)
      {}

      void Apply(XMultiVector       &x,
                 const XMultiVector &right_side,
                 const bool /*starts_at_zero*/) const override
      {
        const auto data   = right_side.getData(0);
        const auto values = x.getDataNonConst(0);
        std::copy(data.begin(), data.end(), values.begin());
        level.solve(values.getRawPtr());
      }

      std::size_t getNodeSmootherComplexity() const override
      {
        return Teuchos::OrdinalTraits<std::size_t>::invalid();
      }

      const CoarsestLevel level;
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
     * Settings of MueLu. Chebyshev smoothing is independent of the number of
     * ranks. The default eigenvalue bounds make conjugate gradients break down.
     * Aggregate and coarse sizes balance the cost and the number of iterations;
     * in space a larger coarsest level would have dense factors.
     */
    ParameterList settings(const unsigned int block_size)
    {
      ParameterList list;
      list.set("verbosity", "none");
      list.set("multigrid algorithm", "sa");
      list.set("number of equations", static_cast<int>(block_size));
      list.set("coarse: max size", block_size == 3 ? 3500 : 1000);
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

  Multigrid make_multigrid(const RCP<TpetraMatrix> &matrix,
                           const JointRows         &rows,
                           const bool               is_symmetric)
  {
    ParameterList list = settings(rows.block_size());
    list.sublist("user data")
      .set("Nullspace", make_near_null_space(rows, *matrix));
    const auto multigrid =
      MueLu::CreateTpetraPreconditioner(RCP<TpetraOperator>(matrix), list);
    auto      &hierarchy = *multigrid->GetHierarchy();
    Level     &coarsest  = *hierarchy.GetLevel(hierarchy.GetNumLevels() - 1);
    const auto solver = rcp(new CoarseSolver(*Utilities::Op2NonConstTpetraCrs(
                                               coarsest.Get<RCP<XMatrix>>("A")),
                                             is_symmetric));
    coarsest.Set("PreSmoother",
                 RCP<MueLu::SmootherBase<double>>(solver),
                 MueLu::NoFactory::get());
    return {multigrid, solver->level.n_negative()};
  }

  Teuchos::RCP<TpetraOperator>
  make_incomplete_factorization(const Teuchos::RCP<TpetraMatrix> &matrix)
  {
    const auto factorization =
      Ifpack2::Factory::create<Tpetra::RowMatrix<double>>("SCHWARZ", matrix);
    Teuchos::ParameterList list;
    list.set("schwarz: overlap level", 1);
    list.set("schwarz: use reordering", true);
    list.set("subdomain solver name", "RILUK");
    list.sublist("subdomain solver parameters")
      .set("fact: iluk level-of-fill", 1);
    factorization->setParameters(list);
    factorization->initialize();
    factorization->compute();
    return factorization;
  }
} // namespace auxfem
