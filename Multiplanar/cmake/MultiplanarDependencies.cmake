# What the headers need, found the same way in the source tree and after installation.
find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(Ceres 2.0 REQUIRED)
find_package(Threads REQUIRED)
find_package(CHOLMOD REQUIRED)
find_package(LAPACK REQUIRED)

# The interface target exists only in the source tree here; after installation it comes from MultiplanarTargets.
if(TARGET Multiplanar)
  target_link_libraries(Multiplanar INTERFACE CGAL::CGAL Eigen3::Eigen Ceres::ceres Threads::Threads CHOLMOD::CHOLMOD
    LAPACK::LAPACK ${CMAKE_DL_LIBS})
endif()
