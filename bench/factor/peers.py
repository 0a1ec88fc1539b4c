"""Times of NumPy and SciPy, one thread, on inputs that bench_factor writes: peers.py FOLDER WORK

WORK radiance: the sum of equation (1) over FOLDER/lights (x y z r g b) at FOLDER/views (n v), for
the Cook-Torrance material of bench_factor; writes FOLDER/radiance. WORK lsmr or qmr N: N iterations
on the system in FOLDER, its rows of samples shuffled, as directions are drawn; with a third word
"ordered", as they lie there. Prints the least processor time in seconds; exits with 77 where they are
not installed.
"""

import os
import sys
import time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
try:
    import numpy as np
    import scipy.sparse as sparse
    import scipy.sparse.linalg as linalg
except ImportError:
    sys.exit(77)

folder, work = sys.argv[1], sys.argv[2]


def read(name, kind=np.float64):
    return np.fromfile(os.path.join(folder, name), dtype=kind)


def least_time(run, times):
    best = float("inf")
    for _ in range(times):
        start = time.process_time()
        run()
        best = min(best, time.process_time() - start)
    return best


def fresnel(c, eta):
    g = np.sqrt(eta * eta - 1.0 + c * c)
    a, b = (g - c) / (g + c), (c * (g + c) - 1.0) / (c * (g - c) + 1.0)
    return 0.5 * a * a * (1.0 + b * b)


def radiance_of(lights, views, weights, m=0.2, diffuse=0.3, specular=0.7, f0=0.04):
    """Cook-Torrance, constant pi1981, for a block of views: the arrays stay in the cache."""
    eta = (1.0 + np.sqrt(f0)) / (1.0 - np.sqrt(f0))
    n, v = views[:, :3], views[:, 3:]
    nl, lv = n @ lights.T, v @ lights.T
    nv = np.sum(n * v, axis=1)[:, None]
    vh = np.sqrt(np.maximum(0.5 * (1.0 + lv), 1e-300))
    nh = (nl + nv) / (2.0 * vh)
    square = np.maximum(nh * nh, 1e-300)
    d = np.exp((1.0 - 1.0 / square) / (m * m)) / (m * m * square * square)
    g = np.minimum(1.0, 2.0 * nh / vh * np.minimum(nv, nl))
    f = diffuse / np.pi + specular / np.pi * fresnel(vh, eta) * d * g / (nl * nv)
    return np.where(nl > 0.0, f * nl, 0.0) @ weights


def all_radiances():
    table, views = read("lights").reshape(-1, 6), read("views").reshape(-1, 6)
    lights, weights = np.ascontiguousarray(table[:, :3]), np.ascontiguousarray(table[:, 3:])
    return np.concatenate(
        [radiance_of(lights, views[i:i + 16], weights) for i in range(0, len(views), 16)])


def system():
    starts, columns = read("starts", np.uint64).astype(np.int32), read("columns", np.int32)
    width = int(read("width", np.uint64)[0])
    b = read("right_side")
    a = sparse.csr_matrix((read("values"), columns, starts), (len(b), width))
    if sys.argv[4:] == ["ordered"]:
        return a, b
    order, samples = np.arange(len(b)), int(read("samples", np.uint64)[0])
    np.random.default_rng(1).shuffle(order[:samples])
    return a[order], b[order]


if work == "radiance":
    with np.errstate(all="ignore"):
        print(least_time(lambda: all_radiances().tofile(os.path.join(folder, "radiance")), 3))
else:
    a, b = system()
    count = int(sys.argv[3])
    if work == "lsmr":
        run = lambda: linalg.lsmr(a, b, atol=0.0, btol=0.0, conlim=0.0, maxiter=count)
    else:
        transposed, right = a.T.tocsr(), a.T @ b
        both = lambda x: transposed @ (a @ x)
        square = linalg.LinearOperator((a.shape[1],) * 2, matvec=both, rmatvec=both)
        run = lambda: linalg.qmr(square, right, tol=0.0, atol=0.0, maxiter=count)
    print(least_time(run, 3))
