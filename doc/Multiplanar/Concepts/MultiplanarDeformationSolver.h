/*!
\ingroup PkgMultiplanarConcepts
\cgalConcept

The concept `MultiplanarDeformationSolver` describes what the approximation needs in order to deform a mesh towards
planar clusters: one sparse linear least-squares problem, solved again and again for the same mesh with other planes,
other weights and from other positions.

The problem is that of Chen, Sitthi-amorn, Lan and Matusik, <em>Computing and Fabricating Multiplanar Models</em>,
Computer Graphics Forum 2013, section 3.1.2, equations 5 to 9, with the weights of `CGAL::Multiplanar::Deformation_weights`,
where the energy is written out. All models minimise the same energy: their results differ by rounding errors alone
(below 10<sup>-8</sup> of the diagonal for flattening weights up to 2000).

A model is move-constructible and need not be copyable. A model is used by one thread at a time; different objects may
be used by different threads at the same time.

\cgalHasModel `CGAL::Multiplanar::Ceres_deformation_solver`
\cgalHasModel `CGAL::Multiplanar::Cholmod_deformation_solver`
*/
class MultiplanarDeformationSolver
{
public:
  /// \name Creation
  /// @{

  /*!
  prepares the problem for a mesh.

  \param connectivity the combinatorics of the mesh. A reference is kept: it must outlive the solver.
  \param rest the original vertex positions v0, one a vertex. Copied.
  \param weights of the objectives. With `weights.smoothness == 0` the smoothness objective costs nothing.
  \param threads at most this many threads are used. The result does not depend on it, to the last bit.

  \pre `weights.is_valid()`
  \pre The mesh has unit bounding-box diagonal and its centre at the origin, up to a small factor: the weights are
       ratios of lengths to dimensionless numbers.
  \pre The surface area is positive. Single faces may be slivers or have no area at all.
  */
  MultiplanarDeformationSolver(const CGAL::Multiplanar::internal::Connectivity& connectivity,
                               const CGAL::Multiplanar::Points& rest,
                               const CGAL::Multiplanar::Deformation_weights& weights,
                               int threads);

  /// @}

  /// \name Operations
  /// @{

  /*!
  computes the vertex positions of least energy.

  \param current positions v' of the previous pass, with respect to which the transformation objective is formed.
  \param labels a label for each face, in `0 .. normals.size() - 1`. Labels without faces are allowed, and as many labels
         as faces.
  \param normals the unit normal of each label's plane. The faces of a label whose normal is the zero vector are not
         flattened.
  \param w_p flattening weight, not negative. It multiplies equation 6; its square enters the energy.
  \param similarity_scale multiplies each vertex's similarity weight; positive. Empty: 1 for all.
  \param target receives the positions. May be the same object as `current`.

  \return `false` if an argument is not finite or the factorisation failed (lack of memory); then `target` equals
          `current`, and the solver can be used again.
  */
  bool solve(const CGAL::Multiplanar::Points& current,
             const std::vector<int>& labels,
             const std::vector<CGAL::Multiplanar::Vector_3>& normals,
             double w_p,
             const std::vector<double>& similarity_scale,
             CGAL::Multiplanar::Points& target);

  /// @}
};
