#include <auxfem/algebra/strut_condensation.h>
#include <auxfem/parameters/errors.h>

#include <Epetra_SerialComm.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <map>

#include <Amesos.h>

namespace auxfem
{
  StrutCondensation::StrutCondensation(const DofNumbering &numbering,
                                       const JointBlocks  &blocks,
                                       TangentMatrix      &matrix,
                                       const double        length)
    : numbering(numbering)
    , blocks(blocks)
    , tangent(matrix)
    , length(length)
    , inner_index(numbering.n_local(), -1)
    , reduced(blocks.map())
    , prepared(numbering.owned_map())
  {
    collect_struts();
    if (!inner_unknowns.empty())
      make_inner_matrix();
  }

  bool StrutCondensation::condense()
  {
    int mine = 1, all = 1;
    if (!inner_unknowns.empty())
      {
        fill_inner_matrix();
        has_symbolic =
          has_symbolic || inner_solver->SymbolicFactorization() == 0;
        mine = has_symbolic && inner_solver->NumericFactorization() == 0;
      }
    numbering.communicator().MinAll(&mine, &all, 1);
    if (all == 0)
      return false;
    make_influence();
    make_joint_matrix();
    return true;
  }

  Epetra_CrsMatrix &StrutCondensation::matrix()
  {
    return *joint_matrix;
  }

  const Epetra_Vector &StrutCondensation::reduce(const Epetra_Vector &b)
  {
    Epetra_Vector remaining(b), image(numbering.owned_map());
    prepared.PutScalar(0.);
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      if (numbering.kind(i) == UnknownKind::prescribed)
        prepared[i] = b[i];
    tangent.matrix().Multiply(false, prepared, image);
    remaining.Update(-1., image, 1.);

    if (!inner_unknowns.empty())
      {
        Epetra_MultiVector of_inside(*inner_map, 1);
        for (unsigned int k = 0; k < inner_unknowns.size(); ++k)
          of_inside[0][k] = remaining[inner_unknowns[k]];
        solve_inside(of_inside);
        for (unsigned int k = 0; k < inner_unknowns.size(); ++k)
          prepared[inner_unknowns[k]] = of_inside[0][k];
      }
    tangent.matrix().Multiply(false, prepared, image);

    reduced.PutScalar(0.);
    for (int k = 0; k < reduced.MyLength(); ++k)
      {
        const int unknown = blocks.unknown(k);
        if (unknown >= 0 && is_free_at_joint(unknown))
          reduced[k] = scale(unknown) * (b[unknown] - image[unknown]);
      }
    return reduced;
  }

  void StrutCondensation::expand(const Epetra_Vector &z, Epetra_Vector &x) const
  {
    influence->Multiply(false, z, x);
    x.Update(1., prepared, -1.);
    for (int k = 0; k < z.MyLength(); ++k)
      {
        const int unknown = blocks.unknown(k);
        if (unknown >= 0 && is_free_at_joint(unknown))
          x[unknown] = scale(unknown) * z[k];
      }
  }

  bool StrutCondensation::is_free_at_joint(const int unknown) const
  {
    return blocks.row(unknown) >= 0 &&
      numbering.kind(unknown) != UnknownKind::prescribed;
  }

  double StrutCondensation::scale(const int unknown) const
  {
    return numbering.is_rotation(unknown) ? 1. / length : 1.;
  }

