/* Symmetric 3 x 3 matrices, as six numbers xx, yy, zz, xy, xz, yz. */
#ifndef TS_MATH_SYMMETRIC3_H
#define TS_MATH_SYMMETRIC3_H

/* Eigenvalues and, in the columns of v, eigenvectors; by Jacobi rotations (Golub & Van Loan, Matrix
 * Computations, 8.5). */
void ts_symmetric3_eigen(const double a[6], double value[3], double v[3][3]);
/* Solves A x = b; x is 0 along eigenvectors whose eigenvalue is less than 1e-12 of the largest. */
void ts_symmetric3_solve(const double a[6], const double b[3], double x[3]);

#endif
