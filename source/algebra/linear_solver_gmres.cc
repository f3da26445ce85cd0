#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/algebra/strut_condensation.h>
#include <auxfem/parameters/errors.h>

#include <Ifpack_Preconditioner.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include <AztecOO.h>
#include <Ifpack.h>

namespace auxfem
{
  namespace
  {
    /**
     * Directions GMRES keeps. Bending of slender struts against their
     * extension asks for some hundred iterations in statics, which a shorter
     * memory multiplies.
     */
    constexpr int n_directions = 200;

    /** Times GMRES goes on from where its own residual was too optimistic. */
    constexpr unsigned int n_refinements = 5;

    /** Whether every row has a diagonal to divide by, on all ranks. */
    bool has_diagonal(const Epetra_CrsMatrix &matrix)
    {
      Epetra_Vector diagonal(matrix.RowMap());
      matrix.ExtractDiagonalCopy(diagonal);
      int mine = 1, all = 1;
      for (int i = 0; i < diagonal.MyLength(); ++i)
        if (!std::isfinite(diagonal[i]) || diagonal[i] == 0)
          mine = 0;
      matrix.Comm().MinAll(&mine, &all, 1);
      return all == 1;
    }

    /**
     * Smoothed aggregation with the lattice's rigid-body motions as near null
     * space. Chebyshev smoothing does the same on any number of ranks.
     */
    std::unique_ptr<Epetra_Operator>
    make_multigrid(const Epetra_CrsMatrix                 &matrix,
                   const unsigned int                      block_size,
                   const std::vector<std::vector<double>> &rigid_body_modes)
    {
      std::vector<double> vectors;
      for (const std::vector<double> &mode : rigid_body_modes)
        vectors.insert(vectors.end(), mode.begin(), mode.end());
      // A rank without joints needs an address all the same.
      vectors.reserve(1);

      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      list.set("PDE equations", int(block_size));
      list.set("null space: type", "pre-computed");
      list.set("null space: dimension", int(rigid_body_modes.size()));
      list.set("null space: vectors", vectors.data());
      list.set("null space: add default vectors", false);
      list.set("eigen-analysis: type", "power-method");
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", 4);
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 1000);
      return std::make_unique<ML_Epetra::MultiLevelPreconditioner>(matrix,
                                                                   list);
    }

    /** nullptr if the incomplete factorization breaks down on any rank. */
    std::unique_ptr<Epetra_Operator>
    make_incomplete_factorization(Epetra_CrsMatrix &matrix)
    {
      const int                              one_layer = 1;
      std::unique_ptr<Ifpack_Preconditioner> factorization(
        Ifpack().Create("ILU", &matrix, one_layer));
      Teuchos::ParameterList list;
      list.set("fact: level-of-fill", 1);
      list.set("schwarz: reordering type", "rcm");
      factorization->SetParameters(list);
      int mine =
        factorization->Initialize() == 0 && factorization->Compute() == 0;
      int all = 1;
      matrix.Comm().MinAll(&mine, &all, 1);
      if (all == 0)
        return nullptr;
      return factorization;
    }

    class GmresMethod : public LinearSolverMethod
    {
    public:
      GmresMethod(const SolverParameters &parameters,
                  TangentMatrix          &matrix,
                  const LatticeModel     &model)
        : parameters(parameters)
        , numbering(model.numbering)
        , blocks(model)
        , modes(blocks.rigid_body_modes(model.mean_strut_length))
        , tangent(matrix)
        , length(model.mean_strut_length)
        , at_joints(blocks.map())
      {}

      bool factorize() override
      {
        preconditioner.reset();
        if (!condensation || condensed_version != tangent.version())
          {
            condensation.emplace(numbering, blocks, tangent, length);
            condensed_version = tangent.version();
          }
        if (!condensation->condense() || !has_diagonal(condensation->matrix()))
          return false;
        preconditioner = parameters.preconditioner == "ilu"
          ? make_incomplete_factorization(condensation->matrix())
          : make_multigrid(condensation->matrix(), blocks.size(), modes);
        return preconditioner != nullptr;
      }