  void StrutCondensation::collect_struts()
  {
    std::map<unsigned int, Inside> by_strut;
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      if (blocks.strut(i) != invalid_index)
        {
          inner_index[i] = inner_unknowns.size();
          inner_unknowns.push_back(i);
          by_strut[blocks.strut(i)].unknowns.push_back(i);
        }
    for (auto &[strut, inside] : by_strut)
      {
        std::vector<int> &at_joints = inside.at_joints;
        for (const int unknown : inside.unknowns)
          {
            int     n = 0, *columns = nullptr;
            double *values = nullptr;
            tangent.matrix().ExtractMyRowView(unknown, n, values, columns);
            refuse_coupled_struts(strut, columns, n);
            std::copy_if(columns,
                         columns + n,
                         std::back_inserter(at_joints),
                         [this](const int c) { return is_free_at_joint(c); });
          }
        std::sort(at_joints.begin(), at_joints.end());
        at_joints.erase(std::unique(at_joints.begin(), at_joints.end()),
                        at_joints.end());
        struts.push_back(std::move(inside));
      }
  }

  void StrutCondensation::refuse_coupled_struts(const unsigned int strut,
                                                const int         *columns,
                                                const int          n) const
  {
    if (std::any_of(columns, columns + n, [&](const int column) {
          return blocks.strut(column) != invalid_index &&
            blocks.strut(column) != strut;
        }))
      throw InputError(
        "Solver/Type = gmres: something couples the insides of two struts, "
        "which are eliminated one by one. Use `auto`, `klu` or `mumps`.");
  }

  void StrutCondensation::make_inner_matrix()
  {
    inner_map    = std::make_unique<Epetra_Map>(int(inner_unknowns.size()),
                                             0,
                                             Epetra_SerialComm());
    inner_matrix = std::make_unique<Epetra_CrsMatrix>(Copy, *inner_map, 0);
    const std::vector<double> zeros(tangent.matrix().MaxNumEntries(), 0.);
    std::vector<int>          inner_columns;
    for (unsigned int k = 0; k < inner_unknowns.size(); ++k)
      {
        int     n = 0, *columns = nullptr;
        double *values = nullptr;
        tangent.matrix().ExtractMyRowView(inner_unknowns[k],
                                          n,
                                          values,
                                          columns);
        inner_columns.clear();
        for (int i = 0; i < n; ++i)
          if (inner_index[columns[i]] >= 0)
            inner_columns.push_back(inner_index[columns[i]]);
        inner_matrix->InsertGlobalValues(k,
                                         inner_columns.size(),
                                         zeros.data(),
                                         inner_columns.data());
      }
    inner_matrix->FillComplete();
    inner_problem.SetOperator(inner_matrix.get());
    inner_solver.reset(Amesos().Create("Amesos_Klu", inner_problem));
    Teuchos::ParameterList list;
    list.set("Refactorize", true);
    list.set("OutputLevel", 0);
    inner_solver->SetParameters(list);
  }

  void StrutCondensation::fill_inner_matrix()
  {
    for (unsigned int k = 0; k < inner_unknowns.size(); ++k)
      {
        int     n = 0, *columns = nullptr;
        double *values = nullptr;
        tangent.matrix().ExtractMyRowView(inner_unknowns[k],
                                          n,
                                          values,
                                          columns);
        for (int i = 0; i < n; ++i)
          if (inner_index[columns[i]] >= 0)
            inner_matrix->ReplaceGlobalValues(k,
                                              1,
                                              &values[i],
                                              &inner_index[columns[i]]);
      }
  }

  void StrutCondensation::solve_inside(Epetra_MultiVector &of_inside)
  {
    Epetra_MultiVector right_side(of_inside);
    inner_problem.SetRHS(&right_side);
    inner_problem.SetLHS(&of_inside);
    inner_solver->Solve();
  }

