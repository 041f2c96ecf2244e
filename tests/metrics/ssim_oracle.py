"""SSIM by scikit-image of two raw float32 images: ssim_oracle.py WIDTH HEIGHT TRUTH TEST. Exit code 77 without it."""
import sys

try:
    import numpy
    from skimage.metrics import structural_similarity
except ImportError as missing:
    print(missing, file=sys.stderr)
    sys.exit(77)

width, height = int(sys.argv[1]), int(sys.argv[2])
truth, test = (numpy.fromfile(path, dtype="<f4").astype(float).reshape(height, width) for path in sys.argv[3:5])
print("%.15g" % structural_similarity(truth, test, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
                                      data_range=1))
