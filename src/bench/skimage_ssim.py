"""SSIM by scikit-image of two raw float32 images: skimage_ssim.py WIDTH HEIGHT TRUTH TEST [RUNS].

Prints the value, computed in double precision; with RUNS, then the least wall-clock and the least processor seconds
in double and in single precision, a line each. Exit code 77 without scikit-image."""
import sys
import time

try:
    import numpy
    from skimage.metrics import structural_similarity
except ImportError as missing:
    print(missing, file=sys.stderr)
    sys.exit(77)

width, height = int(sys.argv[1]), int(sys.argv[2])
single = [numpy.fromfile(path, dtype="<f4").reshape(height, width) for path in sys.argv[3:5]]
double = [image.astype(float) for image in single]


def ssim(pair):
    return structural_similarity(*pair, gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1)


def seconds(pair):
    wall, processor = time.perf_counter(), time.process_time()
    ssim(pair)
    return time.perf_counter() - wall, time.process_time() - processor


print("%.15g" % ssim(double))
if len(sys.argv) > 5:
    for pair in (double, single):
        runs = [seconds(pair) for _ in range(int(sys.argv[5]))]
        print("%.6f %.6f" % tuple(map(min, zip(*runs))))