  void StrutCondensation::make_influence()
  {
    influence =
      std::make_unique<Epetra_CrsMatrix>(Copy, numbering.owned_map(), 0);
    std::size_t n_columns = 0;
    for (const Inside &inside : struts)
      n_columns = std::max(n_columns, inside.at_joints.size());
    if (n_columns > 0)
      {
        // No strut's inside acts on that of another, so column k of all of
        // them is found at once.
        Epetra_MultiVector of_inside(*inner_map, n_columns);
        for (const Inside &inside : struts)
          for (const int unknown : inside.unknowns)
            {
              int     n = 0, *columns = nullptr;
              double *values = nullptr;
              tangent.matrix().ExtractMyRowView(unknown, n, values, columns);
              for (int i = 0; i < n; ++i)
                if (is_free_at_joint(columns[i]))
                  {
                    const auto place =
                      std::lower_bound(inside.at_joints.begin(),
                                       inside.at_joints.end(),
                                       columns[i]);
                    of_inside[place - inside.at_joints.begin()]
                             [inner_index[unknown]] =
                               values[i] * scale(columns[i]);
                  }
            }
        solve_inside(of_inside);
        for (const Inside &inside : struts)
          {
            std::vector<int> rows;
            for (const int at_joint : inside.at_joints)
              rows.push_back(blocks.row(at_joint));
            std::vector<double> entries(rows.size());
            for (const int unknown : inside.unknowns)
              {
                for (unsigned int k = 0; k < rows.size(); ++k)
                  entries[k] = of_inside[k][inner_index[unknown]];
                influence->InsertGlobalValues(numbering.owned_map().GID(
                                                unknown),
                                              rows.size(),
                                              entries.data(),
                                              rows.data());
              }
          }
      }
    influence->FillComplete(blocks.map(), numbering.owned_map());
  }

  void StrutCondensation::make_joint_matrix()
  {
    const Epetra_CrsMatrix           *with_ghosts = influence.get();
    std::unique_ptr<Epetra_CrsMatrix> imported;
    if (numbering.n_ranks() > 1)
      {
        imported =
          std::make_unique<Epetra_CrsMatrix>(Copy, numbering.local_map(), 0);
        imported->Import(*influence, numbering.importer(), Insert);
        with_ghosts = imported.get();
      }

    joint_matrix = std::make_unique<Epetra_CrsMatrix>(Copy, blocks.map(), 0);
    MatrixRow of_influence, row;
    of_influence.columns.resize(influence->GlobalMaxNumEntries());
    of_influence.entries.resize(of_influence.columns.size());
    for (int k = 0; k < blocks.map().NumMyElements(); ++k)
      {
        const int unknown = blocks.unknown(k);
        if (unknown >= 0 && is_free_at_joint(unknown))
          joint_row(unknown, *with_ghosts, of_influence, row);
        else
          row = {{blocks.map().GID(k)}, {1.}};
        joint_matrix->InsertGlobalValues(blocks.map().GID(k),
                                         row.columns.size(),
                                         row.entries.data(),
                                         row.columns.data());
      }
    joint_matrix->FillComplete();
    joint_matrix->OptimizeStorage();
  }

  void StrutCondensation::joint_row(const int               unknown,
                                    const Epetra_CrsMatrix &with_ghosts,
                                    MatrixRow              &of_influence,
                                    MatrixRow              &row) const
  {
    std::map<int, double> entries;
    int                   n = 0, *columns = nullptr;
    double               *values = nullptr;
    tangent.matrix().ExtractMyRowView(unknown, n, values, columns);
    for (int i = 0; i < n; ++i)
      if (is_free_at_joint(columns[i]))
        entries[blocks.row(columns[i])] += values[i] * scale(columns[i]);
      else if (blocks.strut(columns[i]) != invalid_index)
        {
          int n_entries = 0;
          with_ghosts.ExtractGlobalRowCopy(numbering.local_map().GID(
                                             columns[i]),
                                           of_influence.columns.size(),
                                           n_entries,
                                           of_influence.entries.data(),
                                           of_influence.columns.data());
          for (int k = 0; k < n_entries; ++k)
            entries[of_influence.columns[k]] -=
              values[i] * of_influence.entries[k];
        }
    row.columns.clear();
    row.entries.clear();
    for (const auto &[column, value] : entries)
      {
        row.columns.push_back(column);
        row.entries.push_back(scale(unknown) * value);
      }
  }
} // namespace auxfem