      std::string solve(const Epetra_Vector &b, Epetra_Vector &x) override
      {
        Epetra_Vector g(condensation->reduce(b));
        double        size = 0;
        g.Norm2(&size);
        at_joints.PutScalar(0.);
        std::string failure;
        if (!std::isfinite(size))
          failure = "the right-hand side is not finite";
        else if (size > 0)
          failure = iterate(g, size);
        condensation->expand(at_joints, x);
        return failure;
      }

      unsigned long n_iterations() const override
      {
        return n_done;
      }

    private:
      std::string iterate(Epetra_Vector &g, const double size)
      {
        Epetra_CrsMatrix &matrix = condensation->matrix();
        AztecOO           gmres(&matrix, &at_joints, &g);
        gmres.SetAztecOption(AZ_solver, AZ_gmres);
        gmres.SetAztecOption(AZ_kspace,
                             std::min<int>(n_directions,
                                           parameters.maximum_iterations));
        gmres.SetAztecOption(AZ_conv, AZ_rhs);
        gmres.SetAztecOption(AZ_output, AZ_none);
        gmres.SetPrecOperator(preconditioner.get());

        Epetra_Vector residual(matrix.RowMap());
        double        error = size;
        unsigned int  n     = 0;
        for (unsigned int i = 0; i <= n_refinements; ++i)
          {
            gmres.Iterate(parameters.maximum_iterations - n,
                          parameters.tolerance);
            n += gmres.NumIters();
            n_done += gmres.NumIters();
            matrix.Multiply(false, at_joints, residual);
            residual.Update(1., g, -1.);
            residual.Norm2(&error);
            if (error <= std::max(parameters.tolerance * size, round_off()))
              return "";
            if (!std::isfinite(error) || n >= parameters.maximum_iterations)
              break;
          }
        return words_of_failure(error / size, n);
      }

      /** Residual that rounding leaves of any solution. */
      double round_off()
      {
        double largest = 0;
        at_joints.NormInf(&largest);
        return std::numeric_limits<double>::epsilon() *
          std::sqrt(at_joints.GlobalLength()) *
          condensation->matrix().NormInf() * largest;
      }

      std::string words_of_failure(const double       relative_residual,
                                   const unsigned int n) const
      {
        std::ostringstream words;
        words << "GMRES has come to a relative residual of "
              << relative_residual << " in " << n
              << " iterations (Solver/Tolerance = " << parameters.tolerance
              << ", Maximum iterations = " << parameters.maximum_iterations
              << ", Preconditioner = " << parameters.preconditioner
              << "; the direct solver, Type = auto, may serve better)";
        return words.str();
      }

      const SolverParameters                 parameters;
      const DofNumbering                    &numbering;
      const JointBlocks                      blocks;
      const std::vector<std::vector<double>> modes;
      TangentMatrix                         &tangent;
      const double                           length;
      /** Made for the pattern of this version. */
      std::optional<StrutCondensation> condensation;
      unsigned long                    condensed_version = 0;
      std::unique_ptr<Epetra_Operator> preconditioner;
      Epetra_Vector                    at_joints;
      unsigned long                    n_done = 0;
    };
  } // namespace

  std::unique_ptr<LinearSolverMethod>
  make_gmres_method(const SolverParameters &parameters,
                    TangentMatrix          &matrix,
                    const LatticeModel     &model)
  {
    if (model.numbering.n_multipliers() > 0)
      throw InputError(
        "Solver/Type = gmres: scenes with rigid parts or revolute hinges have "
        "forces as unknowns, whose equations have no diagonal to iterate on. "
        "Use `auto`, `klu` or `mumps`.");
    return std::make_unique<GmresMethod>(parameters, matrix, model);
  }
} // namespace auxfem
